"""The clamped arch as a static problem: equilibria, energies and tangents at given clamp angles."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import eig_banded, solveh_banded

from snapjump.clamp.base import ClampAngles
from snapjump.clamp.constant_rate import ConstantRate
from snapjump.contact.none import NoContact
from snapjump.damping.none import NoDamping
from snapjump.discretization.base import clamp_offset, internal_energy, node_dofs, turn_length
from snapjump.engine.clock import ROWS
from snapjump.engine.equilibrate import equilibrate
from snapjump.engine.model import Model, numbers_of
from snapjump.engine.work import NO_MESH, make_work
from snapjump.frame.base import STILL, end_tangents
from snapjump.frame.fixed import FixedFrame
from snapjump.friction.none import NoFriction
from snapjump.load.none import NoLoad
from snapjump.options.discretization import DiscretizationOptions
from snapjump.parameters.robot import Robot
from snapjump.statics.chain_state import chain_state
from snapjump.statics.elastica import buckled_arch, resampled
from snapjump.statics.lowest_point import lowest_height

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Equilibrium:
    """A settled shape: nodes x, y (in L, from the middle of the mounts), clamp angles (rad),
    elastic energy (EI/L), the number of negative pivots (0: stable), and the state vector."""

    x: Array
    y: Array
    left: float
    right: float
    energy: float
    negative_pivots: int
    state: Array

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
    """The beam in a fixed frame. Raises ArithmeticError where Newton's method fails."""

    def __init__(self, robot: Robot, discretization: DiscretizationOptions, epsilon: float):
        self.epsilon = epsilon
        self.discretization = discretization
        self.rod = discretization.member(robot)
        self.frame = FixedFrame(0.5 * (1.0 - epsilon), 0.0)
        self.masses = discretization.masses()
        self.node_dofs = node_dofs(self.rod)
        self.size = self.node_dofs * len(self.masses)
        self.free = slice(self.node_dofs, self.size - self.node_dofs)
        model = self._model(0.0, 0.0)
        self.memory = make_work(
            len(self.masses), 0, 2, ROWS, len(numbers_of(model)), 1, self.node_dofs
        )

    def _model(self, left: float, right: float) -> Model:
        clamp = ConstantRate(left, 10.0, 1.0, left - right)
        return Model(self.rod, self.frame, clamp, NoContact(), NoFriction(), NoDamping(), NoLoad())

    def guess(self, upward: bool = True) -> Array:
        """State of the exact arch between flat clamps, buckled up or down."""
        x, y = buckled_arch(self.epsilon, self.discretization.elements)
        chain = self.discretization.moving_elements
        skipped = clamp_offset(self.rod)
        return chain_state(
            self.rod,
            resampled(x, skipped, chain),
            resampled(y if upward else -y, skipped, chain),
        )

    def _run(self, state: Array, left: float, right: float, iterate: bool) -> tuple[float, bool]:
        model = self._model(left, right)
        self.memory.state[:, 0] = state
        return equilibrate(model, numbers_of(model), self.masses, self.memory, iterate)

    def settle(self, state: Array, left: float, right: float) -> Array:
        """The equilibrium state near ``state`` at the given clamp angles (rad)."""
        negative, failed = self._run(state, left, right, True)
        if failed:
            raise ArithmeticError(f"no equilibrium found at clamp angles {left:g}, {right:g} rad")
        self.negative_pivots = int(negative)
        return self.memory.state[:, 0].copy()

    def residual(self, state: Array, left: float, right: float) -> Array:
        """Gradient of the energy with respect to the free coordinates."""
        placed = state.copy()
        offset = clamp_offset(self.rod)
        half = self.frame.half_span
        last = self.size - self.node_dofs
        placed[:2] = -half + offset * np.cos(left), -offset * np.sin(left)
        placed[last : last + 2] = half - offset * np.cos(right), -offset * np.sin(right)
        if self.node_dofs == 3:
            placed[2], placed[last + 2] = turn_length(self.rod) * np.array([-left, right])
        self._run(placed, left, right, False)
        return self.memory.system.residual[self.free, 0].copy()

    def tangent_band(self) -> Array:
        """Tangent (lower band, (6, free)) of the last state that was settled or evaluated."""
        return np.ascontiguousarray(self.memory.system.band[self.free, :, 0].T)

    def stability(self) -> tuple[float, int]:
        """Smallest eigenvalue of the last tangent and the number of negative ones (of the first
        three): a state is stable if there is none."""
        values = eig_banded(
            self.tangent_band(), lower=True, eigvals_only=True, select="i", select_range=(0, 2)
        )
        return float(values[0]), int(np.sum(values < 0.0))

    def asymmetric_stiffness(self) -> float:
        """1 / (c K^-1 c) of the last tangent K, c being one full wave of the heights.

        On the symmetric branch only antisymmetric modes answer to c: this is positive where they
        are stable and vanishes with the smallest of their eigenvalues, and costs far less than
        that. Raises ArithmeticError if the state is unstable.
        """
        nodes = len(self.masses)
        wave = np.zeros((nodes - 2, self.node_dofs))
        wave[:, 1] = np.sin(2.0 * np.pi * np.arange(1, nodes - 1) / (nodes - 1))
        push = wave.ravel()
        try:
            answer = solveh_banded(self.tangent_band(), push, lower=True)
        except np.linalg.LinAlgError as error:
            raise ArithmeticError("the arch is not stable") from error
        return 1.0 / float(push @ answer)

    def critical_mode(self) -> Array:
        """Unit eigenvector of the last tangent's smallest eigenvalue, over free coordinates."""
        _, vectors = eig_banded(self.tangent_band(), lower=True, select="i", select_range=(0, 0))
        return np.asarray(vectors[:, 0])

    def equilibrium(self, state: Array, left: float, right: float) -> Equilibrium:
        """Describe a settled state."""
        angles = ClampAngles(left, right, 0.0, 0.0)
        tangents = end_tangents(self.frame, NO_MESH, NoLoad(), angles, state, STILL)
        energy = float(internal_energy(self.rod, state, tangents))
        return Equilibrium(
            state[0 :: self.node_dofs].copy(),
            state[1 :: self.node_dofs].copy(),
            left,
            right,
            energy,
            self.negative_pivots,
            state.copy(),
        )
