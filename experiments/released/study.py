"""``python run.py task=released``: the released program's data against ours at its settings."""

from collections.abc import Mapping, Sequence
from functools import partial
from itertools import chain
from pathlib import Path
from typing import Any

import numpy as np

from snapjump.batch import simulate_batch, variants
from snapjump.checks import check_integer
from snapjump.run.studies.base import OK, Cell, Conclusion, Done, Figure, Row, Table
from snapjump.run.studies.study import Study
from snapjump.show.plots import palette
from snapjump.show.plots.saving import picture

from ..compositions import changed, composed
from ..designs import COLUMNS, LABELS
from . import data
from .settings import WITHOUT, converged, released

ALL, CONVERGED = "released settings", "converged"
ALL_OF_THEM = "all quirks on, same rows"
LANES = 8
KEPT = ("status", "x_bar", "y_bar", "newton_iterations")
BOUNDS = {"x": 15.0, "y": 6.0}  # percent that the axes show; what is beyond lies on the edge


class Released(Study):
    """All rows at the released settings and converged, and a few with each quirk left out."""

    keys = ()

    options = ("rows", "quirk_rows")
    sources = ("experiments.released.data", "experiments.released.settings")

    def plan(self, config: Mapping[str, Any]) -> list[Cell]:
        many, few = (config["task"][key] for key in self.options)
        check_integer("task.rows", many, 4, 300)
        check_integer("task.quirk_rows", few, 4, 300)

        def cell(name: str, groups: Mapping[str, Any], rows: int) -> Cell:
            return Cell(name, {"groups": groups, "rows": rows, "data": data.digest()})

        return [
            cell(ALL, released(), many),
            cell(CONVERGED, converged(), many),
            cell(ALL_OF_THEM, released(), few),
            *(cell(name, changed(released(), change), few) for name, change in WITHOUT.items()),
        ]

    def compute(self, cell: Cell) -> list[Row]:
        return measure(cell.inputs["groups"], cell.inputs["rows"])

    def conclude(self, done: Mapping[str, Done]) -> Conclusion:
        full, limit = done[ALL], done[CONVERGED]
        if full.status != OK:
            raise RuntimeError(f"the released settings could not be run: {full.message}")
        x, y = percents(full)
        summary, gravity = data.figures(x, y), composed(released()).robot.gravity_m_s2
        overall = [{"settings": ALL, "rows": len(x), **summary}]
        if limit.status == OK:
            far = percents(limit)
            overall.append({"settings": CONVERGED, "rows": len(far[0]), **data.figures(*far)})
        quirks = [
            {"left out": name, **data.figures(*percents(done[name]))}
            for name in (ALL_OF_THEM, *WITHOUT)
            if done[name].status == OK
        ]
        by_parameter = (data.by_quarter(full.column(name), x, y, name) for name in COLUMNS)
        quarters = [*chain.from_iterable(by_parameter)]
        return Conclusion(
            title="The released program's data",
            findings=[
                f"At the released program's settings {len(x)} of its rows are met with a median "
                f"difference of {summary['y_median_percent']:.2g} % in y and "
                f"{summary['x_median_percent']:.2g} % in x; {data.share_within(y, 2.0):.0f} % are "
                f"within 2 % in y, {data.share_within(x, 5.0):.0f} % within 5 % in x, "
                f"{summary['failed']} failed. Gravity is {gravity:g} m/s^2.",
                *(
                    f"The converged answer for the same designs is "
                    f"{row['y_median_percent']:.2g} % away in y and "
                    f"{row['x_median_percent']:.2g} % in x (medians)."
                    for row in overall[1:]
                ),
                f"What is left in x is at small mismatch: {quarters[0]['x_median_percent']:.2g} % "
                f"up to delta_alpha = {quarters[0]['to']:.2g} rad, "
                f"{quarters[3]['x_median_percent']:.2g} % above {quarters[3]['from']:.2g} rad "
                "(medians): the mismatch that the program's frame adds is not quite ours.",
                "right_follow = 0.5 is not known from the program: it is the one number inferred "
                "from its data. Newton's method stops at a much smaller residual than the "
                "program's, and the right clamp lags from the start instead of waiting.",
            ],
            tables={
                "overall": Table("Differences from the released rows", overall),
                "quirks": Table("One quirk left out at a time", quirks),
                "parameters": Table("Where the differences are", quarters),
            },
            figures={
                "released": Figure(
                    "Our jumps at the released program's settings against its rows",
                    partial(draw_comparison, full.rows),
                )
            },
            summary={
                "gravity_m_s2": gravity,
                "rows": len(x),
                "ms_per_jump": float(np.mean(full.column("ms"))),
                **summary,
            },
        )


