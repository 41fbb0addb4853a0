"""Landmarks of the symmetric arch: where it loses its stability, there and back, and how."""

from dataclasses import dataclass

import numpy as np
from scipy.optimize import brentq

from snapjump.composition import Simulation
from snapjump.statics.arch import Equilibrium, StaticArch
from snapjump.statics.branch import Branch, Point
from snapjump.statics.critical import Snap, arclength, find_snap, longest_step, refine, start_point

ANGLE_TOLERANCE = 1e-9  # of the arclength to the fold


@dataclass(frozen=True)
class Landmarks:
    """``snap``: the first instability and the state behind it; ``fold``: the largest angle on the
    branch of symmetric shapes; ``back_rad``: the angle at which the snapped arch loses stability
    when its clamps turn back; ``leaning``: the share of the critical mode's squared heights that
    is antisymmetric (0: the arch goes straight down, 1: it tips over)."""

    snap: Snap
    fold: Equilibrium
    back_rad: float
    leaning: float


def find_landmarks(simulation: Simulation, epsilon: float) -> Landmarks:
    """Both clamps turning alike; raises ArithmeticError where a branch is lost."""
    robot, mesh = simulation.robot, simulation.discretization
    snap = find_snap(robot, mesh, epsilon, 0.0)
    arch = StaticArch(robot, mesh, epsilon)
    branch = Branch(arch, 0.0)
    fold = symmetric_fold(branch)
    return Landmarks(
        snap,
        arch.equilibrium(fold.state, fold.left, fold.left),
        turned_back(branch, snap.after).left,
        antisymmetric_share(arch, snap.before),
    )


def symmetric_fold(branch: Branch) -> Point:
    """The largest angle on the branch that begins at flat clamps, buckled up."""
    point, following = branch.passing(
        start_point(branch), longest_step(branch.arch), lambda point: point.direction[-1] < 0.0
    )
    length = arclength(branch, point, following)

    def turn(share: float) -> float:
        return float(branch.step(point, share * length).direction[-1])

    return branch.step(point, length * brentq(turn, ANGLE_TOLERANCE, 1.0, xtol=ANGLE_TOLERANCE))


def turned_back(branch: Branch, after: Equilibrium) -> Point:
    """Where the snapped arch loses stability as the clamps turn back."""
    backwards = np.zeros(branch.arch.size - 2 * branch.arch.node_dofs + 1)
    backwards[-1] = -1.0
    start = branch.point(after.state, after.left, backwards)
    unstable = branch.passing(start, longest_step(branch.arch), lambda p: p.eigenvalue <= 0.0)
    return refine(branch, *unstable)


def antisymmetric_share(arch: StaticArch, critical: Equilibrium) -> float:
    """Of the squared heights of the mode in which a critical arch gives way."""
    arch.residual(critical.state, critical.left, critical.right)
    heights = arch.critical_mode()[1 :: arch.node_dofs]
    odd = 0.5 * (heights - heights[::-1])
    return float(odd @ odd / (heights @ heights))
