"""The law of saturation: how the tilt of a snap grows with the mismatch, and where it stops.

The asymmetric mode's amplitude a obeys da/dt = g(t) a - c a^3 while the arch is unstable; from a
small a_0 it comes to G a_0 / sqrt(1 + H a_0^2), whatever g(t) is. So theta_max is
slope d / sqrt(1 + (d / threshold)^2) of the mismatch d, and its level beyond is slope x threshold.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import curve_fit

from snapjump.studies.base import Row

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
