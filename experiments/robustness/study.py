"""``python run.py task=robustness``: random designs, random nonsense, and what becomes of each."""

import math
from collections.abc import Mapping, Sequence
from functools import partial
from itertools import chain
from typing import Any

import numpy as np

from snapjump.run.studies.base import REFUSED, Cell, Conclusion, Done, Figure, Row, Table
from snapjump.run.studies.study import Study
from snapjump.scenes.jump_outputs import ENDED
from snapjump.tiers import TIERS

from ..designs import COLUMNS
from ..stability.jumps import by_status, jump_rows
from ..stability.rules import RULES, broken
from ..tradeoff.tiers import base_at
from .figures import draw_designs
from .invalid import configuration_row, invalid_configurations

TIER = "draft"
# delta_alpha (rad), epsilon, mass_bar, mu: the paper's ranges, twice as wide about their middle,
# cut where a beam would not buckle, a robot be lighter than its beam, and friction negative.
LOW = (-0.08, 0.001, 0.01, 0.0)
HIGH = (0.28, 0.4, 2.85, 0.85)
# The statics of an epsilon take longer than a jump: designs share so many.
EPSILONS = 256
PART = 1000  # designs of a cell
SLOPING = 10  # of so many designs one more is on a slope
STEEPEST = 0.9  # of the slopes on which friction holds the robot
MOST_ITERATIONS = 2e5
DESIGNS, CONFIGURATIONS = (10_000, 100_000), (500, 5_000)  # quick, full


SLOPES = "designs on slopes"


class Robustness(Study):
    """Counts by status over ranges twice as wide as the paper's; invalid configurations."""

    keys = ()

    options = ("designs", "configurations")
    scene = "jump"
    sources = (
        "experiments.robustness.study",
        "experiments.robustness.invalid",
        "experiments.stability.jumps",
    )

    def plan(self, config: Mapping[str, Any]) -> list[Cell]:
        base = base_at(config, TIER)
        designs = self.count("designs", DESIGNS, 1, 1_000_000)
        configurations = self.count("configurations", CONFIGURATIONS, 1, 100_000)
        shared = {"seed": int(config["seed"])}
        cells = [Cell("configurations", {**shared, "count": configurations})]
        for first in range(0, designs, PART):
            count = min(PART, designs - first)
            inputs = {**shared, "groups": base, "first": first, "count": count}
            cells.append(Cell(f"designs {first} to {first + count - 1}", inputs))
        sloping = designs // SLOPING
        if sloping:
            inputs = {**shared, "groups": base, "first": designs, "count": sloping}
            cells.append(Cell(SLOPES, {**inputs, "steepest": STEEPEST}))
        return cells

    def compute(self, cell: Cell) -> list[Row]:
        inputs = cell.inputs
        if cell.name == "configurations":
            return [
                *map(configuration_row, invalid_configurations(inputs["count"], inputs["seed"]))
            ]
        designs = random_designs(inputs["count"], (inputs["seed"], inputs["first"]))
        if cell.name == SLOPES:
            designs = on_slopes(designs, inputs["steepest"], inputs["seed"])
        point = {"across": "", "up": "", "groups": inputs["groups"]}
        rows = jump_rows([point], designs, MOST_ITERATIONS)
        return [
            dict(zip((*COLUMNS, "slope_rad"), designs[row["design"]], strict=False))
            | {k: v for k, v in row.items() if k not in ("across", "up", "design")}
            for row in rows
        ]

    def conclude(self, done: Mapping[str, Done]) -> Conclusion:
        configurations = done["configurations"].rows
        on_level = [cell.rows for name, cell in done.items()
                    if name not in ("configurations", SLOPES)]  # fmt: skip
        rows, sloping = [*chain(*on_level)], done[SLOPES].rows if SLOPES in done else []
        counts, tilted = (dict(by_status(some).most_common()) for some in (rows, sloping))
        promise = TIERS[TIER].promise_percent
        violations = [
            {"rule": rule, **row}
            for row in (*rows, *sloping)
            for rule in broken(row, MOST_ITERATIONS, promise, "logbarrier")
        ]
        wrong = [row for row in configurations if row["outcome"] != REFUSED]
        summary = {
            "designs": len(rows),
            **{f"status_{name}": count for name, count in counts.items()},
            "designs_on_slopes": len(sloping),
            **{f"status_on_slopes_{name}": count for name, count in tilted.items()},
            **{f"broken_{r}": sum(v["rule"] == r for v in violations) for r in RULES},
            **figures_of(rows),
            "configurations": len(configurations),
            "configurations_refused": len(configurations) - len(wrong),
        }
        return Conclusion(
            title="Robustness",
            findings=[
                f"{len(rows)} random designs: "
                + ", ".join(f"{n} {name}" for name, n in counts.items())
                + "; " + ", ".join(f"{summary[f'broken_{rule}']} x {text}"
                                   for rule, text in RULES.items() if rule != "silent") + ".",
                f"{len(sloping)} more, on slopes of up to {STEEPEST:g} of the steepest on which "
                "friction holds the robot: "
                + (", ".join(f"{n} {name}" for name, n in tilted.items()) or "none")
                + ". Tables of failures and broken rules have both.",
                f"The slowest took {summary['most_newton_iterations']:.0f} Newton iterations (the "
                f"median {summary['median_newton_iterations']:.0f}); the smallest gap was "
                f"{summary['smallest_gap_m']:.2g} m; {summary['within_tier_percent']:.3g} % of the "
                "jumps say of themselves that they are within their tier.",
                f"{summary['configurations_refused']} of {len(configurations)} invalid "
                "configurations were refused in one line that names the key.",
            ],
            tables={
                "statuses": Table("Designs by status", [counts]),
                "failures": Table("Designs that failed", [
                    failure(row) for row in (*rows, *sloping) if row["status"] not in ENDED][:50]),
                "violations": Table("Rules that were broken", violations[:50]),
                "configurations": Table("Invalid configurations by kind",
                                        kinds(configurations)),
                "not_refused": Table("Configurations that were not refused as they should be",
                                     wrong),
            },
            figures={
                "designs": Figure("Random designs by status, and what they cost",
                                  partial(draw_designs, rows)),
            },
            summary=summary,
        )  # fmt: skip


