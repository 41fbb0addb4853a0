"""``figure=designs``: inverse design of one robot for many targets, and of many robots."""

from collections.abc import Mapping, Sequence
from functools import partial
from typing import Any, NamedTuple

import numpy as np

from experiments.compositions import composed
from experiments.paper.base import Found, Part, Statement, weakest
from experiments.paper.cells import shipped_forward, shipped_inputs
from experiments.paper.designs import words
from experiments.paper.designs.figure import draw_flights, draw_misses
from experiments.paper.limits import judged
from experiments.paper.settings import BASELINE, TIERS, groups_at, simulation_at
from snapjump.batch import simulate_designs, variant
from snapjump.declare.members import member_class
from snapjump.run.studies.base import Cell, Done, Figure, Row, Section, Table, column
from snapjump.targets.answer import answer
from snapjump.targets.design import problem_of
from snapjump.targets.warm_up import warm_up

MASS_BAR, MU = BASELINE[2:]


class Case(NamedTuple):
    """A robot on a ground, and where it is to jump: the apex x, y in L."""

    label: str
    mass_bar: float
    mu: float
    x_bar: float
    y_bar: float


ONE_ROBOT = tuple(
    Case(f"{row}{column}", MASS_BAR, MU, x, y)
    for row, y in zip("ABC", (20.0, 16.0, 12.0), strict=True)
    for column, x in zip("123", (2.0, 3.5, 5.0), strict=True)
)
# The fourth and the fifth share their target.
MANY_ROBOTS = (
    Case("R1", 0.35, 0.5, 10.0, 40.0),
    Case("R2", 0.4, 0.3, 4.0, 45.0),
    Case("R3", 0.5, 0.3, 7.0, 30.0),
    Case("R4", 0.5, 0.15, 3.0, 22.0),
    Case("R5", 0.768, 0.45, 3.0, 22.0),
    Case("R6", 0.9, 0.6, 7.0, 14.0),
    Case("R7", 1.2, 0.2, 2.0, 13.0),
    Case("R8", 2.0, 0.3, 1.5, 8.0),
)
GROUPS: dict[str, tuple[Case, ...]] = {"one robot": ONE_ROBOT, "many robots": MANY_ROBOTS}
LEARNED = ("adam", "gauss_newton")  # that ask the forward model alone
METHODS = (*LEARNED, "physics")
SHOWN = "gauss_newton"  # whose flights the figure has: a design by the forward model alone
CONVERGED = ("standard", "reference")
LIFT_OFF = ("liftoff_x_bar", "liftoff_y_bar", "liftoff_vx_m_s")


class Designs(Part):
    """A cell for each group of targets and each method."""

    name = "designs"
    title = words.TITLE

    def plan(self, groups: Mapping[str, Any], seed: int) -> Sequence[Cell]:
        """Targets by methods."""
        standard = groups_at(groups, "standard")
        shared = {**shipped_inputs(standard), "groups": standard, "seed": seed, "tiers": [*TIERS]}
        return [
            Cell(
                f"{group}, {method}",
                {**shared, "group": group, "method": method, "cases": [list(one) for one in cases]},
            )
            for group, cases in GROUPS.items()
            for method in METHODS
        ]

    def compute(self, inputs: Mapping[str, Any]) -> list[Row]:
        """A row for each case: its design, what the forward model and each tier say of it (misses
        in mm), its lift-off at the first of them, time and simulations of the search."""
        base, forward = composed(inputs["groups"]), shipped_forward()
        method = member_class("inverse", inputs["method"])()
        warm_up(base, forward, method)
        cases = [Case(*values) for values in inputs["cases"]]
        targets = np.array([(case.x_bar, case.y_bar) for case in cases])
        rows: list[Row] = []
        designs = np.zeros((len(cases), 4))
        for k, case in enumerate(cases):
            robot = variant(base, (*BASELINE[:2], case.mass_bar, case.mu))
            problem = problem_of(robot, targets[k], forward, forward, inputs["seed"])
            found = answer(problem, method)
            designs[k] = problem.designs(found.solutions[0].controls[None, :])[0]
            rows.append(
                {
                    "robot": case.label,
                    "mass_bar": case.mass_bar,
                    "mu": case.mu,
                    "target_x_bar": case.x_bar,
                    "target_y_bar": case.y_bar,
                    "delta_alpha_rad": float(designs[k, 0]),
                    "epsilon": float(designs[k, 1]),
                    "reachable": found.reachable,
                    "solutions": len(found.solutions),
                    "seconds": found.seconds,
                    "simulations": found.simulations,
                }
            )
        add_places(rows, "predicted", forward.predict(designs))
        length_mm = 1e3 * base.robot.length_m
        for tier in inputs["tiers"]:
            simulation = simulation_at(inputs["groups"], tier)
            batch = simulate_designs(simulation, designs, threads=2, lanes=8)
            add_places(rows, tier, batch.apexes)
            for row, miss in zip(rows, np.hypot(*(batch.apexes - targets).T), strict=True):
                row[f"miss_{tier}_mm"] = float(length_mm * miss)
            if tier == inputs["tiers"][0]:
                for row, left in zip(rows, batch.rows(*LIFT_OFF), strict=True):
                    row |= left
        return rows

    def judge(self, done: Mapping[str, Done]) -> Found:
        """Flights, misses, all designs, one statement."""
        rows = [
            {"group": one.cell.inputs["group"], "method": one.cell.inputs["method"], **row}
            for one in done.values()
            for row in one.rows
        ]
        misses = {method: [row for row in rows if row["method"] == method] for method in METHODS}
        shown = {group: [row for row in misses[SHOWN] if row["group"] == group] for group in GROUPS}
        lines = [line(method, found) for method, found in misses.items()]
        figures = {
            "designs": Figure(words.FLIGHTS, partial(draw_flights, shown)),
            "designs_misses": Figure(words.MISSES, partial(draw_misses, misses)),
        }
        tables = {
            "designs_methods": Table("Misses in mm at L = 20 mm", lines),
            "designs": Table(
                f"The designs of the figure, by `{SHOWN}`", [design_line(r) for r in misses[SHOWN]]
            ),
        }
        return Found(
            Section(words.TITLE, words.told(misses, GROUPS), figures, tables),
            [millimetres(misses)],
            {
                f"designs_{line['method']}_{key}": line[source]
                for line in lines
                for key, source in (
                    ("mean_mm", "mean at standard"),
                    ("mean_mm_reference", "mean at reference"),
                    ("max_mm", "max at standard"),
                    ("seconds", "seconds, median"),
                )
            },
        )


