"""The contract of an inverse method: which clamps reach a target apex in a given environment."""

from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Range = tuple[float, float]
CONTROLS = ("delta_alpha_rad", "epsilon")


class ForwardModel(Protocol):
    """A learned forward model. Designs (N, 4): delta_alpha (rad), epsilon, mass_bar, mu."""

    @property
    def ranges(self) -> tuple[Range, Range, Range, Range]:
        """The box it was trained in; outside of it nothing may be asked."""

    def predict(self, designs: Array) -> Array:
        """Apexes (N, 2) in L. Raises ParameterError for a design outside the ranges."""

    def jacobian(self, designs: Array) -> Array:
        """Derivatives (N, 2, 4) of the apexes by the design. Raises like ``predict``."""


class Simulator(Protocol):
    """Simulated apexes at one accuracy tier; ``simulations`` counts every one there was."""

    simulations: int

    def apexes(self, designs: Array) -> Array:
        """Apexes (N, 2) in L, NaN for a robot that does not jump or a jump that failed."""

    def slopes(self, designs: Array) -> Array:
        """Exact derivatives (N, 2, 4) of the apexes by the design, NaN where there are none."""


@dataclass(frozen=True)
class Problem:
    """``target``: x_bar, y_bar; ``low``, ``high`` (2,): bounds of delta_alpha (rad) and epsilon.

    ``forward`` is None where the environment is outside the training range; ``seed``: of
    everything random.
    """

    target: Array
    mass_bar: float
    mu: float
    low: Array
    high: Array
    forward: ForwardModel | None
    simulator: Simulator
    seed: int = 0

    def designs(self, controls: Array) -> Array:
        """Designs (N, 4) of controls (N, 2) in this environment."""
        rest = np.broadcast_to([self.mass_bar, self.mu], (len(controls), 2))
        return np.hstack([controls, rest])

    def scaled(self, controls: Array) -> Array:
        """Controls (N, 2) as shares of the way from low to high."""
        return (np.asarray(controls) - self.low) / (self.high - self.low)


@dataclass(frozen=True)
class Solution:
    """``controls``: delta_alpha (rad), epsilon; ``apex``: what the method believes they reach (L);
    ``simulated``: whether it believes so because it simulated it."""

    controls: Array
    apex: Array
    simulated: bool

    def miss_bar(self, target: Array) -> float:
        """Distance between that apex and a target, in L."""
        return float(np.hypot(*(self.apex - target)))


class InverseMethod(Protocol):
    """What a member's module calls ``MEMBER``: its options, and what it does."""

    def solve(self, problem: Problem) -> list[Solution]:
        """All solutions that were found, the best first; at least one, however large its miss."""
