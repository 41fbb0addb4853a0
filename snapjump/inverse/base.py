"""The contract of an inverse method: which clamps reach a target apex in a given environment."""

from dataclasses import dataclass, field
from typing import ClassVar, Protocol

import numpy as np

from snapjump.arrays import Array
from snapjump.checks import ParameterError
from snapjump.declare.fields import Part, flag, required
from snapjump.plan.parts.axes import Range, default_axes

CONTROLS = tuple(axis.column for axis in default_axes() if axis.kind == "control")
# Apexes nearer to the target than this (L) have reached it, for a forward model's solutions.
REACHED_BAR = 1.0e-3
# The largest miss (L) with which a target counts as reached, by simulation.
REACH_BAR = 0.03
# Solutions nearer to each other than this share of the ranges are one.
SAME = 1.0e-3


class ForwardModel(Protocol):
    """A learned forward model. Designs (N, 4): delta_alpha (rad), epsilon, mass_bar, mu."""

    @property
    def ranges(self) -> tuple[Range, ...]:
        """The box it was trained in; outside of it nothing may be asked."""

    def predict(self, designs: Array) -> Array:
        """Apexes (N, 2) in L. Raises ParameterError for a design outside the ranges."""

    def jacobian(self, designs: Array) -> Array:
        """Derivatives (N, 2, 4) of the apexes by the design. Raises like ``predict``."""


class Simulator(Protocol):
    """Simulated apexes at one accuracy tier; ``simulations`` counts every one there was."""

    @property
    def simulations(self) -> int:
        """Also those at other tiers that came from here."""

    def apexes(self, designs: Array) -> Array:
        """Apexes (N, 2) in L, NaN for a robot that does not jump or a jump that failed."""

    def slopes(self, designs: Array) -> Array:
        """Exact derivatives (N, 2, 4) of the apexes by the design, NaN where there are none."""

    def at(self, tier: str) -> "Simulator":
        """The same physical model at another accuracy tier."""


@dataclass(frozen=True)
class Problem:
    """``target``: x_bar, y_bar; ``low``, ``high`` (2,): bounds of delta_alpha (rad) and epsilon.

    ``forward`` is None where the environment is outside the training range; ``seed``: of
    everything random; ``symmetric``: whether the mirrored design jumps to the mirrored apex.
    """

    target: Array
    mass_bar: float
    mu: float
    low: Array
    high: Array
    forward: ForwardModel | None
    simulator: Simulator
    seed: int = 0
    symmetric: bool = True

    def designs(self, controls: Array) -> Array:
        """Designs (N, 4) of controls (N, 2) in this environment."""
        rest = np.broadcast_to([self.mass_bar, self.mu], (len(controls), 2))
        return np.hstack([controls, rest])

    def scaled(self, controls: Array) -> Array:
        """Controls (N, 2) as shares of the way from low to high."""
        return (np.asarray(controls) - self.low) / (self.high - self.low)

    def unscaled(self, shares: Array) -> Array:
        """Controls (N, 2) from shares (N, 2) of the way from low to high."""
        return self.low + np.asarray(shares) * (self.high - self.low)

    def misses(self, apexes: Array) -> Array:
        """Distances (N) of apexes (N, 2) from the target in L; NaN where there is none."""
        return np.hypot(*(apexes - self.target).T)

    def grid(self, points: int) -> Array:
        """Controls (points, points, 2) over the rectangle, delta_alpha along the first axis."""
        ticks = np.linspace(0.0, 1.0, points)
        return self.unscaled(np.stack(np.meshgrid(ticks, ticks, indexing="ij"), axis=-1))

    def known_forward(self, method: str) -> ForwardModel:
        """The forward model. Raises ParameterError, naming the method, where there is none."""
        if self.forward is None:
            raise ParameterError("inverse", method, "a method that asks no forward model")
        return self.forward


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


@dataclass
class Search:
    """Simulated designs: ``shares`` (N, 2) of the controls' ranges, and their apexes (N, 2)."""

    problem: Problem
    simulator: Simulator
    shares: Array = field(default_factory=lambda: np.zeros((0, 2)))
    apexes: Array = field(default_factory=lambda: np.zeros((0, 2)))

    def simulate(self, shares: Array) -> Array:
        """Apexes (N, 2) of candidates (N, 2); those that do not jump are NaN, and forgotten."""
        apexes = self.simulator.apexes(self.designs(shares))
        jumped = np.isfinite(apexes).all(axis=1)
        self.shares = np.vstack([self.shares, shares[jumped]])
        self.apexes = np.vstack([self.apexes, apexes[jumped]])
        return apexes

    def misses(self) -> Array:
        """Distances (N) to the target in L."""
        return self.problem.misses(self.apexes)

    def best(self) -> Solution:
        """The point nearest to the target; if none jumped, the middle, infinitely far."""
        if not len(self.apexes):
            return Solution(self.problem.unscaled(np.full(2, 0.5)), np.full(2, np.inf), True)
        k = int(self.misses().argmin())
        return Solution(self.problem.unscaled(self.shares[k]), self.apexes[k], True)

    def designs(self, shares: Array) -> Array:
        """Designs (N, 4) of shares (N, 2)."""
        return self.problem.designs(self.problem.unscaled(shares))


class InverseOptions(Part):
    """A method of inverse design and its numbers.

    ``robust``: whether its solutions are starts for the design with the least expected miss.
    ``needs_forward``: whether it asks the forward model for more than a start; ``needs_slopes``:
    whether it asks the simulator for derivatives.
    """

    group = "inverse"
    needs_forward: ClassVar[bool] = True

    robust: bool = flag(False)

    @property
    def needs_slopes(self) -> bool:
        return False

    @required
    def solve(self, problem: Problem) -> list[Solution]:
        """All solutions that were found, the best first; at least one, however large its miss."""
        raise NotImplementedError


def one_percent_bar(designs: Array, slopes: Array) -> Array:
    """Distances (N, 4) in L that one percent of each parameter moves apexes by, from designs (N, 4)
    and derivatives (N, 2, 4)."""
    return 0.01 * np.abs(designs) * np.hypot(slopes[:, 0], slopes[:, 1])


def predicted_solutions(problem: Problem, forward: ForwardModel, controls: Array) -> list[Solution]:
    """The different ones of controls (N, 2) that reach the target by the forward model, that which
    manufacturing errors move least first; if none does, the nearest alone."""
    designs = problem.designs(controls)
    apexes = forward.predict(designs)
    misses = problem.misses(apexes)
    order = np.argsort(misses, kind="stable")
    kept: list[int] = []
    for k in order[misses[order] <= REACHED_BAR]:
        apart = np.abs(problem.scaled(controls[kept]) - problem.scaled(controls[k]))
        if not kept or float(apart.max(axis=1).min()) > SAME:
            kept.append(int(k))
    kept = kept or [int(order[0])]
    moved = one_percent_bar(designs[kept], forward.jacobian(designs[kept])).sum(axis=1)
    chosen = [kept[k] for k in np.argsort(moved, kind="stable")]
    return [Solution(controls[k], apexes[k], False) for k in chosen]
