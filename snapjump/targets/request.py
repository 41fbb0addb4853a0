"""Checks of a request: target, checkpoint, and whether the forward model may be asked."""

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from snapjump.arrays import Array
from snapjump.checks import ParameterError, check_text, is_finite_number
from snapjump.composition import Simulation
from snapjump.declare.inputs import DEFAULT_INPUTS, value_at
from snapjump.inverse.base import InverseOptions
from snapjump.learning import STANDARD

if TYPE_CHECKING:
    from snapjump.learning.forward_model import ForwardModel

FARTHEST_BAR = 1.0e6


def checked_target(value: Any) -> Array:
    """A target (2,). Raises ParameterError for what is no point above the ground."""
    allowed = f"[x, y] of an apex in L: two numbers, y >= 0, none beyond {FARTHEST_BAR:g}"
    pair = isinstance(value, Sequence) and not isinstance(value, str) and len(value) == 2
    numbers = pair and all(map(is_finite_number, value))
    if not numbers or not (abs(value[0]) <= FARTHEST_BAR and 0.0 <= value[1] <= FARTHEST_BAR):
        raise ParameterError("target", list(value) if pair else value, allowed)
    return np.array(value, dtype=float)


def checkpoint_path(value: Any) -> Path:
    """The file of a forward model, null: the one that comes along. Raises ParameterError."""
    if value is None:
        return STANDARD
    check_text("checkpoint", value, "null, or a file that task=train left")
    return Path(value)


def trained_forward(path: Path) -> "ForwardModel":
    """The forward model of a checkpoint. Raises ParameterError for one that has other inputs than
    the two controls and the two of the environment."""
    from snapjump.learning.forward_model import forward_model

    model = forward_model(path)
    paths = tuple(axis.path for axis in model.axes)
    if paths != DEFAULT_INPUTS:
        allowed = (
            f"one of {', '.join(DEFAULT_INPUTS)} for inverse design, not of {', '.join(paths)}"
        )
        raise ParameterError("checkpoint", str(path), allowed)
    return model


def outside(base: Simulation, forward: "ForwardModel") -> ParameterError | None:
    """The first parameter of physical model or environment that it was not trained with."""
    try:
        forward.check_model(base)
    except ParameterError as error:
        return error
    for axis in forward.axes:
        if axis.kind != "environment":
            continue
        value, (low, high) = value_at(base, axis.path), axis.range
        if not low <= value <= high:
            allowed = f"a number in [{low:g}, {high:g}], where the forward model was trained"
            return ParameterError(axis.path, value, allowed)
    return None


def usable_forward(
    base: Simulation, forward: "ForwardModel", method: InverseOptions
) -> tuple["ForwardModel | None", str]:
    """The forward model, or None and a warning for a method that can do without it there.
    Raises ParameterError where it cannot: a forward model never extrapolates."""
    wrong = outside(base, forward)
    if wrong is None:
        return forward, ""
    if method.needs_forward or method.robust:
        without = " (inverse=physics goes on without it, if inverse.robust is false)"
        raise ParameterError(wrong.key, wrong.value, wrong.allowed + without)
    return None, f"{wrong}; the search goes on without it"
