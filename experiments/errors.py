"""How far results are off: relative errors against the converged limit, and roughness.

Errors of x are relative to max(|x|, 0.1 y), since x goes through zero. Roughness is the standard
deviation (in L) of the result less the converged one, about a line, when delta_alpha is swept in
steps of 0.001 about the baseline: what a surrogate or an optimiser sees as noise.
"""

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Design = tuple[float, float, float, float]

# A finer mesh and a tighter tolerance than any tier has: the limit that all are judged by.
FINEST_ELEMENTS = 448
FINEST_STEPPING = {"name": "adaptive", "tolerance": 5e-10, "contact_steps": 0.5}
FINEST_START = 0.8
SWEEP = 21
BASELINE: Design = (0.1, 0.2, 0.768, 0.3)  # delta_alpha (rad), epsilon, m_bar, mu
SWEEP_STEP = 0.001


def relative_errors(x: Array, y: Array, x_limit: Array, y_limit: Array) -> tuple[Array, Array]:
    """Errors of x and y in percent, NaN where either is missing."""
    scale = np.maximum(np.abs(x_limit), 0.1 * y_limit)
    return 100.0 * np.abs(x - x_limit) / scale, 100.0 * np.abs(y - y_limit) / y_limit


def percentile(errors: Array, share: float) -> float:
    """A percentile in which a failure counts as an infinite error."""
    if len(errors) == 0:
        return float("nan")
    ranked = np.sort(np.where(np.isfinite(errors), errors, np.inf))
    place = share / 100.0 * (len(ranked) - 1)
    low, high = ranked[int(np.floor(place))], ranked[int(np.ceil(place))]
    return float(low if low == high else low + (high - low) * (place - np.floor(place)))


def roughness(values: Array) -> float:
    """Standard deviation about a line; NaN if any value is missing."""
    place = np.arange(len(values))
    if len(values) < 3 or not np.isfinite(values).all():
        return float("nan")
    return float(np.std(values - np.polyval(np.polyfit(place, values, 1), place)))


def baseline_sweep(count: int = SWEEP) -> list[Design]:
    """The baseline design with delta_alpha in steps of 0.001."""
    lag, *others = BASELINE
    return [(lag + SWEEP_STEP * (k - count // 2), *others) for k in range(count)]  # type: ignore[misc]
