"""Maps of status and error, and the error estimate against the truth."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from experiments.stability.axes import Map
from experiments.stability.calibration import columns
from experiments.stability.jumps import KNOWN
from snapjump.plots import palette
from snapjump.plots.saving import picture
from snapjump.studies.base import Row

STATUSES = {
    "ok": "#d9ecf7",
    "no_jump": "#f3e3b3",
    "refused": "#e5e7eb",
    "time_limit": "#e8c7dc",
    "iteration_limit": "#c3a6d8",
    "no_equilibrium": "#a9b4c2",
    "step_underflow": palette.FORCE,
    "not_finite": palette.INK,
}
SHORT = {
    "ok": "",
    "no_jump": "no jump",
    "refused": "refused",
    "time_limit": "time",
    "iteration_limit": "bound",
    "no_equilibrium": "no eq.",
    "step_underflow": "underflow",
    "not_finite": "NaN",
}
ERRORS = (1e-2, 1e2)  # percent, of the colours
CELL = (0.62, 0.42)  # inches
LEFT, BETWEEN, RIGHT, TOP, FOOT = 2.05, 0.35, 1.25, 0.95, 0.95


def text_of(value: Any) -> str:
    """A tick: a name, or a number in few letters."""
    if isinstance(value, str):
        return value
    return f"{value:g}".replace("e-0", "e-").replace("e+0", "e")


def cells(found: Map, rows: Sequence[Row]) -> dict[tuple[Any, Any], list[Row]]:
    """The rows by their place."""
    by_place: dict[tuple[Any, Any], list[Row]] = {}
    for row in rows:
        by_place.setdefault((row["across"], row["up"]), []).append(row)
    return by_place


def draw_map(found: Map, rows: Sequence[Row], path: Path) -> None:
    """Status on the left; on the right the largest true error, a dot where all is marked."""
    nx, ny = len(found.across.values), len(found.up.values)
    wide, high = max(nx * CELL[0], 4.0), ny * CELL[1]
    size = (LEFT + 2 * wide + BETWEEN + RIGHT, high + TOP + FOOT)
    places = cells(found, rows)
    with picture(path, size, f"{found.name}: {found.up.label} against {found.across.label}") as fig:
        boxes = [
            (left / size[0], FOOT / size[1], wide / size[0], high / size[1])
            for left in (LEFT, LEFT + wide + BETWEEN)
        ]
        status, error = (fig.add_axes(box) for box in boxes)
        _status(status, found, places)
        image = _errors(error, found, places)
        for axes in (status, error):
            _ticks(axes, found, named=axes is status)
        bar = fig.add_axes((boxes[1][0] + boxes[1][2] + 0.15 / size[0], FOOT / size[1],
                            0.16 / size[0], high / size[1]))  # fmt: skip
        fig.colorbar(image, cax=bar, label="true error (%)", extend="both")


def _status(axes: Any, found: Map, places: Mapping[Any, list[Row]]) -> None:
    from matplotlib.colors import to_rgb

    picture_of = np.ones((len(found.up.values), len(found.across.values), 3))
    for i, up in enumerate(found.up.values):
        for j, across in enumerate(found.across.values):
            names = [row["status"] for row in places.get((across, up), [])]
            if not names:
                continue
            bad = [n for n in names if n != "ok"]
            shown = max(set(bad), key=bad.count) if len(bad) * 2 > len(names) else names[0]
            if len(bad) * 2 <= len(names):
                shown = "ok"
            picture_of[i, j] = to_rgb(STATUSES[shown])
            label = SHORT[shown]
            if bad and len(names) > 1 and len(bad) < len(names):
                label = f"{len(names) - len(bad)}/{len(names)}"
            dark = shown in ("step_underflow", "not_finite")
            axes.text(j, i, label, ha="center", va="center", fontsize=7.5,
                      color=palette.PAPER if dark else palette.INK)  # fmt: skip
    axes.imshow(picture_of, origin="lower", aspect="auto")
    axes.set_title("status (blank: ok; k/n: so many ok)", loc="left")


def _errors(axes: Any, found: Map, places: Mapping[Any, list[Row]]) -> Any:
    from matplotlib.colors import LogNorm

    values = np.full((len(found.up.values), len(found.across.values)), np.nan)
    for i, up in enumerate(found.up.values):
        for j, across in enumerate(found.across.values):
            seen = [r for r in places.get((across, up), []) if "true_error_percent" in r]
            if not seen:
                continue
            values[i, j] = max(max(r["true_error_percent"] for r in seen), 1e-6)
            if not any(r["within_tier"] for r in seen):
                axes.plot(j, i, "o", ms=5, mfc=palette.PAPER, mec=palette.INK, mew=0.8)
    image = axes.imshow(values, origin="lower", aspect="auto", cmap="YlOrRd",
                        norm=LogNorm(*ERRORS))  # fmt: skip
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


COLOURS = (
    palette.BEAM, palette.CENTRE, palette.FORCE, palette.PLUM, palette.CLAMP, palette.SKY,
    palette.VIOLET, palette.FRAME, "#8c510a", "#01665e", "#b2182b", "#4d9221",
)  # fmt: skip
LIMITS = (2e-4, 3e2)


def draw_calibration(by_kind: Mapping[str, Sequence[Row]], path: Path) -> None:
    """True errors of x and y against their estimates, a colour for each composition."""
    size = (14.2, 5.9)
    headline = "The error estimate of a jump against its true error"
    with picture(path, size, headline) as figure:
        for k, coordinate in enumerate(("x", "y")):
            axes = figure.add_axes((0.06 + 0.365 * k, 0.12, 0.3, 0.74))
            for colour, (kind, rows) in zip(COLOURS, by_kind.items(), strict=False):
                estimate, true = columns(
                    rows, f"{coordinate}_error_estimate_percent", f"true_{coordinate}_percent"
                )
                axes.plot(estimate, np.maximum(true, 1.2 * LIMITS[0]), ".", ms=3.5, color=colour,
                          alpha=0.55, mew=0, label=kind)  # fmt: skip
            for factor, style in ((1.0, "-"), (2.0, "--")):
                axes.plot(LIMITS, [factor * v for v in LIMITS], style, color=palette.INK, lw=1.1)
            axes.set(xscale="log", yscale="log", xlim=(1e-2, LIMITS[1]), ylim=LIMITS)
            axes.grid(True)
            axes.set_xlabel(f"estimated error of {coordinate} (%)")
            axes.set_ylabel(f"true error of {coordinate} (%)")
            axes.set_title(f"{coordinate}: solid equal, dashed twice the estimate", loc="left")
        axes.legend(loc="upper left", bbox_to_anchor=(1.04, 1.0), markerscale=3.0)


def shares(rows: Sequence[Row]) -> dict[str, int]:
    """Counts by status, the usual ones first."""
    names = [row["status"] for row in rows]
    return {name: names.count(name) for name in (*KNOWN, *sorted(set(names) - set(KNOWN)))}
