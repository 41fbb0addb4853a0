"""Branches of equilibria: pseudo-arclength continuation in the clamp angle (Keller 1977)."""

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from snapjump.engine.newton import LARGEST_SHAKE, SHRINKING
from snapjump.statics.arch import StaticArch
from snapjump.statics.band import dot, solve_bordered

Array = NDArray[np.float64]
ANGLE_DIFFERENCE = 1e-6
TOLERANCE = 1e-9
MOST_ITERATIONS = 60


@dataclass(frozen=True)
class Point:
    """A point of a branch: state, left clamp angle (rad), smallest eigenvalue of the tangent, what
    rounding makes of it, the number of negative ones, and the branch's unit tangent (free
    coordinates, angle).
    """

    state: Array
    left: float
    eigenvalue: float
    eigenvalue_rounding: float
    negative_eigenvalues: int
    direction: Array


class Branch:
    """The branch of a :class:`StaticArch` with the right clamp lagging by ``delta_alpha``."""

    def __init__(self, arch: StaticArch, delta_alpha: float, symmetric: bool = True):
        """``symmetric``: keep to mirror-symmetric shapes if ``delta_alpha`` is 0."""
        self.arch = arch
        self.delta_alpha = delta_alpha
        self.symmetric = symmetric and delta_alpha == 0.0

    def _residual(self, state: Array, left: float) -> Array:
        return self.arch.residual(state, left, left - self.delta_alpha)

    def _slope(self, state: Array, left: float) -> Array:
        """d(residual)/d(left)."""
        ahead = self._residual(state, left + ANGLE_DIFFERENCE)
        behind = self._residual(state, left - ANGLE_DIFFERENCE)
        return (ahead - behind) / (2.0 * ANGLE_DIFFERENCE)

    def _mirrored(self, change: Array) -> Array:
        """A change of the free coordinates without its antisymmetric part, on symmetric branches:
        at the pitchfork that part is undetermined and rounding would fill it."""
        if not self.symmetric:
            return change
        nodes = change.reshape(-1, self.arch.node_dofs)
        # x and, where nodes turn, the rotation change their sign in the mirror.
        mirror = np.array([-1.0, 1.0, -1.0])[: self.arch.node_dofs]
        return (0.5 * (nodes + mirror * nodes[::-1])).ravel()

    def _described(self, state: Array, left: float, towards: Array) -> Point:
        """The point of an equilibrium, with the branch's tangent on the side of ``towards``."""
        slope = self._slope(state, left)
        self._residual(state, left)
        free, turn = solve_bordered(
            self.arch.tangent_band(), slope, towards[:-1], towards[-1], np.zeros(len(slope)), 1.0
        )
        direction = np.append(self._mirrored(free), turn)
        direction /= math.sqrt(dot(direction, direction))
        if dot(direction, towards) < 0.0:
            direction = -direction
        state = self.arch.state.copy()
        return Point(state, left, *self.arch.stability(), direction)

    def point(self, state: Array, left: float, towards: Array | None = None) -> Point:
        """The point of the branch at a given angle; by default facing larger angles."""
        state = self.arch.solve_equilibrium(state, left, left - self.delta_alpha)
        if towards is None:
            towards = np.append(np.zeros(self.arch.size - 2 * self.arch.node_dofs), 1.0)
        return self._described(state, left, towards)

    def step(self, point: Point, length: float) -> Point:
        """The next point, ``length`` further along the branch.

        Raises ArithmeticError if Newton's method fails: if its corrections grow small neither
        against the length nor, with the residual, down to what rounding leaves of them.
        """
        free = self.arch.free
        ahead = point.direction
        state = point.state.copy()
        state[free] += length * ahead[:-1]
        left = point.left + length * ahead[-1]
        last, largest = math.inf, math.inf
        for _ in range(MOST_ITERATIONS):
            slope = self._slope(state, left)
            residual = self._residual(state, left)
            excess = dot(np.append(state[free] - point.state[free], left - point.left), ahead)
            change, turn = solve_bordered(
                self.arch.tangent_band(), slope, ahead[:-1], ahead[-1], -residual, length - excess
            )
            change = self._mirrored(change)
            state[free] += change
            left = float(left + turn)
            size = max(float(np.abs(change).max()), abs(turn))
            if not size < 1.0:
                break
            before, largest = largest, float(np.abs(residual).max())
            shaken = SHRINKING * last <= size <= LARGEST_SHAKE
            if size < TOLERANCE or (shaken and max(before, largest) <= self.arch.rounding):
                self.arch.accuracy = size
                return self._described(state, left, ahead)
            last = size
        raise ArithmeticError(f"the branch was lost at a clamp angle of {left:g} rad")

    def follow(self, point: Point, length: float) -> Iterator[Point]:
        """Walk along the branch with steps of at most ``length``, shortened where needed."""
        step = length
        while True:
            try:
                point = self.step(point, step)
            except ArithmeticError:
                step *= 0.5
                if step < 1e-6 * length:
                    return
                continue
            step = min(length, 1.5 * step)
            yield point

    def passing(
        self, start: Point, length: float, passed: Callable[[Point], bool]
    ) -> tuple[Point, Point]:
        """The last point that has not passed something on the way from ``start``, and the next one.

        Raises ArithmeticError where the branch is lost before.
        """
        point = start
        for following in self.follow(point, length):
            if passed(following):
                return point, following
            point = following
        raise ArithmeticError(f"the branch was lost at a clamp angle of {point.left:g} rad")
