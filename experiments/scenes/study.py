"""``python run.py task=scenes``: what every scene leaves out, what that saves, what it changes."""

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from snapjump.run.studies.base import OK, Cell, Conclusion, Done, Figure, Row, Table
from snapjump.run.studies.study import Study
from snapjump.show.plots import palette
from snapjump.show.plots.saving import picture
from snapjump.sim.base import WITHOUT_GROUND

from ..compositions import changed, composed
from ..designs import spread_designs
from ..errors import relative_errors
from ..tradeoff.tiers import base_at
from .jumps import Both, contact, end, frame, start, timed

TIER = "standard"
DESIGNS = (16, 64)  # quick, full
FEW = 4  # of what is simulated one by one
REPEATS = 3
# Cell: how it is compared, what the scene leaves out, and what it has instead.
COMPARISONS: dict[str, tuple[Callable[..., Both], str, str]] = {
    "start": (start, "the slow loading", "an equilibrium at a share of the critical angle"),
    "end": (end, "the flight", "the parabola of the centre of mass"),
    "frame": (frame, "the frame's bending", "a rigid frame"),
    "contact": (contact, "the ground of a snap", "no contact terms in the program"),
}
WIDTH, ROW, MARGIN = 12.5, 0.75, 1.6  # inches
SMALLEST = 1e-10  # percent that is still drawn
SNAP = {family: {"name": name} for family, name in {"sim": "snap", **WITHOUT_GROUND}.items()}


class Scenes(Study):
    """Time saved and change of the answer, side by side."""

    keys = ()

    options = ("designs",)
    scene = "jump"
    sources = ("experiments.scenes.jumps", "experiments.designs")

    def plan(self, config: Mapping[str, Any]) -> list[Cell]:
        base = base_at(config, TIER)
        count = self.count("designs", DESIGNS, 2, 4096)
        designs = [list(design) for design in spread_designs(count, config["seed"])]
        few = designs[: min(FEW, count)]
        return [
            Cell("start", {"groups": base, "designs": designs}),
            Cell("end", {"groups": base, "designs": designs}),
            Cell("contact", {"groups": changed(base, SNAP), "designs": [d[:2] for d in few]}),
            Cell("frame", {"groups": base, "designs": few}),
        ]

    def compute(self, cell: Cell) -> list[Row]:
        compare = COMPARISONS[cell.name][0]
        both = compare(composed(cell.inputs["groups"]), cell.inputs["designs"])
        return timed(both, 1 if cell.name == "frame" else REPEATS)

    def conclude(self, done: Mapping[str, Done]) -> Conclusion:
        rows = [saving(name, cell) for name, cell in done.items()]
        known = [row for row in rows if "saved_percent" in row]
        return Conclusion(
            title="What scenes leave out",
            findings=[finding(row) for row in rows],
            tables={"scenes": Table("Time saved, and change of the answer", rows)},
            figures={
                "scenes": Figure("Time with everything and as the scene has it, and the change",
                                 partial(draw_savings, known)),
            },
            summary={
                f"{row['scene']}_{key}": row[key]
                for row in known
                for key in ("saved_percent", "x_change_median_percent", "y_change_median_percent",
                            "x_change_max_percent", "y_change_max_percent")
            },
        )  # fmt: skip


