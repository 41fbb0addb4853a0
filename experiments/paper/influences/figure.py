"""influences.png, influences_height.png, influences_friction.png."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from snapjump.run.studies.base import Row, column
from snapjump.show.plots import palette
from snapjump.show.plots.saving import panels

from ...styles import boxes, draw_tiers
from ..settings import BASELINE, LABELS, NAMES, RANGES

Sweep = Mapping[str, Sequence[Row]]
ALL, HEIGHTS, FRICTION = (14.0, 7.0), (14.0, 5.0), (13.0, 5.0)
COORDINATES = {"x_bar": "$x_c$ / L", "y_bar": "$y_c$ / L"}


def draw_sweep(axes: Any, sweep: Sweep, place: str, key: str) -> None:
    """A column of all tiers against another."""
    draw_tiers(axes, *({t: column(rows, k) for t, rows in sweep.items()} for k in (place, key)))


def legend(axes: Any) -> None:
    """That of a panel, in the title's line."""
    axes.figure.legend(*axes.get_legend_handles_labels(), loc="upper right", ncols=4,
                       bbox_to_anchor=(0.99, 0.99))  # fmt: skip


def draw_influences(sweeps: Mapping[str, Sweep], path: Path) -> None:
    """A column for each parameter; x above, y below."""
    places = boxes(ALL, 2, len(sweeps), across=0.55, up=0.4)
    with panels(path, ALL, "One parameter at a time about the baseline", *places) as drawn:
        for k, (name, sweep) in enumerate(sweeps.items()):
            for key, axes in zip(COORDINATES, drawn[k :: len(sweeps)], strict=True):
                draw_sweep(axes, sweep, name, key)
                ends = column(sweep["standard"], name)[[0, -1]]
                if RANGES[name] != tuple(ends):
                    axes.axvspan(*RANGES[name], color=palette.SHADE, zorder=0)
                axes.axvline(BASELINE[NAMES.index(name)], color=palette.QUIET, lw=1.0, ls=":")
                axes.set_ylim(bottom=0.0)
                axes.set_xlim(*ends)
            axes.set_xlabel(LABELS[name])
        for axes, label in zip(drawn[:: len(sweeps)], COORDINATES.values(), strict=True):
            axes.set_ylabel(label)
        legend(drawn[1])


def draw_heights(sweeps: Mapping[str, Sweep], statics: Row, path: Path) -> None:
    """y of the vertical jump; y and x of the baseline."""
    vertical, oblique = sweeps.values()
    shown = [(vertical, "y_bar", "vertical jump"), (oblique, "y_bar", "baseline"),
             (oblique, "x_bar", "baseline")]  # fmt: skip
    places = boxes(HEIGHTS, 1, 3, top=0.85)
    with panels(path, HEIGHTS, "Height of the clamps above the feet", *places) as drawn:
        for axes, (sweep, key, title) in zip(drawn, shown, strict=True):
            draw_sweep(axes, sweep, "mount_height_bar", key)
            for name in ("h1", "h2"):
                place = statics[f"{name}_bar"]
                axes.axvline(place, color=palette.QUIET, lw=1.2, ls=":")
                axes.annotate(
                    name, (place, 1.0), (0, 3), color=palette.QUIET, ha="center",
                    xycoords=("data", "axes fraction"), textcoords="offset points",
                )  # fmt: skip
            axes.set(xlabel=LABELS["mount_height_bar"], ylabel=COORDINATES[key])
            axes.set_title(title)
        legend(drawn[0])


SHARES = {
    "driving_share": ("slides back: friction drives", palette.BEAM, "o"),
    "braking_share": ("slides on: friction brakes", palette.FORCE, "s"),
    "sticking_share": ("sticks", palette.CENTRE, "^"),
}


def draw_friction(sweep: Sweep, sliding: Sequence[Row], path: Path) -> None:
    """Velocities at lift-off on the left, shares of the impulse on the right."""
    places = boxes(FRICTION, 1, 2, top=0.9)
    with panels(path, FRICTION, "What friction can do", *places) as (direction, shares):
        leans = {t: column(rows, "liftoff_vx_m_s") / column(rows, "liftoff_vy_m_s")
                 for t, rows in sweep.items()}  # fmt: skip
        draw_tiers(direction, {t: column(rows, "mu") for t, rows in sweep.items()}, leans)
        direction.plot([0.0, 0.3], [0.0, 0.3], color=palette.QUIET, lw=1.2, ls=":")
        direction.annotate("$v_x = μ v_y$", (0.26, 0.26), (-8, 0), ha="right", color=palette.QUIET,
                           textcoords="offset points")  # fmt: skip
        direction.set(xlabel=LABELS["mu"], ylabel="$v_x$ / $v_y$")
        direction.set_title("velocity of the centre of mass at lift-off", loc="left")
        direction.legend(loc="lower right")
        for key, (label, colour, mark) in SHARES.items():
            shares.plot(column(sliding, "mu"), 100.0 * column(sliding, key), mark + "-",
                        color=colour, lw=2.0, ms=7, label=label)  # fmt: skip
        shares.set(xlabel=LABELS["mu"], ylabel="share of the normal impulse (%)")
        shares.set_title("the beam on the ground, at standard", loc="left")
        shares.set_ylim(-3.0, 100.0)
        shares.legend(loc="center left")
