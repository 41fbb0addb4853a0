"""What is said of the tilt of a snap and the mismatch."""

import math
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from experiments.paper.base import Said, listed, paragraphs, prose
from experiments.paper.limits import LIMITS
from experiments.paper.settings import RANGES
from snapjump.run.studies.base import Row

TITLE = "How asymmetric a snap becomes"
FIGURE = prose("""θ_max against the mismatch: left with the paper's range shaded, and dash-dotted
    what is left without the tilt at rest; right by logarithms, the law at standard drawn thin, its
    threshold marked on it""")
# Laws (:class:`experiments.trends.Saturation`) by setting and pre-compression.
Laws = Mapping[str, Mapping[float, Any]]
SMALLEST_DESIGN_RAD = RANGES["delta_alpha_rad"][0]
LINEAR_PERCENT = 100.0 * LIMITS["asymmetry.linear.deviation"].confirmed
TOLD: dict[str, Callable[[float], str]] = {
    "slope": lambda value: f"{float(f'{value:.2g}'):.0f}",  # two digits, without an exponent
    "threshold_rad": "{:.2g}".format,
    "level_rad": "{:.2f}".format,
    "linear_until_rad": "{:.2g}".format,
    "rise": lambda share: f"{100.0 * share:.0f}",
    "rise_untilted": lambda share: f"{100.0 * share:.1g}",
}


def each(laws: Mapping[float, Any], key: str) -> str:
    """A number at every pre-compression."""
    return ", ".join(TOLD[key](getattr(one, key)) for one in laws.values())


def linear(found: Laws, accuracy: str) -> Said:
    """Slopes, and how far they hold. Begins with a word, as the table makes a capital of the first
    letter."""
    own, paper, undamped = (found[name] for name in ("standard", "paper", "undamped"))
    until = [one.linear_until_rad for one in own.values()]
    return Said(
        "The largest angle θ_max of the midpoint grows linearly with a small mismatch",
        f"""The slope θ_max / Δα is {each(own, "slope")} at ε = {listed(own)}, within
        {LINEAR_PERCENT:g} % up to Δα = {each(own, "linear_until_rad")} rad, which is
        {math.degrees(max(until)):.1g}° at most: the smallest mismatch of the paper's designs,
        {SMALLEST_DESIGN_RAD:g} rad, is {SMALLEST_DESIGN_RAD / max(until):.0f} to
        {SMALLEST_DESIGN_RAD / min(until):.0f} times larger. The slopes are {each(paper, "slope")}
        at the paper's settings and {each(undamped, "slope")} without damping""",
        accuracy,
    )


def saturates(found: Laws, flat_from: float, upto_rad: float, accuracy: str) -> Said:
    """Thresholds, levels, and what they still rise by up to the end of the plateau."""
    own, paper, undamped = (found[name] for name in ("standard", "paper", "undamped"))
    twice = max(abs(one.other_threshold_rad / one.threshold_rad - 1.0) for one in own.values())
    return Said(
        "Beyond a threshold of the mismatch θ_max saturates",
        f"""The thresholds are {each(own, "threshold_rad")} rad at ε = {listed(own)} (two
        ways of finding them differ by {100.0 * twice:.1g} %), the levels {each(own, "level_rad")}
        rad. Between {flat_from:g} thresholds and {upto_rad:g} rad the level still rises by
        {each(own, "rise")} %; less the tilt that the mismatch gives the arch at rest it changes by
        {each(own, "rise_untilted")} %. At the paper's settings the thresholds are
        {each(paper, "threshold_rad")} rad, the levels {each(paper, "level_rad")} rad, the rises
        {each(paper, "rise")} %; without damping {each(undamped, "threshold_rad")} rad,
        {each(undamped, "level_rad")} rad and {each(undamped, "rise")} %""",
        accuracy,
    )


def laws(flat_from: float, upto_rad: float) -> str:
    """Above the table of laws."""
    return prose(f"""Slope, level and threshold of the law; how far it is linear (within
        {LINEAR_PERCENT:g} %); how the level rises from {flat_from:g} thresholds to {upto_rad:g}
        rad""")


def told(found: Laws, sweeps: Mapping[float, Sequence[Row]], fitted_upto_rad: float) -> list[str]:
    """What is shown and fitted, and what differs; ``sweeps``: at standard."""
    own = found["standard"]
    misfit = max(one.misfit for laws in found.values() for one in laws.values())
    far = max(one.threshold_rad for one in own.values())
    faster, freely = (
        [found[setting][epsilon].slope / own[epsilon].slope for epsilon in own]
        for setting in ("paper", "undamped")
    )
    first = min(own)
    rows = sorted(sweeps[first], key=lambda row: row["delta_alpha_rad"])
    low, high = (rows[k]["delta_alpha_rad"] for k in (0, -1))
    later = rows[0]["theta_later_rad"] / low
    large = [row for row in rows if row["delta_alpha_rad"] >= fitted_upto_rad]
    same = all(row["theta_later_rad"] == row["theta_max_rad"] for row in large)
    return paragraphs(f"""The same snaps at three pre-compressions and at mismatches from {low:g} to
        {high:g} rad. θ_max is the largest absolute tangent angle at the midpoint until the snap
        ends.

        The threshold is found by fitting θ_max = slope · Δα / √(1 + (Δα / threshold)²) to all
        mismatches up to {fitted_upto_rad:g} rad, by logarithms: that is how the amplitude of an
        unstable mode with a cubic limit depends on where it started. No snap is farther than
        {100.0 * misfit:.1f} % from it. For comparison the threshold is also taken as θ_max at
        {fitted_upto_rad:g} rad over the mean slope of the smallest.

        Every design in the paper's range of mismatches, shaded, snaps beyond the threshold, by a
        factor of {SMALLEST_DESIGN_RAD / far:.0f} at least. What the mismatch still changes there
        is the tilt at rest, and when the snap happens.

        At the paper's settings the slope is {min(faster):.1f} to {max(faster):.1f} times that of
        the converged model, without damping {min(freely):.1f} to {max(freely):.1f} times.
        Kelvin-Voigt damping resists bending as such, and so holds back the asymmetric mode whose
        net stiffness is lost. The damping of implicit Euler goes with the net stiffness: it stills
        vibrations, but does not slow down what buckles. How the slope depends on the rate of the
        clamps: the section on symmetric and asymmetric snaps.

        If the vibration after the snap is counted as well (`theta_later_rad`), the slope at
        ε = {first:g} is {later:.0f} instead of {own[first].slope:.0f} and the angles from
        {fitted_upto_rad:g} rad on {"are the same" if same else "differ"}. Without damping the
        vibration goes on, and its largest angle depends on the finest detail.""")
