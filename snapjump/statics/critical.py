"""The critical angle: where the arch loses stability, and where it snaps to."""

import math
from dataclasses import dataclass
from itertools import count

import numpy as np

from snapjump.discretization.base import DiscretizationOptions
from snapjump.robot.robot import Robot
from snapjump.statics.arch import Equilibrium, StaticArch
from snapjump.statics.band import dot
from snapjump.statics.branch import Branch, Point
from snapjump.statics.rounding import COVERAGE, check_angle_error

LONGEST_STEP = 0.12  # of the continuation (norm of free coordinates and angle)
LENGTH_TOLERANCE = 1e-12
MOST_STEPS = 2000
MOST_NODE_STEPS = 5e6  # steps, times the nodes that each of them moves: half a minute of a core
MANY_NODES, MORE_NODES = 100, 1000
FARTHEST_RAD = math.pi


class NoStartError(ArithmeticError):
    """There is no stable arch whose branch could be followed."""


class NoSnapError(ArithmeticError):
    """The arch stays stable however far its clamps turn."""


@dataclass(frozen=True)
class Snap:
    """The equilibrium at which the arch loses stability, the one it snaps to, and how well its
    angle is known (rad): what rounding makes of it."""

    before: Equilibrium
    after: Equilibrium
    alpha_error_rad: float

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
    return branch.point(branch.arch.flat(branch.delta_alpha, upward), 0.0)


def arclength(branch: Branch, stable: Point, unstable: Point) -> float:
    """Distance of two points along the first one's direction."""
    moved = unstable.state[branch.arch.free] - stable.state[branch.arch.free]
    return dot(np.append(moved, unstable.left - stable.left), stable.direction)


def refine(branch: Branch, stable: Point, unstable: Point) -> Point:
    """The point between two where the smallest eigenvalue vanishes, to what rounding makes of it.

    Its root in the arclength from the stable point: at a fold the eigenvalue, at a pitchfork
    eigenvalue and angle, are linear in that.
    """
    from scipy.optimize import brentq  # plain arithmetic: equal bits on every processor

    end = arclength(branch, stable, unstable)
    points = {0.0: stable, end: unstable}

    def eigenvalue(length: float) -> float:
        point = points.get(length) or branch.step(stable, length)
        points[length] = point
        return point.eigenvalue if abs(point.eigenvalue) > point.eigenvalue_rounding else 0.0

    brentq(eigenvalue, 0.0, end, xtol=LENGTH_TOLERANCE)
    return min(points.values(), key=lambda point: abs(point.eigenvalue))


def angle_error(branch: Branch, stable: Point, unstable: Point, critical: Point) -> float:
    """Error of the critical angle (rad) by rounding of the smallest eigenvalue."""
    length = arclength(branch, stable, unstable)
    slope = (unstable.eigenvalue - stable.eigenvalue) / length
    along = max(critical.eigenvalue_rounding, abs(critical.eigenvalue)) / abs(slope)
    return COVERAGE * (along * abs(float(critical.direction[-1])) + branch.arch.accuracy)


def longest_step(arch: StaticArch) -> float:
    """Of a walk along the arch's branch: shorter where the whole branch is, in shallow arches,
    which snap at about 2 sqrt(epsilon), and with few nodes, whose norm is smaller; longer with very
    many."""
    nodes = len(arch.masses)
    few, many = math.sqrt(nodes / MANY_NODES), math.sqrt(nodes / MORE_NODES)
    return min(LONGEST_STEP * min(1.0, few), 0.5 * math.sqrt(arch.epsilon)) * max(1.0, many)


def instability(
    branch: Branch, start: Point, farthest_rad: float = FARTHEST_RAD
) -> tuple[Equilibrium, float]:
    """Where the branch, followed from a stable point on, loses its stability first, and how well
    its angle is known (rad).

    Raises ArithmeticError if no instability is found up to the farthest angle (NoSnapError), or if
    rounding spoils its angle.
    """
    if start.eigenvalue <= 0.0:
        raise NoStartError(f"the arch is not stable at {start.left:g} rad")
    steps, most = count(), min(MOST_STEPS, int(MOST_NODE_STEPS / len(branch.arch.masses)))

    def is_unstable(point: Point) -> bool:
        if point.eigenvalue <= 0.0:
            return True
        if not abs(point.left) < farthest_rad:
            raise NoSnapError(f"it is stable up to {point.left:g} rad")
        if next(steps) == most:
            raise ArithmeticError(f"no instability found in {most} steps, to {point.left:g} rad")
        return False

    point, following = branch.passing(start, longest_step(branch.arch), is_unstable)
    critical = refine(branch, point, following)
    error = angle_error(branch, point, following, critical)
    check_angle_error(branch.arch.discretization, error)
    branch.arch.negative_pivots = 0
    right = critical.left - branch.delta_alpha
    return branch.arch.equilibrium(critical.state, critical.left, right), error


def find_snap(
    robot: Robot, discretization: DiscretizationOptions, epsilon: float, delta_alpha: float
) -> Snap:
    """Where the arch with the right clamp lagging by ``delta_alpha`` snaps under slow loading.

    Raises ArithmeticError if there is no stable arch to start from (NoStartError), if it does not
    lose its stability (NoSnapError), if its branch is lost, or if rounding spoils its angle.
    """
    arch = StaticArch(robot, discretization, epsilon)
    branch = Branch(arch, delta_alpha)
    try:
        start = start_point(branch)
    except ArithmeticError as error:
        raise NoStartError(str(error)) from error
    before, error_rad = instability(branch, start)
    return Snap(before, snapped_state(arch, before.left, delta_alpha), error_rad)


def snapped_state(arch: StaticArch, left: float, delta_alpha: float) -> Equilibrium:
    """The stable equilibrium on the other side at the given angles."""
    state = arch.turn(arch.flat(upward=False), (0.0, 0.0), (left, left - delta_alpha))
    return arch.equilibrium(state, left, left - delta_alpha)
