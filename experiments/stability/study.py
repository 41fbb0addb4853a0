"""``python run.py task=stability``: the extremes, and whether every result says how good it is."""

from collections.abc import Mapping, Sequence
from functools import partial
from typing import Any

from snapjump.run.studies.base import OK, Cell, Conclusion, Done, Figure, Row, Table
from snapjump.run.studies.study import Study
from snapjump.scenes.jump_outputs import ENDED
from snapjump.tiers import TIERS

from ..compositions import Groups, changed
from ..designs import spread_designs
from ..tradeoff.tiers import base_at, tier_groups
from .axes import DESIGNS, INTEGRATORS, Map, maps
from .calibration import TIGHT, level_row, levels, overall
from .figures import draw_calibration, draw_map
from .jumps import by_status, jump_rows
from .physics import Check, checks
from .rules import RULES, broken, with_truth

TIER = "draft"
MOST_ITERATIONS = 2e5  # of a jump of the maps
TRUTH_ITERATIONS = 3e5
# The truth of the maps: finer than any promise that is tested against it.
TRUTH = {"discretization": {"elements": 120}, "stepping": TIGHT, "integrator": {"name": "tr_bdf2"}}
CALIBRATION_DESIGNS = (32, 96)  # quick, full
SHARED_TRUTH = "truth of the designs"
SPREAD_TRUTH = "truth of the calibration"


class Stability(Study):
    """Maps of status and error over the extremes; calibration of the error estimate."""

    keys = ()

    options = ("designs",)
    scene = "jump"
    sources = (
        "experiments.stability.axes",
        "experiments.stability.jumps",
        "experiments.stability.calibration",
    )

    def plan(self, config: Mapping[str, Any]) -> list[Cell]:
        """The maps, the truth that goes with each, and the levels of the calibration."""
        base = base_at(config, TIER)
        count = self.count("designs", CALIBRATION_DESIGNS, 2, 4096)
        spread = spread_designs(count, config["seed"])
        self.maps = maps(self.full)
        self.levels = levels(base, INTEGRATORS)
        found = [
            jumps(SHARED_TRUTH, [at(changed(base, TRUTH))], DESIGNS, TRUTH_ITERATIONS),
            jumps(SPREAD_TRUTH, [at(tier_groups(base, "reference"))], spread, TRUTH_ITERATIONS),
        ]
        for one in self.maps:
            found += map_cells(one, base)
        for kind, by_level in self.levels.items():
            points = [at(groups, level) for level, groups in by_level.items()]
            found.append(jumps(kind, points, spread, TRUTH_ITERATIONS))
        return found

    def compute(self, cell: Cell) -> list[Row]:
        inputs = cell.inputs
        return jump_rows(inputs["points"], inputs["designs"], inputs["most_iterations"])

    def conclude(self, done: Mapping[str, Done]) -> Conclusion:
        found = {one.name: map_rows(one, done) for one in self.maps}
        violations = [
            {"map": name, "rule": rule, **shortened(row)}
            for name, rows in found.items()
            for row in rows
            for rule in broken(row, MOST_ITERATIONS, TIERS[TIER].promise_percent, law_of(name, row))
        ]
        expected = checks(found)
        truth = done[SPREAD_TRUTH].rows
        by_kind: dict[str, list[Row]] = {}
        by_level: dict[tuple[str, str], list[Row]] = {}
        for kind, by_name in self.levels.items():
            rows = with_truth(done[kind].rows, truth, own=False) if done[kind].status == OK else []
            by_kind[kind] = rows
            for level in by_name:
                by_level[kind, level] = [row for row in rows if row["up"] == level]
        figures = overall(by_level)
        jumps_in_all = sum(len(rows) for rows in found.values())
        return Conclusion(
            title="Stability at the extremes",
            findings=[
                rules_kept(violations, jumps_in_all),
                physics_kept(expected),
                estimate_kept(figures),
            ],
            tables={
                "physics": Table("What physics says, and what came out",
                                 [check.row() for check in expected]),
                "violations": Table("Rules that were broken", violations),
                "statuses": Table("Jumps by status", [
                    {"map": name, **shares(rows)} for name, rows in found.items()]),
                "estimate": Table("True and estimated errors, by composition and level",
                                  [level_row(*k, rows) for k, rows in by_level.items()]),
            },
            figures={
                "calibration": Figure(
                    "The error that a jump estimates of itself against its true error",
                    partial(draw_calibration, by_kind),
                ),
                **{
                    one.name: Figure(
                        f"{one.up.label} against {one.across.label}: status and error",
                        partial(draw_map, one, found[one.name]),
                    )
                    for one in self.maps
                },
            },
            summary={
                "map_jumps": jumps_in_all,
                **{f"broken_{rule}": sum(v["rule"] == rule for v in violations) for rule in RULES},
                "physics_checks": len(expected),
                "physics_broken": sum(not check.holds for check in expected),
                **figures,
            },
        )  # fmt: skip