def add_places(rows: list[Row], name: str, apexes: Any) -> None:
    """Both coordinates (N, 2) of an apex in each row."""
    for row, (x, y) in zip(rows, apexes.tolist(), strict=True):
        row[f"{name}_x_bar"], row[f"{name}_y_bar"] = x, y


def line(method: str, rows: Sequence[Row]) -> Row:
    """A method's misses at all tiers and its costs."""
    found: Row = {"method": method, "targets": len(rows)}
    misses = {tier: column(rows, f"miss_{tier}_mm") for tier in TIERS}
    for tier, one in misses.items():
        for word, value in (("mean", np.nanmean), ("std", np.nanstd), ("max", np.nanmax)):
            found[f"{word} at {tier}"] = float(value(one))
    return found | {
        "failed": int(sum(np.isnan(one).sum() for one in misses.values())),
        "seconds, median": float(np.median(column(rows, "seconds"))),
        "simulations, mean": float(column(rows, "simulations").mean()),
    }


def design_line(row: Row) -> Row:
    """A design as a line of the long table."""

    def place(name: str) -> str:
        x, y = row[f"{name}_x_bar"], row[f"{name}_y_bar"]
        return "none" if x is None or y is None else f"({x:.3f}, {y:.3f})"

    return {
        "robot": row["robot"],
        "m̄": row["mass_bar"],
        "μ": row["mu"],
        "target (L)": place("target"),
        "method": row["method"],
        "Δα (rad)": row["delta_alpha_rad"],
        "ε": row["epsilon"],
        "predicted apex (L)": place("predicted"),
        "simulated apex (L)": place("standard"),
        "miss (mm)": row["miss_standard_mm"],
        "at reference (mm)": row["miss_reference_mm"],
        "time (s)": row["seconds"],
        "simulations": row["simulations"],
    }


def millimetres(methods: Mapping[str, Sequence[Row]]) -> Statement:
    """The statement about accuracy. A design that does not jump is a miss of no size: it counts
    as the largest, and not in the mean."""
    misses = [column(methods[name], f"miss_{tier}_mm") for name in LEARNED for tier in CONVERGED]
    came = weakest(
        judged("designs.millimetres.mean", *(float(np.nanmean(one)) for one in misses)),
        judged(
            "designs.millimetres.largest",
            *(float(np.where(np.isnan(one), np.inf, one).max()) for one in misses),
        ),
    )
    lines = {name: line(name, rows) for name, rows in methods.items()}
    off = {tier: apart(methods, tier) for tier in ("reference", "paper")}
    return words.millimetres(lines, LEARNED, off).judged("designs.millimetres", came)


def apart(methods: Mapping[str, Sequence[Row]], tier: str) -> float:
    """The largest difference (mm) of a miss at a tier from that at standard."""
    rows = [row for found in methods.values() for row in found]
    own, other = (column(rows, f"miss_{one}_mm") for one in ("standard", tier))
    return float(np.nanmax(np.abs(other - own)))
