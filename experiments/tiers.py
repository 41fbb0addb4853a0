"""How far off each accuracy tier is: ``python -m experiments.tiers`` prints a table.

Every tier but ``paper`` solves the same physical model; its error is measured against that
model's converged limit, here a finer mesh and a tighter tolerance than any tier has, over designs
spread over the paper's ranges. Errors of x are relative to max(|x|, 0.1 y). ``paper`` is a
different model (no material damping, stiffness per node) and is compared with the same limit.
Roughness is the standard deviation (in L) of the result less the converged one, about a line,
when delta_alpha is swept in steps of 0.001 about the baseline.
"""

import argparse
import json
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from experiments.designs import spread_designs
from snapjump.accuracy import TIERS
from snapjump.batch import Batch, simulate_batch, variants
from snapjump.composition import Simulation, with_tier

Array = NDArray[np.float64]
FINEST_ELEMENTS = 448
FINEST_TOLERANCE = 5e-10
SWEEP = 21


def converged() -> Simulation:
    """The simulation that others are judged by."""
    base = with_tier("reference")
    return replace(
        base,
        discretization=replace(base.discretization, elements=FINEST_ELEMENTS),
        stepping=replace(base.stepping, tolerance=FINEST_TOLERANCE, contact_steps=0.5),
    )


def relative_errors(batch: Batch, limit: Batch) -> tuple[Array, Array]:
    """Errors of x and y in percent, NaN for failures."""
    scale = np.maximum(np.abs(limit.x_bar), 0.1 * limit.y_bar)
    return (
        100.0 * np.abs(batch.x_bar - limit.x_bar) / scale,
        100.0 * np.abs(batch.y_bar - limit.y_bar) / limit.y_bar,
    )


def roughness(values: Array) -> float:
    """Standard deviation about a line."""
    place = np.arange(len(values))
    return float(np.std(values - np.polyval(np.polyfit(place, values, 1), place)))


def baseline_sweep() -> list[tuple[float, float, float, float]]:
    """The baseline design with delta_alpha in steps of 0.001."""
    return [(0.1 + 0.001 * (k - SWEEP // 2), 0.2, 0.768, 0.3) for k in range(SWEEP)]


def measure(count: int, tiers: list[str]) -> dict[str, dict[str, float]]:
    """The figures of every tier."""
    designs, sweep = spread_designs(count), baseline_sweep()
    finest = converged()
    limit = simulate_batch(variants(finest, designs))
    limit_sweep = simulate_batch(variants(finest, sweep))
    table = {}
    for name in tiers:
        base = with_tier(name)
        batch = simulate_batch(variants(base, designs))
        swept = simulate_batch(variants(base, sweep))
        x, y = relative_errors(batch, limit)
        table[name] = {
            "x_error_median_percent": float(np.nanmedian(x)),
            "x_error_p95_percent": float(np.nanpercentile(x, 95)),
            "x_error_max_percent": float(np.nanmax(x)),
            "y_error_median_percent": float(np.nanmedian(y)),
            "y_error_p95_percent": float(np.nanpercentile(y, 95)),
            "y_error_max_percent": float(np.nanmax(y)),
            "x_roughness_bar": roughness(swept.x_bar - limit_sweep.x_bar),
            "y_roughness_bar": roughness(swept.y_bar - limit_sweep.y_bar),
            "newton_iterations": float(np.median(batch.newton_iterations)),
            "ms_per_jump_core": 1e3
            * float(np.median(batch.newton_iterations))
            * batch.kernel_seconds
            / float(np.sum(batch.newton_iterations)),
            "failed": float(sum(s not in ("ok", "no_jump") for s in batch.status)),
        }
    return table


def main() -> None:
    """Measure and print JSON, every figure to three significant digits."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--designs", type=int, default=128)
    parser.add_argument("--tiers", nargs="*", default=list(TIERS), choices=list(TIERS))
    arguments = parser.parse_args()
    table = measure(arguments.designs, arguments.tiers)
    rounded = {n: {k: float(f"{v:.3g}") for k, v in row.items()} for n, row in table.items()}
    print(json.dumps(rounded, indent=2))


if __name__ == "__main__":
    main()
