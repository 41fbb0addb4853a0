"""How models' numbers depend on the design, through the threshold too."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from snapjump.batch.prepare import check_curve
from snapjump.batch.variants import variant
from snapjump.checks import ParameterError
from snapjump.composition import Simulation
from snapjump.engine.model import Model, numbers_of
from snapjump.frame.base import Outline
from snapjump.frame.rigid import RigidFrame
from snapjump.scenes.jump_start import fitted_mount_height_bar, jump_model
from snapjump.statics.threshold import Threshold
from snapjump.statics.threshold_curve import ThresholdCurve

Array = NDArray[np.float64]
TINY = 1e-30  # of a complex step, which takes no difference: it is exact to rounding
DELTA_ALPHA, EPSILON, MASS_BAR, MU = range(4)


def model_derivatives(base: Simulation, designs: Array, curve: ThresholdCurve) -> Array:
    """d(numbers of the models)/d(delta_alpha, epsilon, mass_bar, mu) of designs (R, 4): (R, P, 4).

    P are the numbers of :func:`snapjump.engine.model.numbers_of`. Formulas are differentiated by
    complex steps, thresholds by the curve. At delta_alpha = 0, where the leading clamp changes,
    the derivative is that towards positive values.

    Raises ParameterError for an epsilon that the curve does not cover, a curve of another beam,
    and a frame that is not rigid.
    """
    check_curve(base, curve)
    if not base.frame.differentiable:
        raise ParameterError("frame", base.frame.name, "rigid with sensitivities")
    table = np.asarray(designs, dtype=float)
    outside = table[~curve.covers(table[:, EPSILON]), EPSILON]
    if len(outside):
        raise ParameterError(
            "design.epsilon",
            float(outside[0]),
            f"in [{curve.low:g}, {curve.high:g}], which the curve covers",
        )
    angles, depths = curve.values(table[0, EPSILON])
    model = jump_model(
        variant(base, table[0]), Threshold(float(angles), float(depths), curve.angle_error)
    )
    slopes = np.zeros((len(table), len(numbers_of(model)), 4))
    by_angle, _ = curve.slopes(table[:, EPSILON])
    if base.sim.start_fraction > 0.0:
        start = place(model, "clamp", "start")
        slopes[:, start, EPSILON] = base.sim.start_fraction * by_angle
        # The right clamp leads: the left one starts that much earlier.
        slopes[:, start, DELTA_ALPHA] = table[:, DELTA_ALPHA] < 0.0
    slopes[:, place(model, "clamp", "delta_alpha"), DELTA_ALPHA] = 1.0
    if hasattr(model.friction, "mu"):
        slopes[:, place(model, "friction", "mu"), MU] = 1.0
    first = place(model, "frame", "half_span")
    frame = slice(first, first + len(model.frame))
    for axis in (EPSILON, MASS_BAR):
        slopes[:, frame, axis] = frame_slopes(base, table, curve, axis)
    return slopes


def place(model: Model, family: str, field: str) -> int:
    """Where a member's number stands among the numbers of its model."""
    before = model[: model._fields.index(family)]
    return sum(len(member) for member in before) + getattr(model, family)._fields.index(field)


def frame_slopes(base: Simulation, table: Array, curve: ThresholdCurve, axis: int) -> Array:
    """Derivatives (R, 6) of the rigid frames' numbers by epsilon or mass_bar."""
    moved = table.astype(complex)
    moved[:, axis] += 1j * TINY
    robot = base.robot
    scales = robot.scales
    epsilon, mass_bar = moved[:, EPSILON], moved[:, MASS_BAR]
    masses = base.environment.mass_kg(robot) / base.environment.mass_bar / scales.mass_kg * mass_bar
    frame = RigidFrame().body(
        Outline(
            width=1.0 - epsilon,
            height=robot.frame_height_m / scales.length_m,
            mount=mount_heights(base, epsilon, curve),
            mass=masses - 1.0,
            end=base.discretization.clamped_mass_bar,
        )
    )
    return np.array([np.imag(values) for values in frame]).T / TINY


def mount_heights(base: Simulation, epsilon: Any, curve: ThresholdCurve) -> Any:
    """Heights of the clamps (in L), carrying the imaginary part of epsilon along."""
    given = base.robot.mount_height
    if given == "fitted":
        return fitted_mount_height_bar(epsilon)
    if given != "optimal":
        return float(given) / base.robot.length_m + 0.0 * epsilon
    _, depth = curve.values(epsilon.real)
    _, slope = curve.slopes(epsilon.real)
    return depth + 1j * epsilon.imag * slope
