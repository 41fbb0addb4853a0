"""influences.png, influences_height.png, influences_friction.png."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from experiments.paper.influences.compute import MOUNT_HEIGHT, SWEEPS
from experiments.paper.jumps import numbers
from experiments.paper.settings import BASELINE, NAMES, RANGES
from snapjump.run.studies.base import Row
from snapjump.show.plots import palette
from snapjump.show.plots.saving import picture

COORDINATES = {"x_bar": "$x_c$ / L", "y_bar": "$y_c$ / L"}
STYLES: dict[str, dict[str, Any]] = {
    "standard": {"color": palette.BEAM, "lw": 2.2},
    "paper": {"color": palette.FORCE, "lw": 1.4, "ls": (0, (5, 2.5))},
    "paper, short step": {"color": palette.CENTRE, "lw": 1.3, "ls": (0, (1, 1.2))},
    "reference": {"color": palette.INK, "ls": "", "marker": "o", "ms": 4.2, "mfc": "none"},
}
LABELS = {
    "standard": "standard",
    "paper": "the paper's settings",
    "paper, short step": "the same with a tenth of its step",
    "reference": "reference",
}


def draw_tiers(
    axes: Any, sweep: Mapping[str, Sequence[Row]], place: str, values: Mapping[str, Any]
) -> None:
    """The curves of all tiers; values: by tier."""
    for tier, style in STYLES.items():
        if tier in values:
            axes.plot(numbers(sweep[tier], place), values[tier], label=LABELS[tier], **style)
    axes.grid(True)


def draw_influences(sweeps: Mapping[str, Mapping[str, Sequence[Row]]], path: Path) -> None:
    """A column for each parameter; x above, y below."""
    with picture(path, (14.0, 7.0), "One parameter at a time about the baseline") as figure:
        grid = figure.subplots(2, len(sweeps), sharex="col")
        figure.subplots_adjust(
            left=0.052, right=0.99, bottom=0.085, top=0.88, wspace=0.2, hspace=0.1
        )
        for column, (kind, sweep) in enumerate(sweeps.items()):
            for row, (key, label) in enumerate(COORDINATES.items()):
                axes = grid[row, column]
                draw_tiers(axes, sweep, kind, {t: numbers(sweep[t], key) for t in sweep})
                first, last = SWEEPS[kind].first, SWEEPS[kind].last
                low, high = RANGES[kind]
                if (low, high) != (first, last):
                    axes.axvspan(low, high, color=palette.SHADE, zorder=0)
                axes.axvline(BASELINE[NAMES.index(kind)], color=palette.QUIET, lw=1.0, ls=":")
                axes.set_ylim(bottom=0.0)
                axes.set_xlim(first, last)
                if column == 0:
                    axes.set_ylabel(label)
                if row == 1:
                    axes.set_xlabel(SWEEPS[kind].label)
        handles, labels = grid[0, 1].get_legend_handles_labels()
        figure.legend(handles, labels, loc="upper right", ncols=4, bbox_to_anchor=(0.99, 0.985))


def draw_heights(sweep: Mapping[str, Sequence[Row]], statics: Row, path: Path) -> None:
    """x on the left, y on the right."""
    with picture(path, (13.0, 5.0), "Height of the clamps above the feet") as figure:
        panels = figure.subplots(1, 2)
        figure.subplots_adjust(left=0.05, right=0.99, bottom=0.125, top=0.85, wspace=0.13)
        for axes, (key, label) in zip(panels, COORDINATES.items(), strict=True):
            draw_tiers(axes, sweep, MOUNT_HEIGHT, {t: numbers(sweep[t], key) for t in sweep})
            for name in ("h1", "h2"):
                place = statics[f"{name}_bar"]
                axes.axvline(place, color=palette.QUIET, lw=1.2, ls=":")
                axes.annotate(
                    name, (place, 1.0), (0, 3), color=palette.QUIET, ha="center",
                    xycoords=("data", "axes fraction"), textcoords="offset points",
                )  # fmt: skip
            axes.set(xlabel=SWEEPS[MOUNT_HEIGHT].label, ylabel=label)
        handles, labels = panels[0].get_legend_handles_labels()
        figure.legend(handles, labels, loc="upper right", ncols=3, bbox_to_anchor=(0.99, 0.985))


SHARES = {
    "driving_share": ("slides back: friction drives", palette.BEAM, "o"),
    "braking_share": ("slides on: friction brakes", palette.FORCE, "s"),
    "sticking_share": ("sticks", palette.CENTRE, "^"),
}


def draw_friction(sweep: Mapping[str, Sequence[Row]], sliding: Sequence[Row], path: Path) -> None:
    """Velocities at lift-off on the left, shares of the impulse on the right."""
    with picture(path, (13.0, 5.0), "What friction can do") as figure:
        direction, shares = figure.subplots(1, 2)
        figure.subplots_adjust(left=0.055, right=0.99, bottom=0.125, top=0.83, wspace=0.15)
        draw_tiers(direction, sweep, "mu", {tier: lean(rows) for tier, rows in sweep.items()})
        direction.plot([0.0, 0.3], [0.0, 0.3], color=palette.QUIET, lw=1.2, ls=":")
        direction.annotate("$v_x = μ v_y$", (0.26, 0.26), (-8, 0), ha="right", color=palette.QUIET,
                           textcoords="offset points")  # fmt: skip
        direction.set(xlabel=SWEEPS["mu"].label, ylabel="$v_x$ / $v_y$")
        direction.set_title("velocity of the centre of mass at lift-off", loc="left")
        direction.legend(loc="lower right")
        places = numbers(sliding, "mu")
        for key, (label, colour, mark) in SHARES.items():
            values = 100.0 * numbers(sliding, key)
            shares.plot(places, values, mark + "-", color=colour, lw=2.0, ms=7, label=label)
        shares.set(xlabel=SWEEPS["mu"].label, ylabel="share of the normal impulse (%)")
        shares.set_title("the beam on the ground, at standard", loc="left")
        shares.set_ylim(-3.0, 100.0)
        shares.legend(loc="center left")
        shares.grid(True)


def lean(rows: Sequence[Row]) -> Any:
    """Sideways over upward velocity at lift-off."""
    return numbers(rows, "liftoff_vx_m_s") / numbers(rows, "liftoff_vy_m_s")
