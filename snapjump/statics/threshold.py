"""The symmetrically rotated arch's critical angle and depth: what every jump needs."""

import math
from dataclasses import dataclass
from functools import lru_cache

from snapjump.discretization.base import DiscretizationOptions
from snapjump.robot.robot import Robot
from snapjump.statics.arch import StaticArch
from snapjump.statics.branch import Branch
from snapjump.statics.critical import instability

APPROACH = 0.8  # of the angle's estimate: the branch is walked from there
MOST_DEVIATION = 0.4  # of the critical angle from its estimate


@dataclass(frozen=True)
class Threshold:
    """Critical angle (rad), depth of the lowest point below the mounts there (in L), and how well
    the angle is known (rad)."""

    alpha_rad: float
    h1_bar: float
    alpha_error_rad: float


def symmetric_threshold(
    robot: Robot, discretization: DiscretizationOptions, epsilon: float
) -> Threshold:
    """Threshold of the arch whose clamps turn alike; computed once for each beam.

    Its depth is the optimal mount height, its angle the scale that a jump's start is a share of.
    Raises ArithmeticError where no equilibrium is found, or where rounding spoils the angle.
    """
    # Frame, weight and clamps' rate are not of the beam.
    slender = Robot(length_m=robot.length_m, thickness_m=robot.thickness_m)
    alike = discretization.beam(slender) == discretization.beam(robot)
    return computed_threshold(slender if alike else robot, discretization, epsilon)


@lru_cache(maxsize=65536)
def computed_threshold(
    robot: Robot, discretization: DiscretizationOptions, epsilon: float
) -> Threshold:
    """The threshold of this robot's beam. Raises ArithmeticError."""
    arch = StaticArch(robot, discretization, epsilon)
    # Shallow arches snap at 2 sqrt(epsilon); the next term is a fit of the elastica's values.
    estimate = math.sqrt(epsilon) * (2.0 + 0.193 * epsilon)
    angle = APPROACH * estimate
    state = arch.turn(arch.flat(), (0.0, 0.0), (angle, angle))
    branch = Branch(arch, 0.0)
    farthest = (1.0 + MOST_DEVIATION) * estimate
    before, error = instability(branch, branch.point(state, angle), farthest)
    # Too shallow an arch, or too coarse a mesh for it: the branch is not one that snaps.
    if not abs(before.left - estimate) < MOST_DEVIATION * estimate:
        raise ArithmeticError(f"no critical angle near {estimate:g} rad")
    return Threshold(before.left, -before.lowest, error)
