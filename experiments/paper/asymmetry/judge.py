"""Verdicts on how the tilt of a snap grows with the mismatch."""

import math
from collections.abc import Callable, Mapping, Sequence

import numpy as np

from experiments.paper.asymmetry.saturation import FLAT_FROM, LINEAR_WITHIN, Saturation
from experiments.paper.baseline import RANGES
from experiments.paper.statement import Statement, verdict
from snapjump.studies.base import Row

COMMAND = "task=paper figure=asymmetry"
SMALLEST_DESIGN_RAD = RANGES["delta_alpha_rad"][0]
PROPORTIONAL = 0.02  # how near to one the exponent of the smallest tilts has to be
DECADE = 10.0  # a line that is seen over less than a decade of mismatches is none
# Growth from ten thresholds to the end of the paper's range: what is flat, and what has at least
# stopped growing like the mismatch, which grows some twentyfold there.
FLAT, STOPPED = 0.05, 0.3


def linear_verdict(found: Mapping[float, Saturation], smallest_rad: float) -> str:
    """Linear up to mismatches that robots are designed with, or up to smaller ones only."""
    linear = all(
        abs(one.exponent - 1.0) <= PROPORTIONAL and one.linear_until_rad >= DECADE * smallest_rad
        for one in found.values()
    )
    far = all(one.linear_until_rad >= SMALLEST_DESIGN_RAD for one in found.values())
    return verdict(linear and far, linear)


def saturation_verdict(found: Mapping[float, Saturation]) -> str:
    """A plateau, or a growth that has at least broken off."""
    rise = max(abs(one.rise) for one in found.values())
    return verdict(rise <= FLAT, rise <= STOPPED)


def linear_statement(
    found: Mapping[str, Mapping[float, Saturation]], smallest_rad: float, off: str
) -> Statement:
    """``found``: laws by setting and pre-compression; ``off``: accuracy in words."""
    own = found["standard"]
    until = [one.linear_until_rad for one in own.values()]
    return Statement(
        "The largest angle θ_max of the midpoint grows linearly with a small mismatch",
        linear_verdict(own, smallest_rad),
        # Begins with a word, as the table makes a capital of the first letter.
        f"The slope θ_max / Δα is {listed(own, slope)} at ε = {epsilons(own)}, within "
        f"{100.0 * LINEAR_WITHIN:g} % up to Δα = "
        f"{listed(own, lambda one: f'{one.linear_until_rad:.2g}')} rad, which is "
        f"{math.degrees(max(until)):.1g}° at most: the smallest mismatch of the paper's designs, "
        f"{SMALLEST_DESIGN_RAD:g} rad, is {SMALLEST_DESIGN_RAD / max(until):.0f} to "
        f"{SMALLEST_DESIGN_RAD / min(until):.0f} times larger. The slopes are "
        f"{listed(found['paper'], slope)} at the paper's settings and "
        f"{listed(found['undamped'], slope)} without damping",
        off,
        COMMAND,
    )


def saturation_statement(
    found: Mapping[str, Mapping[float, Saturation]], upto_rad: float, off: str
) -> Statement:
    """``upto_rad``: the end of the plateau that was looked at."""
    own, paper, undamped = (found[name] for name in ("standard", "paper", "undamped"))
    twice = max(abs(one.other_threshold_rad / one.threshold_rad - 1.0) for one in own.values())
    return Statement(
        "Beyond a threshold of the mismatch θ_max saturates",
        saturation_verdict(own),
        f"The thresholds are {listed(own, threshold)} rad at ε = {epsilons(own)} (two ways of "
        f"finding them differ by {100.0 * twice:.1g} %), the levels {listed(own, level)} rad. "
        f"Between {FLAT_FROM:g} thresholds and {upto_rad:g} rad the level still rises by "
        f"{listed(own, rise)} %; less the tilt that the mismatch gives the arch at rest it changes "
        f"by {listed(own, lambda one: f'{100.0 * one.rise_untilted:.1g}')} %. At the paper's "
        f"settings the thresholds are {listed(paper, threshold)} rad, the levels "
        f"{listed(paper, level)} rad, the rises {listed(paper, rise)} %; without damping "
        f"{listed(undamped, threshold)} rad, {listed(undamped, level)} rad and "
        f"{listed(undamped, rise)} %",
        off,
        COMMAND,
    )


def epsilons(found: Mapping[float, Saturation]) -> str:
    """The pre-compressions, in the order of all numbers of a sentence."""
    return ", ".join(f"{epsilon:g}" for epsilon in found)


def listed(found: Mapping[float, Saturation], told: Callable[[Saturation], str]) -> str:
    """A number at every pre-compression."""
    return ", ".join(told(one) for one in found.values())


def slope(one: Saturation) -> str:
    """Two digits, without an exponent."""
    return f"{float(f'{one.slope:.2g}'):.0f}"


def threshold(one: Saturation) -> str:
    """In rad."""
    return f"{one.threshold_rad:.2g}"


def level(one: Saturation) -> str:
    """In rad."""
    return f"{one.level_rad:.2f}"


def rise(one: Saturation) -> str:
    """In percent."""
    return f"{100.0 * one.rise:.0f}"


def largest_difference(rows: Sequence[Row], truth: Sequence[Row]) -> float:
    """Largest relative difference of the tilts at mismatches that both have."""
    right = {row["delta_alpha_rad"]: row["theta_max_rad"] for row in truth}
    off = [
        abs(row["theta_max_rad"] / right[row["delta_alpha_rad"]] - 1.0)
        for row in rows
        if row["theta_max_rad"] is not None and right.get(row["delta_alpha_rad"])
    ]
    return float(np.max(off)) if off else math.nan
