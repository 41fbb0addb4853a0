"""Derivatives of models' numbers by inputs: differences of their builder, thresholds apart."""

from collections.abc import Callable, Sequence

import numpy as np

from snapjump.arrays import Array
from snapjump.batch.thresholds import beam_of, check_curve, covered, thresholds
from snapjump.batch.variants import variant
from snapjump.checks import ParameterError
from snapjump.composition import Simulation
from snapjump.declare.inputs import DEFAULT_INPUTS, Input, input_at, value_at, with_inputs
from snapjump.engine.model import Model, numbers_in, numbers_of
from snapjump.scenes.frame_body import compression
from snapjump.scenes.jump_start import (
    composed_model,
    critical,
    leading_start,
    loading_time,
    mount_height_bar,
    start_angle_rad,
)
from snapjump.statics.threshold import Threshold
from snapjump.statics.threshold_curve import ThresholdCurve

# Of an input, between the points of a difference of fourth order. A computed threshold is known to
# 1e-11 or so only, and asks for a longer one.
STEP, LONG_STEP = 1e-3, 1e-2
SMALLEST_SHARE = 0.1  # of the default of an input without dimension: steps are shares of no less
# Places, in steps, and the weights of a first derivative.
BETWEEN = ((-2, 1 / 12), (-1, -8 / 12), (1, 8 / 12), (2, -1 / 12))
AHEAD = ((0, -25 / 12), (1, 48 / 12), (2, -36 / 12), (3, 16 / 12), (4, -3 / 12))
BEHIND = tuple((-place, -weight) for place, weight in AHEAD)


def model_derivatives(
    base: Simulation,
    designs: Array,
    curve: ThresholdCurve | None = None,
    inputs: Sequence[str] = DEFAULT_INPUTS,
) -> Array:
    """d(numbers of the models)/d(inputs) of designs (R, I): (R, P, I).

    P are the numbers of :func:`snapjump.engine.model.numbers_of`. Thresholds are differentiated by
    the curve where it is of the design's beam. At 0, where for delta_alpha the leading clamp
    changes, the derivative is that towards positive values.

    Raises ParameterError for a curve of another beam and a frame that is not rigid.
    """
    check_curve(base, curve)
    if not base.frame.differentiable:
        raise ParameterError("frame", base.frame.name, "rigid with sensitivities")
    if not len(designs):
        return np.zeros((0, 0, len(inputs)))
    simulations = [variant(base, row, inputs) for row in designs]
    found = []
    for one, known in zip(simulations, thresholds(simulations, curve), strict=True):
        threshold = known or critical(one)
        found.append([input_slopes(one, path, threshold, curve) for path in inputs])
    return np.array(found).transpose(0, 2, 1)


def input_slopes(
    simulation: Simulation, path: str, threshold: Threshold, curve: ThresholdCurve | None
) -> Array:
    """Derivatives (P,) of the numbers by one input."""
    here = value_at(simulation, path)
    by_angle, by_depth = threshold_slopes(simulation, path, curve)
    loading = loading_time(simulation, start_angle_rad(simulation, threshold), threshold)

    def numbers(moved: Simulation) -> Array:
        # Along its tangent a threshold has the right derivative, and costs nothing.
        way = value_at(moved, path) - here
        near = Threshold(
            threshold.alpha_rad + by_angle * way, threshold.h1_bar + by_depth * way, 0.0
        )
        # Its steps stay as they are while the snap comes earlier or later: unless the start moves
        # along the branch with it, the strike meets them at another phase, and the derivative is
        # that of their errors.
        start = leading_start(moved, near, loading)
        mount = mount_height_bar(moved, near)
        return numbers_of(composed_model(moved, start, mount, moved.sim.time_limit_s))

    return difference(numbers, simulation, path, STEP)


def threshold_slopes(simulation: Simulation, path: str, curve: ThresholdCurve | None) -> Array:
    """Derivatives (2,) of the critical angle and of the depth there by an input."""

    def arch(moved: Simulation) -> Array:
        return np.array([*beam_of(moved), compression(moved)])

    turned = difference(arch, simulation, path, STEP)
    if not turned.any():
        return np.zeros(2)
    if curve is not None and covered(simulation, curve) and not turned[:-1].any():
        return float(turned[-1]) * np.array(curve.slopes(compression(simulation)))

    def direct(moved: Simulation) -> Array:
        found = critical(moved)
        return np.array([found.alpha_rad, found.h1_bar])

    return difference(direct, simulation, path, LONG_STEP)


def difference(
    values: Callable[[Simulation], Array], simulation: Simulation, path: str, step: float
) -> Array:
    """The derivative by an input, of fourth order: central, or to one side where values on the
    other are refused, or have another sign (and a kink in between)."""
    here = float(value_at(simulation, path))
    stride = step * scale_of(input_at(simulation, path), here)
    refused: ParameterError | None = None
    for stencil in (BETWEEN, AHEAD, BEHIND):
        places = [here + count * stride for count, _ in stencil]
        if min(places) < 0.0 <= here or max(places) >= 0.0 > here:
            continue
        try:
            found = [values(with_inputs(simulation, {path: place})) for place in places]
        except ParameterError as error:
            refused = error
        else:
            # The weights add up to nothing: what does not change has no derivative, exactly.
            changes = [(one - found[0]) * w for one, (_, w) in zip(found, stencil, strict=True)]
            return np.asarray(sum(changes) / stride)
    assert refused is not None
    raise refused


def scale_of(one: Input, here: float) -> float:
    """What a step is a share of: of an input with a dimension the input itself, which has the
    robot's scale. One that is 0, as damping may be, enters linearly: a step of any size will do."""
    default = abs(one.default) if isinstance(one.default, float) else 0.0
    if one.unit in ("", "rad"):
        return max(abs(here), SMALLEST_SHARE * default) or 1.0
    return abs(here) or default or 1.0


def places(model: Model, family: str) -> slice:
    """Where the numbers of a member are among those of its model."""
    first = sum(len(numbers_in(member)) for member in model[: model._fields.index(family)])
    return slice(first, first + len(numbers_in(getattr(model, family))))


def place(model: Model, family: str, field: str) -> int:
    """The index of a member's number among the numbers of its model."""
    return int(places(model, family).start) + getattr(model, family)._fields.index(field)
