"""Whole branches of the arch whose clamps turn alike: over their folds, and from one pitchfork to
the other."""

from collections.abc import Iterator
from dataclasses import replace
from itertools import islice

import numpy as np

from snapjump.statics.arch import Equilibrium, StaticArch
from snapjump.statics.branch import Branch, Point
from snapjump.statics.critical import refine, start_point

STEP, FINE_STEP = 0.05, 0.012  # norm of free coordinates and angle
FARTHEST_RAD = 1.4
MOST_POINTS = 400


def symmetric_path(branch: Branch, upward: bool, near_rad: float) -> Iterator[Point]:
    """To both sides of flat clamps, over the folds until the clamps are flat again; in steps that
    are fine beyond ``near_rad``."""
    forwards = start_point(branch, upward)
    backwards = branch.point(forwards.state, 0.0, -forwards.direction)
    yield from list(_walk(branch, backwards, near_rad))[::-1]
    yield forwards
    yield from _walk(branch, forwards, near_rad)


def _walk(branch: Branch, first: Point, near_rad: float) -> Iterator[Point]:
    """From flat clamps to the farthest angle, or over the fold until they are flat again; with the
    very point at which stability is lost, as the first that is unstable."""
    point, side = first, np.sign(first.direction[-1])
    for _ in range(MOST_POINTS):
        step = FINE_STEP if abs(point.left) > near_rad else STEP
        following = next(branch.follow(point, step), None)
        if following is None or not 0.0 < side * following.left < FARTHEST_RAD:
            return
        if point.eigenvalue > 0.0 >= following.eigenvalue:
            yield replace(refine(branch, point, following), negative_eigenvalues=1)
        yield following
        point = following


def leaning_path(arch: StaticArch, critical: Equilibrium) -> Iterator[Point]:
    """Shapes that are not symmetric, from one pitchfork to the other: it is entered along the
    critical mode, and turns round at its end into its own mirror image."""
    branch = Branch(arch, 0.0, symmetric=False)
    arch.residual(critical.state, critical.left, critical.right)
    mode = np.append(arch.critical_mode(), 0.0)
    seed = Point(critical.state, critical.left, 0.0, 0.0, 1, mode)
    yield seed
    for point in islice(branch.follow(seed, STEP), MOST_POINTS):
        if point.direction[-1] > 0.0:
            return
        yield point
