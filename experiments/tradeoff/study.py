"""``python run.py task=tradeoff``: what accuracy costs, whatever is composed."""

from collections.abc import Mapping
from functools import partial
from typing import Any

import numpy as np

from snapjump.checks import ParameterError
from snapjump.run.studies.base import OK, Cell, Conclusion, Done, Figure, Row, Table
from snapjump.run.studies.study import Study
from snapjump.tiers import TIERS

from ..compositions import changed, composed, groups_of
from ..designs import SWEEP
from ..errors import percentile, relative_errors
from .batches import batch_cell, jump_rows
from .curves import Curve, curves
from .figures import ERRORS_MEDIAN, ERRORS_P95, Compared, draw_precision
from .modelling import draw_modelling, models, shifts, tier_errors
from .points import Point, cheapest, make_point, pareto, split
from .tiers import BLOCK, beyond, finest, tier_block, tier_groups, tier_rows

WANTED_PERCENT = (3.0, 0.5, 0.05)
LIMIT, CHECK = "limit", "limit by another method"
OTHER_METHOD = "sdirk2"
# Designs of the curves and the models, and of the tiers and the limit: (quick, full).
DESIGNS, TIER_DESIGNS = (16, 64), (64, 128)
# Points of the sweep that every level of a curve is tried at; the tiers are at all of them.
QUICK_SWEEP = 11


class Tradeoff(Study):
    """Error, roughness and cost of many compositions; the tiers; what the model contributes."""

    options = ("designs", "tier_designs")
    sources = ("experiments.tradeoff.batches",)
    scene = "jump"

    def plan(self, config: Mapping[str, Any]) -> list[Cell]:
        """The limit, its check, the tiers, the models, and every level of every curve."""
        base = groups_of(config)
        composed(base)
        count = self.count("designs", DESIGNS, 2, 1024)
        many = self.count("tier_designs", TIER_DESIGNS, 2, 4096)
        if many < count:
            raise ParameterError("task.tier_designs", many, f"at least task.designs = {count}")
        part = SWEEP if self.full else QUICK_SWEEP
        seed = config["seed"]
        limit = finest(base)
        other = changed(limit, {"integrator": {"name": OTHER_METHOD}})
        changes = models(base)
        self.curves: list[Curve] = curves(base, self.full)
        self.models = {f"model: {name}": name for name in changes}
        return [
            batch_cell(LIMIT, limit, many, SWEEP, seed),
            batch_cell(CHECK, other, count, 0, seed),
            *(
                batch_cell(f"tier {name}", tier_groups(base, name), many, SWEEP, seed)
                for name in TIERS
            ),
            *(
                batch_cell(cell, tier_groups(changes[name], "reference"), count, 0, seed)
                for cell, name in self.models.items()
            ),
            *(
                batch_cell(curve.cell(level), groups, count, part, seed, curve.lanes)
                for curve in self.curves
                for level, groups in curve.levels.items()
            ),
        ]

    def compute(self, cell: Cell) -> list[Row]:
        return jump_rows(cell.inputs)

    def conclude(self, done: Mapping[str, Done]) -> Conclusion:
        limit = done[LIMIT]
        if limit.status != OK:
            raise RuntimeError(f"no limit to compare with: {limit.message}")
        levels = [(c.name, level, c.cell(level)) for c in self.curves for level in c.levels]
        by_cell = {cell: make_point(c, level, done[cell], limit) for c, level, cell in levels}
        tiers = {name: make_point("tiers", name, done[f"tier {name}"], limit) for name in TIERS}
        points = list(by_cell.values())
        sound = [p for p in points if p.failed == 0]
        front = [sound[k] for k in pareto([p.ms for p in sound], [p.error for p in sound])]
        methods = {c.name: c.method for c in self.curves}
        moved = shifts({name: done[cell] for cell, name in self.models.items()})
        model_rows = [*moved, *tier_errors(tiers)]
        agreement = confirmed(done[CHECK], limit)
        designs = sum(row["kind"] == "design" for row in limit.rows)
        drawn = partial(draw_precision, Compared(points, methods, tiers))
        return Conclusion(
            title="What accuracy costs",
            findings=[
                *recommendations(points),
                agreement.pop("finding"),
                dominance(moved, tiers),
                f"{len(self.curves)} compositions; {sum(p.failed > 0 for p in points)} of "
                f"{len(points)} levels have failed jumps, "
                f"{sum(p.jumps == 0 for p in points)} were refused or failed altogether.",
                timed(done),
            ],
            tables={
                "front": Table("Pareto front: milliseconds against the larger of the errors of "
                               "x and y (95th percentile)", [p.row() for p in front]),
                "tiers": Table(f"Tiers over {designs} designs", tier_rows(tiers)),
                "beyond": Table("Designs at which a tier is further off than it promises",
                                beyond({name: done[f"tier {name}"] for name in TIERS}, limit)),
                "modelling": Table("How far results move with what is modelled, and how far "
                                   "numerics are off", model_rows),
                "failures": Table("Levels with failed jumps, or refused",
                                  [p.row() for p in points if p.failed or not p.jumps]),
                "levels": Table("Every level of every composition", [p.row() for p in points]),
            },
            figures={
                "precision_p95": Figure(
                    "Errors that 95 % of the designs keep, and roughness, against cost",
                    partial(drawn, ERRORS_P95, "Work and precision: 95th percentile"),
                ),
                "precision_median": Figure(
                    "Median errors, and roughness, against cost",
                    partial(drawn, ERRORS_MEDIAN, "Work and precision: median"),
                ),
                "modelling": Figure(
                    "What is modelled against how well it is solved",
                    partial(draw_modelling, model_rows),
                ),
            },
            summary={
                "compositions": len(self.curves),
                "designs": int(sum(row["kind"] == "design" for row in done[CHECK].rows)),
                **agreement,
                **{f"{n}_{k}": getattr(p, k) for n, p in tiers.items()
                   for k in ("x_p95_percent", "y_p95_percent", "x_roughness_bar", "ms")},
            },
            metrics={cell: metrics(point) for cell, point in by_cell.items()}
            | {f"tier {name}": metrics(point) for name, point in tiers.items()},
            blocks={BLOCK: tier_block(tiers, designs)},
        )  # fmt: skip


