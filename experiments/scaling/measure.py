"""Throughput at several widths and numbers of threads, in turns, so that whatever else loads the
machine meets all of them."""

import statistics
import time
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from snapjump.batch import Batch, simulate_designs
from snapjump.composition import Simulation
from snapjump.scenes.jump_outputs import ENDED
from snapjump.statics.threshold_curve import ThresholdCurve

from ..designs import spread_designs

Setting = tuple[int, int]  # lanes, threads


@dataclass(frozen=True)
class Throughput:
    """Of one setting, medians over repeats: jumps/s by the clock, and of a core in the kernels;
    microseconds of a core for a robot's Newton iteration, and for a lane's pass, with a robot or
    without; the share of passes without one; and the number of jumps that failed."""

    jumps_per_second: float
    jumps_per_second_core: float
    us_per_iteration: float
    us_per_pass: float
    idle_share: float
    failed: int


def measure(
    base: Simulation, curve: ThresholdCurve, settings: Sequence[Setting], count: int, repeats: int
) -> dict[Setting, Throughput]:
    """Simulate the same designs in every setting, several times."""
    designs = np.array(spread_designs(count))
    runs: dict[Setting, list[tuple[float, Batch]]] = {setting: [] for setting in settings}
    for lanes, threads in settings:
        simulate_designs(base, designs[:1], curve=curve, lanes=lanes, threads=threads)
    for _ in range(repeats):
        for lanes, threads in settings:
            begun = time.perf_counter()
            batch = simulate_designs(base, designs, curve=curve, lanes=lanes, threads=threads)
            runs[lanes, threads].append((time.perf_counter() - begun, batch))
    return {setting: throughput(done, count) for setting, done in runs.items()}


def throughput(runs: Sequence[tuple[float, Batch]], count: int) -> Throughput:
    """The throughput of one setting from its runs, each with its seconds by the clock."""
    kernels = statistics.median(batch.march_seconds for _, batch in runs)
    passes = statistics.median(batch.lane_passes for _, batch in runs)
    one = runs[0][1]
    iterations = float(one.newton_iterations.sum())
    return Throughput(
        count / statistics.median(seconds for seconds, _ in runs),
        count / kernels,
        1e6 * kernels / iterations,
        1e6 * kernels / passes,
        1.0 - iterations / passes,
        sum(status not in ENDED for status in one.status),
    )
