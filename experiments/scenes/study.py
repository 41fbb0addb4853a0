"""``python run.py task=scenes``: what every scene leaves out, what that saves, what it changes."""

from collections.abc import Callable, Mapping
from functools import partial
from typing import Any

import numpy as np

from experiments.compositions import changed, composed
from experiments.designs import spread_designs
from experiments.errors import relative_errors
from experiments.scenes.figures import draw_savings
from experiments.scenes.jumps import Both, contact, end, frame, start, timed
from experiments.tradeoff.tiers import base_at
from snapjump.sim.base import WITHOUT_GROUND
from snapjump.studies.base import OK, Cell, Conclusion, Done, Figure, Row, Table
from snapjump.studies.study import Study

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
SNAP = {family: {"name": name} for family, name in {"sim": "snap", **WITHOUT_GROUND}.items()}


class Scenes(Study):
    """Time saved and change of the answer, side by side."""

    options = ("designs",)
    scene = "jump"
    sources = ("experiments.scenes.jumps", "experiments.designs")

    def plan(self, config: Mapping[str, Any]) -> list[Cell]:
        """One cell for each comparison."""
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
        """A row for each design, with everything and as the scene has it."""
        compare = COMPARISONS[cell.name][0]
        both = compare(composed(cell.inputs["groups"]), cell.inputs["designs"])
        return timed(both, 1 if cell.name == "frame" else REPEATS)

    def conclude(self, done: Mapping[str, Done]) -> Conclusion:
        """Savings and changes."""
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
