"""What outputs that are recorded cost a batch: ``python -m experiments.outputs`` prints JSON.

Kernel times of batches with and without, one after the other in turn so that a machine's moods meet
all of them; ``over_plain``: the median of their ratios to the batch without in the same turn.
"""

import statistics
from typing import Any

from snapjump.batch import simulate_batch, variants
from snapjump.batch.loads import OFFERED
from snapjump.composition import with_tier

from .command import measured
from .designs import spread_designs

LANES = 8
ASKED = {
    "none": (),
    "max_strain": ("max_strain",),
    "peak_clamp_torque_N_m": ("peak_clamp_torque_N_m",),
    "peak_ground_force_N": ("peak_ground_force_N",),
    "all": tuple(one.name for one in OFFERED),
}


def report(designs: int = 256, repeats: int = 7, tier: str = "standard") -> Any:
    """Milliseconds of a core a jump, and what they are over those without."""
    simulations = variants(with_tier(tier), spread_designs(designs))
    seconds: dict[str, list[float]] = {name: [] for name in ASKED}
    for outputs in ASKED.values():
        simulate_batch(simulations[:1], LANES, outputs=outputs)
    for _ in range(repeats):
        for name, outputs in ASKED.items():
            batch = simulate_batch(simulations, LANES, outputs=outputs)
            seconds[name].append(batch.march_seconds)
    return {
        name: {
            "ms_per_jump_core": round(1e3 * statistics.median(taken) / designs, 4),
            "over_plain": round(
                statistics.median(a / b for a, b in zip(taken, seconds["none"], strict=True)), 3
            ),
        }
        for name, taken in seconds.items()
    }


if __name__ == "__main__":
    measured(report)