def percents(done: Done) -> list[Any]:
    """Differences of x and y (%)."""
    return [done.column(f"{name}_difference_percent") for name in ("x", "y")]


def measure(groups: Mapping[str, Any], count: int) -> list[Row]:
    """Jumps of ``count`` rows' designs, and how far they are from the rows."""
    rows = data.read_rows(count)
    batch = simulate_batch(variants(composed(groups), rows.designs), LANES)
    x, y = data.differences(batch.x_bar, batch.y_bar, rows.x_bar, rows.y_bar)
    return [
        {
            **dict(zip(COLUMNS, design, strict=True)),
            **row,
            "x_released_bar": rows.x_bar[k],
            "y_released_bar": rows.y_bar[k],
            "x_difference_percent": x[k],
            "y_difference_percent": y[k],
            "ms": 1e3 * batch.march_seconds / len(rows.designs),
        }
        for k, (design, row) in enumerate(zip(rows.designs, batch.rows(*KEPT), strict=True))
    ]


def draw_comparison(rows: Sequence[dict[str, Any]], path: Path) -> None:
    """Two squares of apexes above eight small pictures of differences."""
    known = [row for row in rows if row["y_difference_percent"] is not None]
    values = {key: np.array([float(row[key]) for row in known]) for key in _columns()}
    with picture(path, (12.0, 10.0), "The released program's data, at its settings") as figure:
        for k, name in enumerate(("x", "y")):
            axes = figure.add_axes((0.09 + 0.5 * k, 0.56, 0.38, 0.34))
            theirs, ours = values[f"{name}_released_bar"], values[f"{name}_bar"]
            top = 1.05 * max(theirs.max(), ours.max())
            low = min(0.0, theirs.min(), ours.min())
            axes.plot([low, top], [low, top], color=palette.INK, lw=1)
            axes.plot(theirs, ours, "o", ms=4, alpha=0.6, mec="none", color=palette.BEAM)
            axes.set(xlabel=f"{name} of the apex, theirs (L)", ylabel=f"{name}, ours (L)")
            axes.grid(True)
            for j, parameter in enumerate(COLUMNS):
                _differences(figure, values, name, parameter, (j, k))


def _columns() -> list[str]:
    kinds = ("bar", "released_bar", "difference_percent")
    return [*COLUMNS, *(f"{name}_{kind}" for name in ("x", "y") for kind in kinds)]


def _differences(
    figure: Any, values: dict[str, Any], name: str, parameter: str, place: tuple[int, int]
) -> None:
    """Differences of one coordinate against one parameter."""
    column, row = place
    bound = BOUNDS[name]
    axes = figure.add_axes((0.09 + 0.235 * column, 0.305 - 0.225 * row, 0.175, 0.17))
    shown = np.clip(values[f"{name}_difference_percent"], -bound, bound)
    axes.axhline(0.0, color=palette.INK, lw=1)
    axes.plot(values[parameter], shown, "o", ms=3, alpha=0.6, mec="none", color=palette.CLAMP)
    axes.set_ylim(-1.05 * bound, 1.05 * bound)
    axes.grid(True)
    if row == 1:
        axes.set_xlabel(LABELS[parameter])
    if column == 0:
        axes.set_ylabel(f"{name}, ours less theirs (%)")
