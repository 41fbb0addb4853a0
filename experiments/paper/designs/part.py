"""``figure=designs``: inverse design of one robot for many targets, and of many robots."""

from collections.abc import Mapping, Sequence
from functools import partial
from typing import Any

import numpy as np

from snapjump.declare.members import member_class
from snapjump.run.studies.base import Cell, Done, Row, column

from ...compositions import composed, groups_at, simulation_at
from ...inverse_benchmark.cases import Case, case_rows
from ...inverse_benchmark.methods import LENGTH_MM, PAPER
from ..base import Found, Part, Statement, weakest
from ..cells import shipped_forward, shipped_inputs
from ..limits import judged
from ..settings import BASELINE, TIERS
from ..words import Words
from .figure import draw_flights, draw_misses

WORDS = Words(__file__)
MASS_BAR, MU = BASELINE[2:]

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


class Designs(Part):
    """A cell for each group of targets and each method."""

    name = "designs"
    title = "Inverse designs"

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
        """Designs of one method for the cases of one group."""
        base, method = composed(inputs["groups"]), member_class("inverse", inputs["method"])()
        cases = [Case(*values) for values in inputs["cases"]]
        judges = {tier: simulation_at(inputs["groups"], tier) for tier in inputs["tiers"]}
        return case_rows(base, shipped_forward(), method, cases, judges, inputs["seed"])

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
            "designs": partial(draw_flights, shown),
            "designs_misses": partial(draw_misses, misses),
        }
        tables = {"designs_methods": lines, "designs": [design_line(row) for row in misses[SHOWN]]}
        return Found(
            WORDS.section(self.title, figures, tables, **told(misses)),
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
    learned = [lines[name] for name in LEARNED]
    return WORDS.statement(
        "millimetres",
        came,
        learned=learned,
        methods=WORDS.each("misses of a method", lines.values()),
        at_paper=WORDS.each("misses at paper", learned, " and "),
        theirs=PAPER[0],
        off=off,
    )


def told(methods: Mapping[str, Sequence[Row]]) -> dict[str, Any]:
    """What the text says of the designs."""
    designs = methods[SHOWN]
    misses = column(designs, "miss_standard_mm")
    far = designs[int(np.nanargmax(misses))]
    pair = [row for row in designs if row["robot"] in ("R4", "R5")]
    return {
        "one": len(ONE_ROBOT),
        "many": len(MANY_ROBOTS),
        "mass_bar": MASS_BAR,
        "mu": MU,
        "reachable": sum(bool(row["reachable"]) for row in designs),
        "targets": len(designs),
        "median_mm": np.nanmedian(misses),
        "far": far,
        "share": 100 * np.nanmax(misses) / (LENGTH_MM * far["target_y_bar"]),
        "pair": pair,
        "controls": WORDS.each("design", pair, " and "),
        "physics": line("physics", methods["physics"]),
    }


def apart(methods: Mapping[str, Sequence[Row]], tier: str) -> float:
    """The largest difference (mm) of a miss at a tier from that at standard."""
    rows = [row for found in methods.values() for row in found]
    own, other = (column(rows, f"miss_{one}_mm") for one in ("standard", tier))
    return float(np.nanmax(np.abs(other - own)))
