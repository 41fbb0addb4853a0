"""Errors and cost by the integrator's spectral radius: ``python -m experiments.radius``.

Of a tier (``--tier``), otherwise as it is, against a truth of other integrator, mesh and steps
(that of :mod:`experiments.claims`), for each of that command's kinds of robots.
"""

import sys
from typing import Any

import numpy as np

from snapjump.composition import with_tier
from snapjump.files.cores import own_cores

from .claims.judge import (
    MOST_ITERATIONS,
    SECOND,
    TRUTH_ITERATIONS,
    drawn,
    errors,
    found,
    true_setting,
)
from .claims.robots import KINDS
from .command import measured

RADII = (0.0, 0.2, 0.3, 0.5, 0.8)
QUANTILES = (0.5, 0.75, 0.95)


def report(
    robots: int = 200, seed: int = 12, threads: int = len(own_cores()), tier: str = "standard"
) -> dict[str, Any]:
    """By kind of robots and radius: mean Newton iterations, and quantiles of the larger error (%)
    of x and y, a robot that does not jump having an infinite one."""
    table: dict[str, Any] = {"tier": tier, "robots": robots, "quantiles": QUANTILES}
    for kind in KINDS:
        print(f"{kind} ...", file=sys.stderr)
        kept, _ = drawn(kind, robots, seed, threads)
        truth = found(true_setting(SECOND), kept, TRUTH_ITERATIONS, threads)
        table[kind] = {}
        for radius in RADII:
            integrator = with_tier(tier).integrator.changed(spectral_radius=radius)
            base = with_tier(tier, integrator=integrator)
            ours = found(base, kept, MOST_ITERATIONS, threads)
            worst = errors(ours, truth)
            ranked = np.sort(np.where(np.isnan(worst), np.inf, worst))
            places = [int(share * (len(ranked) - 1)) for share in QUANTILES]
            table[kind][f"{radius:g}"] = {
                "newton_iterations": round(float(np.nanmean(ours.iterations))),
                "error_percent": [float(f"{ranked[place]:.3g}") for place in places],
            }
    return table


if __name__ == "__main__":
    measured(report)
