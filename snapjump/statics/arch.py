"""The clamped arch as a static problem: equilibria, energies and tangents at given clamp angles."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from snapjump.drive.base import ClampAngles
from snapjump.drive.constant_rate import ConstantRate
from snapjump.engine.equilibrate import equilibrate
from snapjump.engine.load.none import NoLoad
from snapjump.engine.model import Model, numbers_of
from snapjump.engine.newton import ROUNDING
from snapjump.engine.work import make_memory, sizes_of
from snapjump.frame.base import NO_MESH, STILL
from snapjump.frame.fixed import FixedFrame
from snapjump.robot.robot import Robot
from snapjump.statics.band import smallest_eigenvalue
from snapjump.statics.chain_state import chain_state
from snapjump.statics.elastica import buckled_arch, resampled
from snapjump.statics.lowest_point import lowest_height

Array = NDArray[np.float64]
Angles = tuple[float, float]
LONGEST_TURN_RAD = 0.05
SHORTEST_TURN_RAD = 1e-4


@dataclass(frozen=True)
class Equilibrium:
    """An equilibrium: nodes x, y (in L, from the middle of the mounts), clamp angles (rad),
    elastic energy (EI/L), the number of negative pivots (0: stable), the state vector, and how well
    it is known (L): the last correction of Newton's method."""

    x: Array
    y: Array
    left: float
    right: float
    energy: float
    negative_pivots: int
    state: Array
    accuracy: float

    @property
    def midpoint(self) -> float:
        """Height of the middle (in L), by the mean of the two middle nodes if there are two."""
        n = len(self.y)
        return float(0.5 * (self.y[(n - 1) // 2] + self.y[n // 2]))

    @property
    def lowest(self) -> float:
        """Height of the lowest point (in L), between nodes."""
        return lowest_height(self.y)


class StaticArch:
    """The beam in a fixed frame. Raises ArithmeticError where Newton's method fails.

    ``negative_pivots`` and ``accuracy`` (L) are those of the equilibrium that was solved for last;
    ``rounding`` (EI/L^2) is what rounding may leave of any residual. ``state``, ``gradient`` and
    ``band`` are the memory of what was solved for or evaluated last.
    """

    def __init__(self, robot: Robot, discretization: Any, epsilon: float):
        self.epsilon = epsilon
        self.discretization = discretization
        self.rod: Any = discretization.beam(robot)
        self.frame = FixedFrame.Body(0.5 * (1.0 - epsilon), 0.0)
        self.masses = discretization.masses()
        self.node_dofs = self.rod.node_dofs()
        self.size = self.node_dofs * len(self.masses)
        self.free = slice(self.node_dofs, self.size - self.node_dofs)
        self.rounding = ROUNDING * self.rod.axial_stiffness()
        self.negative_pivots, self.accuracy = 0, 0.0
        model = self._model(0.0, 0.0)
        self.memory = make_memory(sizes_of(model, len(self.masses)))
        self.state: Array = self.memory.state[:, 0]
        self.gradient: Array = self.memory.residual[self.free, 0]
        self.band: Array = self.memory.band[self.free, :, 0]

    def _model(self, left: float, right: float) -> Model:
        return Model(self.rod, self.frame, ConstantRate.Law(left, 10.0, 1.0, left - right))

    def guess(self, upward: bool = True) -> Array:
        """State of the exact arch between flat clamps, buckled up or down."""
        x, y = buckled_arch(self.epsilon, self.discretization.elements)
        chain = self.discretization.moving_elements
        skipped = self.rod.clamp_distance()
        return chain_state(
            self.rod, resampled(x, skipped, chain), resampled(y if upward else -y, skipped, chain)
        )

    def _run(
        self, state: Array, left: float, right: float, iterate: bool
    ) -> tuple[float, float, bool]:
        model = self._model(left, right)
        self.state[:] = state
        return equilibrate(model, numbers_of(model), self.masses, self.memory, iterate)

    def solve_equilibrium(self, state: Array, left: float, right: float) -> Array:
        """The equilibrium state near ``state`` at the given clamp angles (rad)."""
        negative, accuracy, failed = self._run(state, left, right, True)
        if failed:
            raise ArithmeticError(f"no equilibrium found at clamp angles {left:g}, {right:g} rad")
        self.negative_pivots, self.accuracy = int(negative), float(accuracy)
        return self.state.copy()

    def flat(self, delta_alpha: float = 0.0, upward: bool = True) -> Array:
        """The equilibrium between a flat left clamp and a right one at -delta_alpha (rad)."""
        state = self.solve_equilibrium(self.guess(upward), 0.0, 0.0)
        return self.turn(state, (0.0, 0.0), (0.0, -delta_alpha))

    def turn(self, state: Array, begin: Angles, end: Angles) -> Array:
        """What an equilibrium at clamp angles ``begin`` (left, right; rad) becomes while the clamps
        turn to ``end``: in steps that are halved where Newton fails."""
        length = max(abs(end[0] - begin[0]), abs(end[1] - begin[1]))
        longest = LONGEST_TURN_RAD / max(length, LONGEST_TURN_RAD)  # shares of the way
        past, back, done, step = state, 0.0, 0.0, longest
        while done < 1.0:
            ahead = min(done + step, 1.0)
            guess = state if back == 0.0 else state + (state - past) * ((ahead - done) / back)
            left, right = (b + ahead * (e - b) for b, e in zip(begin, end, strict=True))
            try:
                found = self.solve_equilibrium(guess, left, right)
            except ArithmeticError:
                step *= 0.5
                if step * length < SHORTEST_TURN_RAD:
                    raise
                continue
            past, state, back, done = state, found, ahead - done, ahead
            step = min(1.5 * step, longest)
        return state

    def residual(self, state: Array, left: float, right: float) -> Array:
        """Gradient of the energy with respect to the free coordinates."""
        self._run(state, left, right, False)
        return self.gradient.copy()

    def tangent_band(self) -> Array:
        """Tangent (lower band, (free, 6)) of the last state that was solved for or evaluated."""
        return np.ascontiguousarray(self.band)

    def stability(self) -> tuple[float, float, int]:
        """Smallest eigenvalue of the last tangent, what rounding makes of it, and the number of
        negative ones: a state is stable if there is none."""
        return smallest_eigenvalue(self.tangent_band(), np.empty(self.size - 2 * self.node_dofs))

    def critical_mode(self) -> Array:
        """Unit eigenvector of the last tangent's smallest eigenvalue, over free coordinates."""
        vector = np.empty(self.size - 2 * self.node_dofs)
        smallest_eigenvalue(self.tangent_band(), vector)
        return vector

    def equilibrium(self, state: Array, left: float, right: float) -> Equilibrium:
        """Describe a state in equilibrium."""
        angles = ClampAngles(left, right, 0.0, 0.0)
        tangents = self.frame.end_tangents(NO_MESH, NoLoad(), angles, state, STILL)
        energy = float(self.rod.internal_energy(state, tangents))
        return Equilibrium(
            state[0 :: self.node_dofs].copy(),
            state[1 :: self.node_dofs].copy(),
            left,
            right,
            energy,
            self.negative_pivots,
            state.copy(),
            self.accuracy,
        )