def metrics(point: Point) -> dict[str, float]:
    """The figures of a point as metrics of its record."""
    return {k: float(v) for k, v in point.row().items() if isinstance(v, (int, float))}


def recommendations(points: list[Point]) -> list[str]:
    """Which composition to use, in one sentence."""
    parts = []
    for wanted in WANTED_PERCENT:
        best = cheapest(points, wanted)
        if best is None:
            parts.append(f"for {wanted:g} % none of these is good enough")
        else:
            parts.append(f"for {wanted:g} % use {best.curve} at {best.level} ({best.ms:.2g} ms)")
    return ["To have x and y right in 95 % of the designs: " + "; ".join(parts) + "."]


def confirmed(check: Done, limit: Done) -> dict[str, Any]:
    """The distance of another method's limit from the limit."""
    if check.status != OK:
        return {"finding": f"The limit is not confirmed: {check.message}."}
    x, y = split(check)["design"]
    x_limit, y_limit = (column[: len(x)] for column in split(limit)["design"])
    x_off, y_off = (percentile(e, 95.0) for e in relative_errors(x, y, x_limit, y_limit))
    text = f"{OTHER_METHOD} confirms the limit: x within {x_off:.2g} %, y within {y_off:.2g} %"
    return {
        "finding": f"{text} (95 % of {len(x)} designs).",
        "limit_x_confirmed_percent": x_off,
        "limit_y_confirmed_percent": y_off,
    }


def dominance(moved: list[Row], tiers: Mapping[str, Point]) -> str:
    """Which uncertainty dominates, in a sentence."""
    known = [row for row in moved if "x_median_percent" in row]
    if not known:
        return "No model could be compared."
    largest, standard = known[0], tiers["standard"]
    above = sum(row["x_median_percent"] > standard.x_median_percent for row in known)
    return (
        f"{above} of {len(known)} changes of the model move x by more, in the median, than the "
        f"standard tier is off ({standard.x_median_percent:.2g} %); the largest, "
        f"{largest['source']}, by {largest['x_median_percent']:.2g} %."
    )


def timed(done: Mapping[str, Done]) -> str:
    """Whether all times are from the same run."""
    runs = {cell.run for cell in done.values()}
    share = np.sum([cell.column("ms").sum() for cell in done.values()]) / 1e3
    where = "one run" if len(runs) == 1 else f"{len(runs)} runs, and compare less well"
    return f"Times are from {where}; {share:.3g} s of kernel time in all."
