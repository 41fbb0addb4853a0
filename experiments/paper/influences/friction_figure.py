"""influences_friction.png: the direction of lift-off, and the sliding of the beam."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from experiments.paper.influences.figure import draw_tiers
from experiments.paper.influences.sweeps import SWEEPS
from experiments.paper.jumps import numbers
from snapjump.plots import palette
from snapjump.plots.saving import picture
from snapjump.studies.base import Row

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
