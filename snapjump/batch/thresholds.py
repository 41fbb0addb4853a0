"""Thresholds of many robots: from a curve where that reaches, and computed elsewhere."""

from typing import Any

import numpy as np

from snapjump.arrays import Array
from snapjump.checks import ParameterError
from snapjump.composition import Simulation
from snapjump.scenes.frame_body import compression
from snapjump.statics.threshold import Threshold, symmetric_threshold
from snapjump.statics.threshold_curve import ThresholdCurve


def beam_of(simulation: Simulation) -> Any:
    """The dimensionless beam, which thresholds are of."""
    return simulation.discretization.beam(simulation.robot)


def check_curve(base: Simulation, curve: ThresholdCurve | None) -> None:
    """Require a curve of a beam like the simulation's. Raises ParameterError."""
    if curve is None:
        return
    given = curve.discretization.beam(curve.robot)
    needed = beam_of(base)
    if given != needed:
        raise ParameterError("curve", given, f"one of this robot and mesh, {needed}")


def covered(simulation: Simulation, curve: ThresholdCurve | None) -> bool:
    """Whether the curve is of the simulation's beam, and reaches its pre-compression."""
    if curve is None:
        return False
    own = beam_of(simulation) == curve.discretization.beam(curve.robot)
    return own and bool(curve.covers(compression(simulation)))


def thresholds(
    simulations: list[Simulation], curve: ThresholdCurve | None
) -> list[Threshold | None]:
    """The threshold of each from the curve; None where that does not reach, or is of another
    beam."""
    if curve is None:
        return [None] * len(simulations)
    shortenings = np.array([compression(simulation) for simulation in simulations])
    angles, depths = curve.values(np.clip(shortenings, curve.low, curve.high))
    return [
        Threshold(float(angle), float(depth), curve.angle_error) if covered(one, curve) else None
        for one, angle, depth in zip(simulations, angles, depths, strict=True)
    ]


def computed(base: Simulation, shortening: float) -> tuple[float, float]:
    """Critical angle (rad) and depth (L) of the simulation's beam; NaN where it has none."""
    try:
        found = symmetric_threshold(base.robot, base.discretization, shortening)
    except ArithmeticError:
        return np.nan, np.nan
    return found.alpha_rad, found.h1_bar


def critical_figures(base: Simulation, compressions: Array, curve: ThresholdCurve | None) -> Array:
    """Critical angles (rad) and depths (L) of the simulation's beam at many compressions (R): (2,
    R), NaN where there is none. The curve, if any, is of that beam."""
    figures = np.empty((2, len(compressions)))
    known = np.zeros(len(compressions), dtype=bool)
    if curve is not None:
        known = curve.covers(compressions)
        figures[:, known] = curve.values(compressions[known])
    others = compressions[~known].tolist()
    found = {shortening: computed(base, shortening) for shortening in dict.fromkeys(others)}
    figures[:, ~known] = np.array([found[each] for each in others]).reshape(-1, 2).T
    return figures
