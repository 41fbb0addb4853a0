"""The critical angle: where the arch loses stability, and where it snaps to."""

import math
from dataclasses import dataclass

import numpy as np

from snapjump.options.discretization import DiscretizationOptions
from snapjump.parameters.robot import Robot
from snapjump.statics.arch import Equilibrium, StaticArch
from snapjump.statics.branch import Branch, Point

LONGEST_STEP = 0.12  # of the continuation (norm of free coordinates and angle)
ANGLE_TOLERANCE = 1e-10
MOST_STEPS = 2000


@dataclass(frozen=True)
class Snap:
    """The equilibrium at which the arch loses stability, and the one it snaps to."""

    before: Equilibrium
    after: Equilibrium

    @property
    def alpha_rad(self) -> float:
        """Critical angle of the left clamp."""
        return self.before.left

    @property
    def h1_bar(self) -> float:
        """Depth of the lowest point below the mounts as the arch snaps (in L)."""
        return -self.before.lowest

    @property
    def h2_bar(self) -> float:
        """Depth of the snapped arch's midpoint below the mounts (in L)."""
        return -self.after.midpoint


def start_point(branch: Branch, upward: bool = True) -> Point:
    """The branch's point at a left angle of zero, reached from the symmetric arch."""
    arch = branch.arch
    state = arch.settle(arch.guess(upward), 0.0, 0.0)
    steps = max(1, int(np.ceil(abs(branch.delta_alpha) / 0.02)))
    for k in range(1, steps + 1):
        state = arch.settle(state, 0.0, -branch.delta_alpha * k / steps)
    return branch.point(state, 0.0)


def refine(branch: Branch, stable: Point, unstable: Point) -> Point:
    """The point between two where the smallest eigenvalue vanishes.

    Regula falsi (Illinois) in the arclength from the stable point, to ANGLE_TOLERANCE in the
    angle. At a fold the eigenvalue, at a pitchfork eigenvalue and angle, are linear in it.
    """
    length = float(
        np.append(
            unstable.state[branch.arch.free] - stable.state[branch.arch.free],
            unstable.left - stable.left,
        )
        @ stable.direction
    )
    low, high = 0.0, length
    f_low, f_high = stable.eigenvalue, unstable.eigenvalue
    point = stable
    for _ in range(60):
        middle = (low * f_high - high * f_low) / (f_high - f_low)
        previous = point
        point = branch.step(stable, middle)
        if abs(point.left - previous.left) < ANGLE_TOLERANCE and abs(high - low) < 1e-6 * length:
            break
        if abs(point.eigenvalue) < 1e-9 * max(abs(f_low), abs(f_high), 1.0):
            break
        if point.eigenvalue > 0.0:
            low, f_low = middle, point.eigenvalue
            f_high *= 0.5
        else:
            high, f_high = middle, point.eigenvalue
            f_low *= 0.5
    return point


def find_snap(
    robot: Robot, discretization: DiscretizationOptions, epsilon: float, delta_alpha: float
) -> Snap:
    """Where the arch with the right clamp lagging by ``delta_alpha`` snaps under slow loading.

    Raises ArithmeticError if no instability is found.
    """
    arch = StaticArch(robot, discretization, epsilon)
    branch = Branch(arch, delta_alpha)
    point = start_point(branch)
    # A shallow arch snaps at an angle of about 2 sqrt(epsilon).
    step = min(LONGEST_STEP, 0.5 * math.sqrt(epsilon))
    for count, following in enumerate(branch.follow(point, step)):
        if following.eigenvalue <= 0.0:
            break
        point = following
        if count > MOST_STEPS:
            raise ArithmeticError(f"no instability found up to {point.left:g} rad")
    critical = refine(branch, point, following)
    arch.negative_pivots = 0
    before = arch.equilibrium(critical.state, critical.left, critical.left - delta_alpha)
    after = snapped_state(arch, critical.left, delta_alpha)
    return Snap(before, after)


def snapped_state(arch: StaticArch, left: float, delta_alpha: float) -> Equilibrium:
    """The stable equilibrium on the other side at the given angles."""
    state = arch.settle(arch.guess(upward=False), 0.0, 0.0)
    steps = max(8, int(np.ceil(left / 0.02)))
    for k in range(1, steps + 1):
        share = k / steps
        state = arch.settle(state, share * left, share * (left - delta_alpha))
    return arch.equilibrium(state, left, left - delta_alpha)