def saving(name: str, cell: Done) -> Row:
    """One comparison as a line of the table."""
    _, left_out, instead = COMPARISONS[name]
    row: Row = {"scene": name, "leaves_out": left_out, "has_instead": instead}
    if cell.status != OK:
        return {**row, "remark": f"{cell.status}: {cell.message}"}
    full_x, full_y, x, y = (cell.column(k) for k in ("full_x", "full_y", "scene_x", "scene_y"))
    good = np.isfinite(full_x) & np.isfinite(x)
    if name == "contact":  # of the midpoint, in percent of L
        changes = 100.0 * abs(x - full_x), 100.0 * abs(y - full_y)
    else:
        changes = relative_errors(x, y, full_x, full_y)
    full_ms, ms = (float(cell.column(k)[0]) for k in ("full_ms", "scene_ms"))
    return {
        **row,
        "designs": int(good.sum()),
        "full_ms": full_ms,
        "scene_ms": ms,
        "saved_percent": 100.0 * (1.0 - ms / full_ms),
        "full_iterations": float(np.mean(cell.column("full_newton_iterations"))),
        "scene_iterations": float(np.mean(cell.column("scene_newton_iterations"))),
        **{
            f"{axis}_change_{word}_percent": float(figure(change[good]))
            for axis, change in zip(("x", "y"), changes, strict=True)
            for word, figure in (("median", np.median), ("max", np.max))
        },
        "remark": "" if good.all() else f"{int((~good).sum())} of {len(good)} designs fail",
    }


def finding(row: Row) -> str:
    """One comparison in a sentence."""
    if "saved_percent" not in row:
        return f"Without {row['leaves_out']}: not compared ({row['remark']})."
    unit = "% of L" if row["scene"] == "contact" else "%"
    return (
        f"Without {row['leaves_out']}, but {row['has_instead']}: {row['saved_percent']:.3g} % of "
        f"the time saved ({row['full_ms']:.3g} to {row['scene_ms']:.3g} ms); x moves by "
        f"{row['x_change_median_percent']:.2g} {unit} in the median and by "
        f"{row['x_change_max_percent']:.2g} {unit} at most, y by "
        f"{row['y_change_median_percent']:.2g} and {row['y_change_max_percent']:.2g} {unit}, over "
        f"{row['designs']} designs."
    )


def draw_savings(rows: Sequence[Row], path: Path) -> None:
    """A line for each comparison: milliseconds on the left, changes of x and y on the right."""
    height = ROW * len(rows) + MARGIN
    headline = "What scenes leave out: time, and change of the answer"
    with picture(path, (WIDTH, height), headline) as figure:
        low, tall = 0.75 / height, (height - MARGIN) / height
        times, moved = (figure.add_axes((left, low, 0.37, tall)) for left in (0.17, 0.60))
        for place, row in enumerate(reversed(rows)):
            times.barh(place + 0.18, row["full_ms"], 0.32, color=palette.PALE)
            times.barh(place - 0.18, row["scene_ms"], 0.32, color=palette.BEAM)
            times.text(max(row["full_ms"], row["scene_ms"]) * 1.03, place,
                       f"{row['saved_percent']:.0f} % saved", va="center")  # fmt: skip
            _changes(moved, place, row)
        names = [f"without\n{row['leaves_out']}" for row in reversed(rows)]
        for axes in (times, moved):
            axes.set_ylim(-0.6, len(rows) - 0.4)
            axes.grid(True, axis="x")
            axes.set_yticks(range(len(rows)), names if axes is times else [])
        times.set_xlim(0.0, 1.3 * times.get_xlim()[1])
        times.set_xlabel("ms a jump (grey: with it; blue: as the scene is)")
        moved.set(xscale="log", xlim=(SMALLEST, 1e2))
        moved.set_xlabel("change: median (dot) to largest (bar); green x, orange y (%)")


def _changes(axes: Any, place: int, row: Row) -> None:
    """Median and largest change of x and of y; what is below the axis is said in words."""
    if max(row["x_change_max_percent"], row["y_change_max_percent"]) < SMALLEST:
        axes.text(2.0 * SMALLEST, place, "no change", va="center", color=palette.QUIET)
        return
    for shift, key, colour in ((0.12, "x", palette.CENTRE), (-0.12, "y", palette.FORCE)):
        ends = [max(row[f"{key}_change_{s}_percent"], SMALLEST) for s in ("median", "max")]
        axes.plot(ends, [place + shift] * 2, color=colour, lw=4, alpha=0.45)
        axes.plot(ends[:1], [place + shift], "o", color=colour, ms=7)
        axes.plot(ends[1:], [place + shift], "|", color=colour, ms=10, mew=2)
