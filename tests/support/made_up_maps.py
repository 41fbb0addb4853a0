"""Forward models in closed form, and a simulator that agrees with one but for a shift."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from snapjump.checks import ParameterError
from snapjump.inverse.base import Problem
from snapjump.plan.parts.axes import default_axes

RANGES = ((0.01, 0.19), (0.1, 0.3), (0.3, 2.0), (0.1, 0.6))
TINY = 1e-30
HEIGHT = 60.0  # y mass_bar / epsilon
SLOPE = 4.0  # x / (y delta_alpha) at mu = 0.3
TURN = 0.1  # rad, where the folded map turns back


def straight(designs: Any) -> Any:
    """Higher with more compression; a fan of straight lines from the origin, one a mismatch."""
    delta_alpha, epsilon, mass_bar, mu = designs.T
    y = HEIGHT * epsilon / mass_bar
    return np.stack([y * SLOPE * delta_alpha * np.tanh(3.0 * mu) / np.tanh(0.9), y], axis=1)


def folded(designs: Any) -> Any:
    """Symmetric about delta_alpha = 0.1 rad at mu = 0.3: each apex has two designs there, of which
    that beyond 0.1 rad depends on mu."""
    delta_alpha, epsilon, mass_bar, mu = designs.T
    y = HEIGHT * epsilon / mass_bar
    beyond = 1.0 + 5.0 * np.where(np.real(delta_alpha) > TURN, delta_alpha - TURN, 0.0) * (mu - 0.3)
    spread = 0.5 - 40.0 * (delta_alpha - TURN) ** 2
    return np.stack([y * spread * beyond, y], axis=1)


@dataclass
class MadeUpModel:
    """Satisfies ForwardModel; its derivatives are exact to rounding."""

    map: Callable[[Any], Any] = straight
    ranges: Any = RANGES

    @property
    def axes(self) -> Any:
        return default_axes(self.ranges)

    def predict(self, designs: Any) -> Any:
        low, high = np.array(self.ranges).T
        if not ((designs >= low - 1e-12) & (designs <= high + 1e-12)).all():
            raise ParameterError("designs", "some", "within the ranges")
        return self.map(designs)

    def jacobian(self, designs: Any) -> Any:
        self.predict(designs)
        columns = []
        for axis in range(4):
            moved = designs.astype(complex)
            moved[:, axis] += 1j * TINY
            columns.append(np.imag(self.map(moved)) / TINY)
        return np.stack(columns, axis=2)

    def check_model(self, simulation: Any) -> None:
        """It knows any physical model."""


@dataclass
class MadeUpSimulator:
    """Satisfies Simulator: a map, moved by a shift (2,), which may be NaN."""

    map: Callable[[Any], Any] = straight
    shift: Any = (0.0, 0.0)
    simulations: int = 0

    def apexes(self, designs: Any) -> Any:
        self.simulations += len(designs)
        return self.map(designs) + np.array(self.shift)

    def slopes(self, designs: Any) -> Any:
        self.simulations += len(designs)
        return MadeUpModel(self.map).jacobian(designs)


def problem(target: Any, forward: Any = None, simulator: Any = None, **changes: Any) -> Problem:
    """A problem in the environment mass_bar = 1, mu = 0.3, over the paper's ranges."""
    low, high = np.array(RANGES[:2]).T
    simulator = simulator or MadeUpSimulator()
    given = {"mass_bar": 1.0, "mu": 0.3, "seed": 0, "forward": forward, "simulator": simulator}
    return Problem(target=np.array(target, dtype=float), low=low, high=high, **(given | changes))
