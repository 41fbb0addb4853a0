"""Mirrored designs: the robot that leans the other way jumps to the other side.

With the mismatch of its clamps reversed, a robot on level ground is its own mirror image, and so is
its jump. A forward model that was trained with mismatches of one sign knows those of the other, and
what lies between: there x is odd and y even in the mismatch.
"""

from dataclasses import dataclass, replace

import numpy as np

from snapjump.arrays import Array
from snapjump.inverse.base import ForwardModel, Problem
from snapjump.plan.parts.axes import Range
from snapjump.targets.region import AchievableRegion

FLIP = np.array([-1.0, 1.0])  # of x and y, and of delta_alpha and epsilon


@dataclass(frozen=True)
class Mirrored:
    """A forward model (N, 4) for mismatches of the other sign; satisfies ForwardModel."""

    forward: ForwardModel

    @property
    def ranges(self) -> tuple[Range, ...]:
        (low, high), *others = self.forward.ranges
        return ((-high, -low), *others)

    def predict(self, designs: Array) -> Array:
        return FLIP * self.forward.predict(designs * [-1.0, 1.0, 1.0, 1.0])

    def jacobian(self, designs: Array) -> Array:
        signs = np.outer(FLIP, [-1.0, 1.0, 1.0, 1.0])
        found: Array = signs * self.forward.jacobian(designs * [-1.0, 1.0, 1.0, 1.0])
        return found


@dataclass(frozen=True)
class Between:
    """A forward model (N, 4) for mismatches between the smallest ones of both signs: x is linear in
    the mismatch and y constant. Satisfies ForwardModel."""

    forward: ForwardModel

    @property
    def smallest(self) -> float:
        return self.forward.ranges[0][0]

    @property
    def ranges(self) -> tuple[Range, ...]:
        return ((-self.smallest, self.smallest), *self.forward.ranges[1:])

    def predict(self, designs: Array) -> Array:
        apexes = self.forward.predict(self._edge(designs))
        return np.column_stack([apexes[:, 0] * designs[:, 0] / self.smallest, apexes[:, 1]])

    def jacobian(self, designs: Array) -> Array:
        edge = self._edge(designs)
        found = self.forward.jacobian(edge).copy()
        found[:, 0] *= (designs[:, 0] / self.smallest)[:, None]
        found[:, 0, 0] = self.forward.predict(edge)[:, 0] / self.smallest
        found[:, 1, 0] = 0.0
        return found

    def _edge(self, designs: Array) -> Array:
        return np.column_stack([np.full(len(designs), self.smallest), designs[:, 1:]])


def with_mirror(problem: Problem) -> list[Problem]:
    """The problem, its mirror image, and what lies between them, where that is anything new: that
    first in which the forward model sees the target, or else the side to which the target lies.
    Together they bound mismatches of both signs."""
    (low, least), (high, most) = problem.low, problem.high
    if low == -high:
        return [problem]
    known = problem.forward if problem.symmetric else None
    mirrored = replace(
        problem,
        low=np.array([-high, least]),
        high=np.array([-low, most]),
        forward=None if known is None else Mirrored(known),
    )
    sides = [problem, mirrored] if problem.target[0] >= 0.0 else [mirrored, problem]
    if low > 0.0:
        between = replace(
            problem,
            low=np.array([-low, least]),
            high=np.array([low, most]),
            forward=None if known is None else Between(known),
        )
        sides.append(between)
    return sorted(sides, key=lambda side: not sees_target(side))


def sees_target(problem: Problem) -> bool:
    """Whether the target is in the achievable region by the forward model, if there is one."""
    if problem.forward is None:
        return False
    region = AchievableRegion.of(problem, problem.forward)
    return bool(region.contains(problem.target[None, :])[0])
