"""trajectories_angles.png: how oblique the jump is, and the way to lift-off."""

from collections.abc import Mapping, Sequence
from pathlib import Path

from experiments.paper.jumps import numbers
from experiments.paper.trajectories.figure import COLOURS, DASHES
from experiments.paper.trajectories.judge import ratios
from snapjump.plots import palette
from snapjump.plots.saving import picture
from snapjump.studies.base import Row


def draw_angles(
    sweeps: Mapping[str, Sequence[Row]], paths: Mapping[float, Sequence[Row]], path: Path
) -> None:
    """Ratios on the left; paths on the ground, stretched sideways, on the right."""
    with picture(path, (13.0, 5.2), "How the mismatch turns a jump") as figure:
        angles, before = figure.subplots(1, 2)
        figure.subplots_adjust(left=0.06, right=0.985, bottom=0.125, top=0.83, wspace=0.17)
        lags = {tier: numbers(rows, "delta_alpha_rad") for tier, rows in sweeps.items()}
        drawn = {
            "standard": {"color": palette.BEAM, "lw": 2.2},
            "paper": {"color": palette.FORCE, "lw": 1.5, "ls": DASHES},
            "reference": {"color": palette.INK, "ls": "", "marker": "o", "ms": 4.5, "mfc": "none"},
        }
        for tier, style in drawn.items():
            label = "the paper's settings" if tier == "paper" else tier
            angles.plot(lags[tier], ratios(sweeps[tier]), label=label, **style)
        angles.set(xlabel="mismatch Δα (rad)", ylabel="$x_c$ / $y_c$ of the apex")
        angles.set_title("how far aside for the height", loc="left")
        angles.legend(loc="lower right")
        angles.grid(True)

        for colour, dash, (lag, rows) in zip(
            COLOURS,
            ("-", DASHES, (0, (1, 1.2)), (0, (6, 1.5, 1, 1.5))),
            paths.items(),
            strict=False,
        ):
            x, y = numbers(rows, "x_bar"), numbers(rows, "y_bar")
            before.plot(x, y, color=colour, ls=dash, lw=2.2, label=f"Δα = {lag:g}")
            touching = numbers(rows, "ground_force_N") > 0.0
            last = int(touching.nonzero()[0][-1])
            before.plot(x[last], y[last], "o", color=colour, ms=7)
        before.set(xlabel="x / L (stretched)", ylabel="y / L")
        before.set_title("centre of mass from rest; dots: the last contact", loc="left")
        before.legend(loc="lower right")
        before.grid(True)
