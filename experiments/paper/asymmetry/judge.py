"""Verdicts on how the tilt of a snap grows with the mismatch."""

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import curve_fit

from experiments.paper.settings import RANGES
from experiments.paper.statement import Statement, verdict
from snapjump.run.studies.base import Row

Array = NDArray[np.float64]
# The law is of tilts that come from the instability alone; beyond 0.01 rad the tilt that the
# mismatch gives the arch at rest shows.
FITTED_UPTO_RAD = 0.01
LINEAR_WITHIN = 0.05  # as linear counts a tilt that is this near to slope x mismatch
SMALL = 0.1  # shares of the level: below the tilt is taken as linear, for the second estimate
FLAT_FROM = 10.0  # thresholds, from where on the level is looked at


@dataclass(frozen=True)
class Saturation:
    """``slope``: rad per rad; ``level_rad``; ``threshold_rad``: the mismatch where the two lines
    meet; ``other_threshold_rad``: the same from the smallest tilts and the tilt at the end of the
    fit alone, without the law; ``misfit``: the largest relative difference from the law;
    ``exponent``: of the power of the mismatch that the smallest tilts grow by;
    ``linear_until_rad``: where the tilt has fallen 5 % behind the line; ``rise``: relative growth
    from ten thresholds to the mismatch that is asked for, ``rise_untilted``: the largest relative
    change on that way, less the tilt at rest."""

    slope: float
    level_rad: float
    threshold_rad: float
    other_threshold_rad: float
    misfit: float
    exponent: float
    linear_until_rad: float
    rise: float
    rise_untilted: float


def law(mismatch: Array, slope: float, threshold: float) -> Array:
    """The tilt (rad) at mismatches (rad)."""
    return np.asarray(slope * mismatch / np.sqrt(1.0 + (mismatch / threshold) ** 2))


def saturation(rows: Sequence[Row], upto_rad: float) -> Saturation:
    """Fit the law by the logarithms of tilts, so that small ones count as much as large ones."""
    snapped = [r for r in rows if r["theta_max_rad"] is not None and r["delta_alpha_rad"] > 0.0]
    snapped = sorted(snapped, key=lambda row: row["delta_alpha_rad"])
    lags = np.array([row["delta_alpha_rad"] for row in snapped])
    tilts = np.array([row["theta_max_rad"] for row in snapped])
    rest = np.array([row["theta_rest_rad"] for row in snapped])
    near = lags <= FITTED_UPTO_RAD * (1.0 + 1e-9)
    guess = np.log([tilts[0] / lags[0], tilts[near][-1] * lags[0] / tilts[0]])
    found, _ = curve_fit(
        lambda d, slope, threshold: np.log(law(d, np.exp(slope), np.exp(threshold))),
        lags[near], np.log(tilts[near]), guess,
    )  # fmt: skip
    slope, threshold = (float(value) for value in np.exp(found))
    ratios = tilts / lags
    line = float(np.mean(ratios[tilts <= SMALL * slope * threshold]))
    return Saturation(
        slope=slope,
        level_rad=slope * threshold,
        threshold_rad=threshold,
        other_threshold_rad=float(tilts[near][-1]) / line,
        misfit=float(np.abs(tilts[near] / law(lags[near], slope, threshold) - 1.0).max()),
        exponent=float(np.log(tilts[1] / tilts[0]) / np.log(lags[1] / lags[0])),
        linear_until_rad=fallen_behind(lags, ratios / line),
        rise=growth(lags, tilts, FLAT_FROM * threshold, upto_rad),
        rise_untilted=spread(lags, tilts - rest, FLAT_FROM * threshold, upto_rad),
    )


def fallen_behind(lags: Array, shares: Array) -> float:
    """The first mismatch where the share of the line is short of one; the last if there is none."""
    behind = np.flatnonzero(shares < 1.0 - LINEAR_WITHIN)
    if len(behind) == 0:
        return float(lags[-1])
    k = int(behind[0])
    if k == 0:
        return 0.0
    between = np.interp(LINEAR_WITHIN, 1.0 - shares[k - 1 : k + 1], np.log(lags[k - 1 : k + 1]))
    return float(np.exp(between))


def growth(lags: Array, tilts: Array, low: float, high: float) -> float:
    """Relative growth between two mismatches."""
    ends = np.interp([low, high], lags, tilts)
    return float(ends[1] / ends[0] - 1.0)


def spread(lags: Array, tilts: Array, low: float, high: float) -> float:
    """Largest over smallest between two mismatches, less one."""
    inside = tilts[(lags >= low) & (lags <= high * (1.0 + 1e-9))]
    between = np.append(inside, np.interp([low, high], lags, tilts))
    return float(between.max() / between.min() - 1.0)


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
