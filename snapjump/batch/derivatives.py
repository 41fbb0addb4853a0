"""How a model's numbers depend on the design, through the threshold too."""

import numpy as np
from numpy.typing import NDArray

from snapjump.batch.prepare import check_curve
from snapjump.batch.variants import Row, variant
from snapjump.checks import ParameterError
from snapjump.composition import Simulation
from snapjump.engine.model import numbers_of
from snapjump.scenes.frame_body import compression
from snapjump.scenes.jump_start import jump_model
from snapjump.statics.threshold import Threshold
from snapjump.statics.threshold_curve import ThresholdCurve

Array = NDArray[np.float64]
STEP = 1e-3  # of a value, or of SMALLEST
SMALLEST = 0.1
INWARDS_FROM = 0.25  # rad
# Weights of the changes over 1, 2, 3 and 4 steps in a derivative.
AHEAD = (4.0, -3.0, 4.0 / 3.0, -0.25)


def one_sided_steps(point: Array) -> Array:
    """Steps of the differences: into the values' ranges, and not across delta_alpha = 0."""
    delta_alpha, epsilon = point[:2]
    outwards = 1.0 if delta_alpha >= 0.0 else -1.0
    steps = STEP * np.maximum(np.abs(point), SMALLEST)
    steps[0] *= outwards if abs(delta_alpha) < INWARDS_FROM else -outwards
    # The largest compression and the largest angle are bounded from above.
    steps[1] = -STEP * epsilon
    steps[4] *= -1.0
    return steps


def model_derivatives(base: Simulation, design: Row, curve: ThresholdCurve) -> Array:
    """d(numbers of the model)/d(delta_alpha, epsilon, mass_bar, mu): (P, 4).

    Rows are those of :func:`snapjump.engine.model.numbers_of`. The formulas between design,
    threshold and model are differentiated by differences of fourth order, the threshold itself by
    the curve. At delta_alpha = 0, where the leading clamp changes, the derivative is that towards
    positive values.

    Raises ParameterError for a design that is refused, or whose compression the curve does not
    cover.
    """
    check_curve(base, curve)
    shortening = compression(variant(base, design))
    if not curve.covers(shortening):
        raise ParameterError(
            "design.epsilon",
            float(design[1]),
            f"a compression in [{curve.low:g}, {curve.high:g}], which the curve covers",
        )
    angle, depth = curve.values(shortening)
    point = np.array([*design, angle, depth], dtype=float)

    def numbers(values: Array) -> Array:
        threshold = Threshold(float(values[4]), float(values[5]))
        return numbers_of(jump_model(variant(base, values[:4]), threshold))

    centre = numbers(point)

    def slope(k: int) -> Array:
        """Derivative by one of the six values."""
        total = np.zeros_like(centre)
        for count, weight in enumerate(AHEAD, start=1):
            moved = point.copy()
            moved[k] += count * steps[k]
            total += weight * (numbers(moved) - centre)
        return total / steps[k]

    steps = one_sided_steps(point)
    slopes = np.array([slope(k) for k in range(6)])
    by_angle, by_depth = curve.slopes(shortening)
    slopes[1] += slopes[4] * by_angle + slopes[5] * by_depth
    return slopes[:4].T
