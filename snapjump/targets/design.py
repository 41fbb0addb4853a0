"""Inverse design from Python: the library's front door to what ``task=inverse`` does."""

import warnings
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from snapjump.arrays import Array
from snapjump.checks import check_choice
from snapjump.composition import Simulation, with_tier
from snapjump.inverse.base import ForwardModel, InverseOptions, Problem
from snapjump.inverse.physics import PhysicsOptions
from snapjump.robot.environment import Environment
from snapjump.targets import request
from snapjump.targets.answer import Answer, answer
from snapjump.targets.simulator import JumpSimulator
from snapjump.tiers import TIERS


def problem_of(
    base: Simulation, target: Array, trained: ForwardModel, forward: ForwardModel | None, seed: int
) -> Problem:
    """The problem of a target (2,) in L in the environment of a simulation.

    The controls are bounded by the ranges of ``trained`` (:func:`answer` searches their mirror
    image too); ``forward`` is what may be asked: the same, or None.
    """
    low, high = np.array(trained.ranges[:2]).T
    mass_bar, mu = base.environment.mass_bar, base.environment.mu
    symmetric = base.environment.slope_rad == 0.0 and base.frame.symmetric
    simulator = JumpSimulator(base)
    return Problem(target, mass_bar, mu, low, high, forward, simulator, seed, symmetric)


def inverse_design(
    target: Sequence[float],
    environment: Environment | Mapping[str, Any] | None = None,
    accuracy: str = "standard",
    method: InverseOptions | None = None,
    checkpoint: str | None = None,
    seed: int = 0,
) -> Answer:
    """Designs that throw the robot to a target apex x, y in L; by default as found by ``physics``.

    ``checkpoint``: a forward model that task=train left, None for the one that comes along. An
    environment that it was not trained for is a warning, or refused where the method needs it.
    Raises ParameterError for bad input.
    """
    check_choice("accuracy", accuracy, tuple(TIERS))
    place = request.checked_target(target)
    base = with_tier(accuracy, environment=environment or Environment())
    way = method or PhysicsOptions()
    trained = request.trained_forward(request.checkpoint_path(checkpoint))
    forward, warning = request.usable_forward(base, trained, way)
    if warning:
        warnings.warn(warning, stacklevel=2)
    return answer(problem_of(base, place, trained, forward, seed), way)