def random_designs(count: int, seed: Sequence[int]) -> list[tuple[float, ...]]:
    """Random designs (delta_alpha, epsilon, mass_bar, mu), uniform in their ranges."""
    random = np.random.default_rng(list(seed))
    values = random.uniform(LOW, HIGH, (count, 4))
    grid = np.linspace(LOW[1], HIGH[1], EPSILONS)
    values[:, 1] = grid[random.integers(EPSILONS, size=count)]
    return [tuple(float(v) for v in row) for row in values]


def on_slopes(
    designs: Sequence[Sequence[float]], steepest: float, seed: int
) -> list[tuple[float, ...]]:
    """Designs with a slope (rad) besides, uniform up to a share of the steepest, either way, on
    which their friction holds the robot."""
    shares = np.random.default_rng(seed).uniform(-steepest, steepest, len(designs))
    return [
        (*row, share * math.atan(row[3]))
        for row, share in zip(designs, shares.tolist(), strict=True)
    ]


def failure(row: Row) -> Row:
    """The columns of the table of failures."""
    return {
        key: row[key]
        for key in (*COLUMNS, "slope_rad", "status", "newton_iterations")
        if key in row
    }


def kinds(configurations: Sequence[Row]) -> list[Row]:
    """Counts by kind and outcome."""
    found: dict[str, Row] = {}
    for row in configurations:
        counts = found.setdefault(row["kind"], {"kind": row["kind"], "all": 0})
        counts["all"] += 1
        counts[row["outcome"]] = counts.get(row["outcome"], 0) + 1
    return list(found.values())


def figures_of(rows: Sequence[Row]) -> dict[str, float]:
    """Extremes over all jumps."""
    ran = [row for row in rows if "newton_iterations" in row]
    iterations = np.array([row["newton_iterations"] for row in ran])
    gaps = [row["min_gap_m"] for row in ran if row["min_gap_m"] is not None]
    return {
        "most_newton_iterations": float(iterations.max()),
        "median_newton_iterations": float(np.median(iterations)),
        "smallest_gap_m": float(min(gaps)),
        "within_tier_percent": 100.0 * float(np.mean([row["within_tier"] is True for row in ran])),
        "longest_part_s": float(max(row["seconds"] for row in ran)),
    }
