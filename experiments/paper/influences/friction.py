"""Friction: what it does not change, and why it drives the robot aside no more."""

from collections.abc import Sequence

from experiments.paper.baseline import RANGES
from experiments.paper.influences.rules import (
    COMMAND,
    Sweeps,
    columns,
    independent,
    levels_off,
    limit_of_level,
    percent,
    relative_range,
)
from experiments.paper.jumps import numbers
from experiments.paper.statement import Statement
from experiments.paper.trends import plateau
from snapjump.studies.base import Row

# Of the normal impulse: where no more of it acts on a contact that sticks, sticking explains
# nothing.
STICKS = 0.05


def friction_statements(sweeps: Sweeps, sliding: Sequence[Row], accuracy: str) -> list[Statement]:
    """What friction does not change, and where it changes no more."""
    last = RANGES["mu"][1]
    v, x, y = columns(sweeps["standard"], "mu", last)
    _, paper_x, paper_y = columns(sweeps["paper"], "mu", last)
    own, papers = plateau(v, x), plateau(v, paper_x)
    _, _, all_y = columns(sweeps["standard"], "mu")
    return [
        Statement(
            "y_c does not depend on the friction coefficient μ.",
            independent(y),
            f"Over μ in [0, {last:g}] y_c lies between {y.min():.1f} and {y.max():.1f} L, a range "
            f"of {percent(relative_range(y))} of its mean (the paper's settings: "
            f"{percent(relative_range(paper_y))}); up to μ = 1 of "
            f"{percent(relative_range(all_y))}.",
            accuracy,
            COMMAND,
        ),
        Statement(
            "x_c grows with μ up to a threshold, and no more beyond.",
            levels_off(own),
            limit_of_level(levels_off(own), {"x_c": own})
            + f"x_c grows in proportion to μ, by {own.slope_before:.0f} L, up to μ = "
            f"{own.threshold:.2g}, then stays within {percent(own.relative_swing)} from lowest "
            f"to highest about {own.level:.2g} L up to {last:g} (the paper's settings: "
            f"{papers.threshold:.2g}, {percent(papers.relative_swing)}). "
            f"{why(sliding, own.threshold)}",
            accuracy,
            COMMAND,
        ),
    ]


def why(sliding: Sequence[Row], threshold: float) -> str:
    """What becomes of the contact beyond the threshold, from the shares of its normal impulse."""
    stuck = float(numbers(sliding, "sticking_share").max())
    if stuck > STICKS:
        return f"The contact sticks under up to {percent(stuck)} of the beam's normal impulse."
    low, high = sliding[0], sliding[-1]
    from_there = numbers(sliding, "mu") >= min(threshold, high["mu"])
    beyond = numbers(sliding, "friction_over_normal")[from_there]
    return (
        f"Not because the contact sticks: at most {percent(stuck)} of the beam's normal impulse "
        "acts where it does. The beam slides to and fro: the share that brakes goes from "
        f"{percent(low['braking_share'])} at μ = {low['mu']:g} to "
        f"{percent(high['braking_share'])} at {high['mu']:g}, so that beyond the threshold the "
        f"net friction is {beyond.min():.2f} to {beyond.max():.2f} of the normal impulse."
    )
