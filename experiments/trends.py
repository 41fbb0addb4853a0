"""Trends of a curve: whether it is monotone, where it levels off, and how it saturates."""

from dataclasses import dataclass

import numpy as np
from scipy.optimize import curve_fit

from snapjump.arrays import Array


def counter_step(values: Array, rising: bool) -> float:
    """The largest way back that the curve ever goes, as a share of all its change.
    0 for a monotone curve; 1 or more for one that ends no further than it has come back."""
    upward = values if rising else -values
    back = float(np.max(np.maximum.accumulate(upward) - upward))
    change = float(upward[-1] - upward[0])
    return back / change if change > 0.0 else np.inf


def between(places: Array, values: Array, low: float, high: float) -> Array:
    """The values between two places, those at either end by interpolation."""
    inside = places[(places > low) & (places < high)]
    return np.interp([low, *inside, high], places, values)


def saturating(places: Array, slope: float, threshold: float) -> Array:
    """slope * place, and slope * threshold far beyond the threshold: how the amplitude of an
    unstable mode with a cubic limit depends on where it started."""
    return np.asarray(slope * places / np.sqrt(1.0 + (places / threshold) ** 2))


def fit_saturating(places: Array, values: Array) -> tuple[float, float]:
    """Slope and threshold of the law above, by logarithms: small values count like large ones."""
    guess = np.log([values[0] / places[0], values[-1] * places[0] / values[0]])
    found, _ = curve_fit(
        lambda at, slope, threshold: np.log(saturating(at, np.exp(slope), np.exp(threshold))),
        places, np.log(values), guess,
    )  # fmt: skip
    slope, threshold = np.exp(found)
    return float(slope), float(threshold)


SMALL = 0.1  # shares of the level: below a value is taken as linear, for the second estimate


@dataclass(frozen=True)
class Saturation:
    """``slope``: rad per rad; ``level_rad``; ``threshold_rad``: the place where the two lines
    meet; ``other_threshold_rad``: the same from the smallest values and that at the end of the
    fit alone, without the law; ``misfit``: the largest relative difference from the law;
    ``exponent``: of the power of the place that the smallest values grow by;
    ``linear_until_rad``: where the value has fallen behind the line; ``rise``: relative growth
    from so many thresholds to the end of the plateau, ``rise_untilted``: the largest relative
    change on that way, less what is there without the instability."""

    slope: float
    level_rad: float
    threshold_rad: float
    other_threshold_rad: float
    misfit: float
    exponent: float
    linear_until_rad: float
    rise: float
    rise_untilted: float


def saturation_of(
    places: Array,
    values: Array,
    rest: Array,
    fitted_upto: float,
    plateau: tuple[float, float],
    deviation: float,
) -> Saturation:
    """``rest``: what is there without the instability; ``plateau``: from how many thresholds to
    which place the level is looked at; ``deviation``: the share by which a value is behind the
    line."""
    near = places <= fitted_upto * (1.0 + 1e-9)
    slope, threshold = fit_saturating(places[near], values[near])
    ratios = values / places
    line = float(np.mean(ratios[values <= SMALL * slope * threshold]))
    level, untilted = (
        between(places, one, plateau[0] * threshold, plateau[1]) for one in (values, values - rest)
    )
    return Saturation(
        slope=slope,
        level_rad=slope * threshold,
        threshold_rad=threshold,
        other_threshold_rad=float(values[near][-1]) / line,
        misfit=float(np.abs(values[near] / saturating(places[near], slope, threshold) - 1.0).max()),
        exponent=float(np.log(values[1] / values[0]) / np.log(places[1] / places[0])),
        linear_until_rad=fallen_behind(places, ratios / line, 1.0 - deviation),
        rise=float(level[-1] / level[0] - 1.0),
        rise_untilted=float(untilted.max() / untilted.min() - 1.0),
    )


def fallen_behind(places: Array, shares: Array, least: float) -> float:
    """The first place where the share of the line is less; the last one if there is none."""
    behind = np.flatnonzero(shares < least)
    if len(behind) == 0:
        return float(places[-1])
    k = int(behind[0])
    if k == 0:
        return 0.0
    return float(np.exp(np.interp(-least, -shares[k - 1 : k + 1], np.log(places[k - 1 : k + 1]))))


@dataclass(frozen=True)
class Plateau:
    """The ramp that fits a curve best: a straight line up to ``threshold``, a constant beyond.

    slope_before, slope_after: of straight lines through the curve's two parts; swing: from the
    lowest to the highest value beyond the threshold; level: their mean.
    """

    threshold: float
    slope_before: float
    slope_after: float
    swing: float
    level: float

    @property
    def levelling(self) -> float:
        """The slope beyond the threshold as a share of that before, without signs."""
        return abs(self.slope_after / self.slope_before)

    @property
    def relative_swing(self) -> float:
        """The swing as a share of the level."""
        return self.swing / abs(self.level)


LEAST = 5  # points on either side of a threshold


def plateau(places: Array, values: Array) -> Plateau:
    """The best ramp, its threshold at one of the places."""

    def misfit(k: int) -> float:
        ramp = np.stack([np.ones_like(places), np.minimum(places, places[k])], axis=1)
        return float(np.linalg.lstsq(ramp, values, rcond=None)[1].sum())

    best = min(range(LEAST - 1, len(places) - LEAST + 1), key=misfit)
    beyond = values[best:]
    return Plateau(
        float(places[best]),
        float(np.polyfit(places[: best + 1], values[: best + 1], 1)[0]),
        float(np.polyfit(places[best:], beyond, 1)[0]),
        float(np.ptp(beyond)),
        float(np.mean(beyond)),
    )


@dataclass(frozen=True)
class Line:
    """intercept + slope * place, by least squares, and where it is off most."""

    slope: float
    intercept: float
    deviation_percent: float  # the largest, of the value there
    worst_place: float

    def at(self, places: Array) -> Array:
        """The line's values."""
        return self.intercept + self.slope * places


def straight_line(places: Array, values: Array) -> Line:
    """The best line through a curve."""
    slope, intercept = np.polyfit(places, values, 1)
    off = 100.0 * np.abs((intercept + slope * places) / values - 1.0)
    worst = int(np.argmax(off))
    return Line(float(slope), float(intercept), float(off[worst]), float(places[worst]))


def power(places: Array, values: Array) -> float:
    """The exponent of the power law through positive values."""
    return float(np.polyfit(np.log(places), np.log(values), 1)[0])


def relative_range(values: Array) -> float:
    """From the lowest to the highest, as a share of the mean."""
    return float(np.ptp(values) / np.mean(values))
