"""Computing time of a jump: ``python -m experiments.speed`` prints one JSON object.

Times are those of one core with compiled kernels. ``ms_per_jump_core`` is the median over the
designs of a design's share (by Newton iterations) of the batch's kernel time, starts, refilling
and idle lanes included; ``jumps_per_second_core`` is the plain throughput of the same batch.
"""

import statistics
import sys
from dataclasses import replace
from typing import Any

import numpy as np

from snapjump.batch import Batch, simulate_batch, variants
from snapjump.composition import Simulation, with_tier
from snapjump.scenes.jump_outputs import ENDED
from snapjump.simulation import simulate
from snapjump.tiers import TIERS

from .command import measured
from .designs import spread_designs

LANES = 8
NODES = (56, 112, 224, 448)


def costs(base: Simulation, count: int, lanes: int, repeats: int) -> tuple[Batch, float]:
    """The batch whose kernel time is the median of several, and its microseconds an iteration."""
    simulations = variants(base, spread_designs(count))
    simulate_batch(simulations[:1], lanes)
    batches = [simulate_batch(simulations, lanes) for _ in range(repeats)]
    batch = sorted(batches, key=lambda b: b.march_seconds)[repeats // 2]
    return batch, 1e6 * batch.march_seconds / float(np.sum(batch.newton_iterations))


def tier_costs(name: str, count: int, repeats: int) -> dict[str, float]:
    """The figures of one tier at eight lanes."""
    batch, microseconds = costs(with_tier(name), count, LANES, repeats)
    iterations = float(np.median(batch.newton_iterations))
    return {
        "ms_per_jump_core": round(1e-3 * iterations * microseconds, 4),
        "jumps_per_second_core": round(count / batch.march_seconds, 2),
        "newton_iterations": iterations,
        "us_per_newton_iteration": round(microseconds, 4),
        "failed": sum(s not in ENDED for s in batch.status),
    }


def node_slope(count: int) -> float:
    """Exponent with which the time of a Newton iteration grows with the number of elements."""
    base = with_tier("draft")
    meshes = [base.discretization.changed(elements=elements) for elements in NODES]
    times = [costs(replace(base, discretization=m), count, LANES, 1)[1] for m in meshes]
    return float(np.polyfit(np.log(NODES), np.log(times), 1)[0])


def report(designs: int = 256, repeats: int = 3, tiers: tuple[str, ...] = (*TIERS,)) -> Any:
    """All figures."""
    found: dict[str, Any] = {}
    for name in tiers:
        print(f"measuring {name} ...", file=sys.stderr)
        found[name] = tier_costs(name, designs, repeats)
    standard = with_tier("standard")
    lanes = [costs(standard, 32, LANES, 1)[1] for _ in range(3)]
    scalar = [costs(standard, 8, 1, 1)[1] for _ in range(3)]
    simulate(standard)
    single = [simulate(standard).summary["kernel_seconds"] for _ in range(5)]
    return {
        **found,
        "lanes_over_scalar": round(statistics.median(scalar) / statistics.median(lanes), 3),
        "single_jump_kernel_seconds": round(statistics.median(single), 4),
        "time_per_iteration_over_elements_slope": round(node_slope(32), 3),
    }


if __name__ == "__main__":
    measured(report)
