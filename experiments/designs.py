"""Designs of studies (delta_alpha in rad, epsilon, mass_bar, mu), and their columns.

They are spread evenly over the paper's ranges, or swept about the baseline.
"""

from scipy.stats import qmc

from snapjump.plan.parts.axes import default_axes

Design = tuple[float, float, float, float]

AXES = default_axes()
COLUMNS = tuple(axis.column for axis in AXES)
LABELS = {axis.column: axis.label for axis in AXES}
LOW, HIGH = ([axis.low for axis in AXES], [axis.high for axis in AXES])
BASELINE: Design = (0.1, 0.2, 0.768, 0.3)
SWEEP, SWEEP_STEP = 21, 0.001


def spread_designs(count: int, seed: int = 7) -> list[Design]:
    """``count`` designs of a scrambled Sobol sequence."""
    points = qmc.Sobol(4, rng=seed).random(count)
    return [tuple(float(v) for v in row) for row in qmc.scale(points, LOW, HIGH)]  # type: ignore[misc]


def baseline_sweep(count: int = SWEEP) -> list[Design]:
    """The baseline design with delta_alpha in steps of 0.001."""
    lag, *others = BASELINE
    return [(lag + SWEEP_STEP * (k - count // 2), *others) for k in range(count)]  # type: ignore[misc]