def map_cells(one: Map, base: Groups) -> list[Cell]:
    """The cells of a map, each followed by the one with its truth, where it has its own."""
    kinds: list[tuple[str, Row, float]] = [("", {}, MOST_ITERATIONS)]
    if one.own_truth:
        kinds.append((", truth", TRUTH, TRUTH_ITERATIONS))
    found = []
    for name, ups in one.parts.items():
        for suffix, change, most in kinds:
            points = [
                at(changed(one.groups(base, across, up), change), up, across)
                for up in ups
                for across in one.across.values
            ]
            found.append(jumps(name + suffix, points, one.designs, most))
    return found


def map_rows(one: Map, done: Mapping[str, Done]) -> list[Row]:
    """The rows of a map with their true errors."""
    rows: list[Row] = []
    for name in one.parts:
        truth = done[f"{name}, truth" if one.own_truth else SHARED_TRUTH]
        rows += with_truth(done[name].rows, truth.rows, one.own_truth)
    return rows


def jumps(
    name: str, points: Sequence[Row], designs: Sequence[Sequence[float]], most_iterations: float
) -> Cell:
    """A cell of jumps."""
    listed = [list(design) for design in designs]
    return Cell(name, {"points": points, "designs": listed, "most_iterations": most_iterations})


def at(groups: Groups, up: Any = "", across: Any = "") -> Row:
    """A point: of no map, unless it says where."""
    return {"across": across, "up": up, "groups": groups}


def law_of(name: str, row: Row) -> str:
    """The contact law of a row of a map."""
    return str(row["up"]) if name == "law" else "logbarrier"


def shares(rows: Sequence[Row]) -> dict[str, int]:
    """Counts by status, the usual ones first."""
    counts = by_status(rows)
    return {name: counts[name] for name in (*ENDED, *sorted(set(counts) - set(ENDED)))}


def shortened(row: Row) -> Row:
    """The columns of the table of violations."""
    keys = ("across", "up", "design", "status", "x_bar", "y_bar", "true_error_percent",
            "x_error_estimate_percent", "min_gap_m", "newton_iterations", "seconds")  # fmt: skip
    return {key: row[key] for key in keys if key in row}


def rules_kept(violations: Sequence[Row], jumps_in_all: int) -> str:
    """The hard rules in a sentence."""
    counts = [
        f"{sum(v['rule'] == rule for v in violations)} x {text}" for rule, text in RULES.items()
    ]
    return f"Over {jumps_in_all} jumps of the maps: {'; '.join(counts)}."


def physics_kept(expected: Sequence[Check]) -> str:
    """The expectations in a sentence."""
    lost = [check.name for check in expected if not check.holds]
    text = f"{len(expected) - len(lost)} of {len(expected)} expectations of physics are met"
    return f"{text}; not met: {', '.join(lost)}." if lost else f"{text}."


def estimate_kept(figures: Mapping[str, float]) -> str:
    """The calibration in a sentence."""
    return (
        f"Over {figures['calibration_jumps']} jumps of the calibration the true error is below "
        f"twice the estimate in {100.0 * figures['x_covered_share']:.3g} % (x) and "
        f"{100.0 * figures['y_covered_share']:.3g} % (y); the estimate of x is "
        f"{figures['x_estimate_over_true_median']:.2g} times the true error in the median, and "
        f"their logarithms correlate with {figures['log_correlation_x']:.2f}."
    )
