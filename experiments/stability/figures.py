"""Maps of status and error, and the error estimate against the truth."""

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from snapjump.run.studies.base import Row
from snapjump.show.plots import palette
from snapjump.show.plots.saving import axes_at, picture

from .axes import Map
from .calibration import compared
from .jumps import by_status

# By status: the colour of a cell, and what stands in it.
STATUSES = {
    "ok": ("#d9ecf7", ""),
    "no_jump": ("#f3e3b3", "no jump"),
    "refused": ("#e5e7eb", "refused"),
    "time_limit": ("#e8c7dc", "time"),
    "iteration_limit": ("#c3a6d8", "bound"),
    "no_equilibrium": ("#a9b4c2", "no eq."),
    "step_underflow": (palette.FORCE, "underflow"),
    "not_finite": (palette.INK, "NaN"),
}
DARK = ("step_underflow", "not_finite")
ERRORS = (1e-2, 1e2)  # percent, of the colours
CELL = (0.62, 0.42)  # inches
LEFT, BETWEEN, RIGHT, TOP, FOOT = 2.05, 0.35, 1.25, 0.95, 0.95


def text_of(value: Any) -> str:
    """A tick: a name, or a number in few letters."""
    if isinstance(value, str):
        return value
    return f"{value:g}".replace("e-0", "e-").replace("e+0", "e")


def draw_map(found: Map, rows: Sequence[Row], path: Path) -> None:
    """Status on the left; on the right the largest true error, a dot where all is marked."""
    nx, ny = len(found.across.values), len(found.up.values)
    wide, high = max(nx * CELL[0], 4.0), ny * CELL[1]
    size = (LEFT + 2 * wide + BETWEEN + RIGHT, high + TOP + FOOT)
    right = LEFT + wide + BETWEEN
    with picture(path, size, f"{found.name}: {found.up.label} against {found.across.label}") as fig:
        status, error = (axes_at(fig, left, FOOT, wide, high) for left in (LEFT, right))
        _status(status, found, rows)
        image = _errors(error, found, rows)
        for axes in (status, error):
            _ticks(axes, found, named=axes is status)
        bar = axes_at(fig, right + wide + 0.15, FOOT, 0.16, high)
        fig.colorbar(image, cax=bar, label="true error (%)", extend="both")


def places(found: Map, rows: Sequence[Row]) -> Iterator[tuple[int, int, list[Row]]]:
    """Row, column and jumps of every cell that has any."""
    for i, up in enumerate(found.up.values):
        for j, across in enumerate(found.across.values):
            here = [row for row in rows if (row["across"], row["up"]) == (across, up)]
            if here:
                yield i, j, here


def _status(axes: Any, found: Map, rows: Sequence[Row]) -> None:
    from matplotlib.colors import to_rgb

    colours = np.ones((len(found.up.values), len(found.across.values), 3))
    for i, j, here in places(found, rows):
        bad = by_status([row for row in here if row["status"] != "ok"])
        shown = bad.most_common(1)[0][0] if 2 * bad.total() > len(here) else "ok"
        colour, label = STATUSES[shown]
        colours[i, j] = to_rgb(colour)
        if 0 < bad.total() < len(here):
            label = f"{len(here) - bad.total()}/{len(here)}"
        axes.text(j, i, label, ha="center", va="center", fontsize=7.5,
                  color=palette.PAPER if shown in DARK else palette.INK)  # fmt: skip
    axes.imshow(colours, origin="lower", aspect="auto")
    axes.set_title("status (blank: ok; k/n: so many ok)", loc="left")


def _errors(axes: Any, found: Map, rows: Sequence[Row]) -> Any:
    from matplotlib.colors import LogNorm

    values = np.full((len(found.up.values), len(found.across.values)), np.nan)
    for i, j, seen in places(found, [row for row in rows if "true_error_percent" in row]):
        values[i, j] = max(1e-6, *(row["true_error_percent"] for row in seen))
        if not any(row["within_tier"] for row in seen):
            axes.plot(j, i, "o", ms=5, mfc=palette.PAPER, mec=palette.INK, mew=0.8)
    image = axes.imshow(values, origin="lower", aspect="auto", cmap="YlOrRd", norm=LogNorm(*ERRORS))
    axes.set_facecolor(palette.SHADE)
    axes.set_title("largest error (dot: all marked as beyond their tier)", loc="left")
    return image


def _ticks(axes: Any, found: Map, named: bool) -> None:
    across, up = found.across, found.up
    axes.set_xticks(range(len(across.values)), [text_of(v) for v in across.values],
                    rotation=45 if len(across.values) > 6 else 0)  # fmt: skip
    axes.set_yticks(range(len(up.values)), [text_of(v) for v in up.values] if named else [])
    axes.set_xlabel(across.label)
    if named:
        axes.set_ylabel(up.label)
    axes.tick_params(length=0)


LIMITS = (2e-4, 3e2)


def draw_calibration(by_kind: Mapping[str, Sequence[Row]], path: Path) -> None:
    """True errors of x and y against their estimates, a colour for each composition."""
    headline = "The error estimate of a jump against its true error"
    with picture(path, (14.2, 5.9), headline) as figure:
        for k, name in enumerate(("x", "y")):
            axes = figure.add_axes((0.06 + 0.365 * k, 0.12, 0.3, 0.74))
            for colour, (kind, rows) in zip(palette.SERIES, by_kind.items(), strict=False):
                true, estimate = compared(rows, name)
                axes.plot(estimate, np.maximum(true, 1.2 * LIMITS[0]), ".", ms=3.5, color=colour,
                          alpha=0.55, mew=0, label=kind)  # fmt: skip
            for factor, style in ((1.0, "-"), (2.0, "--")):
                axes.plot(LIMITS, [factor * v for v in LIMITS], style, color=palette.INK, lw=1.1)
            axes.set(
                xscale="log", yscale="log", xlim=(1e-2, LIMITS[1]), ylim=LIMITS,
                xlabel=f"estimated error of {name} (%)", ylabel=f"true error of {name} (%)",
            )  # fmt: skip
            axes.grid(True)
            axes.set_title(f"{name}: solid equal, dashed twice the estimate", loc="left")
        axes.legend(loc="upper left", bbox_to_anchor=(1.04, 1.0), markerscale=3.0)
