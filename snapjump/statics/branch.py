"""Branches of equilibria: pseudo-arclength continuation in the clamp angle (Keller 1977)."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import solveh_banded
from scipy.sparse import block_array, diags_array, eye_array
from scipy.sparse.linalg import splu

from snapjump.statics.arch import StaticArch

Array = NDArray[np.float64]
ANGLE_DIFFERENCE = 1e-6
ROUNDING = 1e-15  # of the largest entry
TOLERANCE = 1e-9
MOST_ITERATIONS = 25
SAFELY_STABLE = 4.0  # smallest eigenvalue from which the tangent is well conditioned


@dataclass(frozen=True)
class Point:
    """A point of a branch: state, left clamp angle (rad), smallest eigenvalue of the
    tangent and number of negative ones, and the branch's unit tangent (free coordinates, angle).
    """

    state: Array
    left: float
    eigenvalue: float
    negative_eigenvalues: int
    direction: Array


def solve_bordered(
    band: Array, column: Array, row: Array, corner: float, right: Array, last: float, stable: bool
) -> tuple[Array, float]:
    """Solve [[K, column], [row, corner]] (x, z) = (right, last), K being a lower band (6, size).

    Far from an instability K is eliminated as a block. The whole matrix is regular at a fold,
    where K alone is not: there it is factored as a whole.
    """
    size = band.shape[1]
    if stable:
        both = solveh_banded(band, np.column_stack([right, column]), lower=True)
        z = (last - row @ both[:, 0]) / (corner - row @ both[:, 1])
        return both[:, 0] - z * both[:, 1], float(z)
    diagonals = [band[k, : size - k] for k in range(6)]
    square = diags_array(
        diagonals + diagonals[1:], offsets=[0, -1, -2, -3, -4, -5, 1, 2, 3, 4, 5], format="csc"
    )
    bordered = block_array(
        [[square, column[:, None]], [row[None, :], np.array([[corner]])]], format="csc"
    )
    try:
        factors = splu(bordered)
    except RuntimeError:
        # Singular to the last bit: the very pitchfork, whose direction the caller leaves out.
        rounding = ROUNDING * float(np.abs(band[0]).max())
        factors = splu(bordered + rounding * eye_array(size + 1, format="csc"))
    solution = factors.solve(np.append(right, last))
    return solution[:-1], float(solution[-1])


class Branch:
    """The branch of a :class:`StaticArch` with the right clamp lagging by ``delta_alpha``."""

    def __init__(self, arch: StaticArch, delta_alpha: float, symmetric: bool = True):
        """``symmetric``: keep to mirror-symmetric shapes if ``delta_alpha`` is 0."""
        self.arch = arch
        self.delta_alpha = delta_alpha
        self.symmetric = symmetric and delta_alpha == 0.0

    def _residual(self, state: Array, left: float) -> Array:
        return self.arch.residual(state, left, left - self.delta_alpha)

    def _linear(self, state: Array, left: float) -> tuple[Array, Array]:
        """Residual and d(residual)/d(left); the tangent stays in the arch's memory."""
        ahead = self._residual(state, left + ANGLE_DIFFERENCE)
        behind = self._residual(state, left - ANGLE_DIFFERENCE)
        return self._residual(state, left), (ahead - behind) / (2.0 * ANGLE_DIFFERENCE)

    def _mirrored(self, change: Array) -> Array:
        """A change of the free coordinates without its antisymmetric part, on symmetric branches:
        at the pitchfork that part is undetermined and rounding would fill it."""
        if not self.symmetric:
            return change
        nodes = change.reshape(-1, self.arch.node_dofs)
        # x and, where nodes turn, the rotation change their sign in the mirror.
        mirror = np.array([-1.0, 1.0, -1.0])[: self.arch.node_dofs]
        return (0.5 * (nodes + mirror * nodes[::-1])).ravel()

    def _direction(self, state: Array, left: float, towards: Array, stable: bool) -> Array:
        """Unit tangent of the branch, on the side of ``towards``."""
        _, slope = self._linear(state, left)
        size = len(slope)
        free, turn = solve_bordered(
            self.arch.tangent_band(), slope, towards[:-1], towards[-1], np.zeros(size), 1.0, stable
        )
        direction = np.append(self._mirrored(free), turn)
        direction /= np.linalg.norm(direction)
        return direction if direction @ towards >= 0.0 else -direction

    def point(self, state: Array, left: float, towards: Array | None = None) -> Point:
        """The settled point of the branch at a given angle; by default facing larger angles."""
        state = self.arch.settle(state, left, left - self.delta_alpha)
        if towards is None:
            towards = np.append(np.zeros(self.arch.size - 2 * self.arch.node_dofs), 1.0)
        direction = self._direction(state, left, towards, stable=False)
        self._residual(state, left)
        return Point(state, left, *self.arch.stability(), direction)

    def step(self, point: Point, length: float) -> Point:
        """The next point, ``length`` further along the branch.

        Raises ArithmeticError if Newton's method fails.
        """
        free = self.arch.free
        state = point.state.copy()
        state[free] += length * point.direction[:-1]
        left = point.left + length * point.direction[-1]
        stable = point.eigenvalue > SAFELY_STABLE
        for _ in range(MOST_ITERATIONS):
            residual, slope = self._linear(state, left)
            moved = np.append(state[free] - point.state[free], left - point.left)
            excess = moved @ point.direction - length
            ahead = point.direction
            change, turn = solve_bordered(
                self.arch.tangent_band(),
                slope,
                ahead[:-1],
                ahead[-1],
                -residual,
                -float(excess),
                stable,
            )
            change = self._mirrored(change)
            state[free] += change
            left += turn
            size = max(float(np.abs(change).max()), abs(turn))
            if not size < 1.0:
                break
            if size < TOLERANCE:
                direction = self._direction(state, left, point.direction, stable)
                self._residual(state, left)
                state = self.arch.memory.state[:, 0].copy()
                return Point(state, left, *self.arch.stability(), direction)
        raise ArithmeticError(f"the branch was lost at a clamp angle of {left:g} rad")

    def follow(self, point: Point, length: float) -> Iterator[Point]:
        """Walk along the branch with steps of at most ``length``, shortened where needed."""
        step = length
        while True:
            try:
                point = self.step(point, step)
            except (ArithmeticError, np.linalg.LinAlgError):
                step *= 0.5
                if step < 1e-6 * length:
                    return
                continue
            step = min(length, 1.5 * step)
            yield point
