"""The paper's dataset on a graphics card: ``python -m experiments.gpu``.

Agreement with the processor, design by design; kernel time of the whole grid at every tier; bytes
moved against the bandwidth that the card's own copies reach, and where the gap goes. ``--tune``
also tries blocks and registers. Prints one JSON object; without a card, one line. On numba's
simulator of a card (``NUMBA_ENABLE_CUDASIM=1``) it runs a few robots, and times mean nothing.
"""

import itertools
import json
import sys
import time
from collections import Counter
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from snapjump.backend.cuda import CudaBackend
from snapjump.backend.lanes import LanesBackend
from snapjump.batch import prepare_designs, variant
from snapjump.batch.simulate import marches
from snapjump.composition import Simulation, with_tier
from snapjump.engine import outcome as c
from snapjump.engine.cuda.availability import check_card, simulated
from snapjump.engine.status import NAMES
from snapjump.scenes.card_march import CardMarch
from snapjump.scenes.flight import flight
from snapjump.scenes.march_outputs import side_by_side
from snapjump.scenes.runner import MOST_ITERATIONS, March
from snapjump.statics.threshold_curve import ThresholdCurve

from .command import measured
from .designs import BASELINE, HIGH, LOW, spread_designs
from .gpu_traffic import measure

WARP = 32
COMPRESSIONS = (LOW[1], HIGH[1])
COPIED_BYTES = 2**30
TRAFFIC_PASSES = 60
REGISTERS = (None, 168, 128, 96)  # None: as many as the compiler likes
BLOCKS = (32, 64, 128)


def grid(points: int) -> list[tuple[float, ...]]:
    """The paper's designs (delta_alpha, epsilon, mass_bar, mu), so many values of each."""
    axes = [np.linspace(low, high, points) for low, high in zip(LOW, HIGH, strict=True)]
    return [tuple(float(v) for v in row) for row in itertools.product(*axes)]


def prepared(base: Simulation, designs: Sequence[tuple[float, ...]]) -> March:
    """A march of all designs, with their models and guesses."""
    curve = ThresholdCurve.through(base.robot, base.discretization, *COMPRESSIONS)
    ready = prepare_designs(base, np.array(designs), curve)
    backend = base.backend
    [(_, march)] = marches(ready, backend.width, backend.thread_count, MOST_ITERATIONS)
    return march


def marched(base: Simulation, designs: Sequence[tuple[float, ...]]) -> March:
    """A march of all designs, simulated."""
    march = prepared(base, designs)
    march.find_starts()
    march.run()
    return march


def apexes(march: March) -> Any:
    """x_bar and y_bar of all designs (R, 2)."""
    models = side_by_side(march.models, range(len(march.models)), len(march.models))
    flown = flight(0.0, models.load, march.queue.outcome)
    return np.column_stack([flown.apex_x, flown.apex_y])


def agreement(tier: str, count: int) -> dict[str, Any]:
    """Card against processor, design by design: to the last bit, as both round alike."""
    designs = spread_designs(count)
    card = marched(with_tier(tier, backend=CudaBackend()), designs)
    processor = marched(with_tier(tier, backend=LanesBackend()), designs)
    starts = np.max(np.abs(card.queue.state - processor.queue.state))
    a, b = card.queue.outcome, processor.queue.outcome
    apart = apexes(card) - apexes(processor)
    largest = np.max(np.abs(apart), axis=1)
    spread = np.std(apexes(processor), axis=0)
    return {
        "designs": count,
        "largest_difference_of_starts_bar": float(starts),
        "same_status": int(np.sum(a[:, c.STATUS] == b[:, c.STATUS])),
        "same_iterations": int(np.sum(a[:, c.ITERATIONS] == b[:, c.ITERATIONS])),
        "same_bits": int(np.sum(np.all(a == b, axis=1))),
        "within_1e-9": int(np.sum(largest <= 1e-9)),
        "difference_bar_median": float(np.median(largest)),
        "difference_bar_95th_percentile": float(np.quantile(largest, 0.95)),
        "difference_bar_largest": float(np.max(largest)),
        "mean_difference_over_spread_x_y": (np.mean(apart, axis=0) / spread).tolist(),
    }


def copy_bandwidth() -> float:
    """Bytes a second that a copy within the card reads and writes."""
    from numba import cuda

    source = cuda.device_array(COPIED_BYTES // 8)
    target = cuda.device_array(COPIED_BYTES // 8)
    seconds = []
    for _ in range(5):
        begun, ended = cuda.event(), cuda.event()
        begun.record()
        target.copy_to_device(source)
        ended.record()
        ended.synchronize()
        seconds.append(1e-3 * begun.elapsed_time(ended))
    return 2.0 * COPIED_BYTES / min(seconds)


def occupancy(march: CardMarch) -> dict[str, Any]:
    """Registers, local memory and resident blocks of the marching kernel; of a card alone."""
    if simulated():
        return {}
    from numba import cuda

    from snapjump.engine.cuda import kernels

    program = next(iter(kernels.march.overloads.values()))
    block = march.plan.threads_per_block
    resident = cuda.current_context().get_active_blocks_per_multiprocessor(
        program._codelibrary.get_cufunc(), block, 0
    )
    processors = cuda.get_current_device().MULTIPROCESSOR_COUNT
    return {
        "registers_a_thread": program.regs_per_thread,
        "local_bytes_a_thread": program.local_mem_per_thread,
        "threads_per_block": block,
        "blocks_a_multiprocessor": resident,
        "threads_resident_at_once": resident * block * processors,
        "threads_planned": march.plan.threads,
    }


def busy_share(march: CardMarch) -> float:
    """Passes of threads over those of their warps, which last as long as their longest thread."""
    used = taken = 0
    for passes in march.passes_of_threads:
        warps = passes.reshape(-1, WARP)
        used += int(warps.sum())
        taken += WARP * int(warps.max(axis=1).sum())
    return used / taken


def costs(tier: str, designs: Sequence[tuple[float, ...]], bandwidth: float) -> dict[str, Any]:
    """Time of the whole grid, and the bandwidth that it would need."""
    begun = time.perf_counter()
    base = with_tier(tier, backend=CudaBackend())
    march = prepared(base, designs)
    assert isinstance(march, CardMarch)
    ready = time.perf_counter()
    march.find_starts()
    starts = march.kernel_seconds
    march.run()
    ended = time.perf_counter()
    seconds = march.kernel_seconds - starts
    iterations = float(march.queue.outcome[:, c.ITERATIONS].sum())
    traffic = measure(variant(with_tier(tier), BASELINE), TRAFFIC_PASSES)
    bound = iterations * sum(traffic["l1_and_l2"]) / bandwidth
    busy = busy_share(march)
    return {
        "jumps": len(designs),
        "statuses": Counter(NAMES[int(k)] for k in march.queue.outcome[:, c.STATUS]),
        "kernel_seconds": march.kernel_seconds,
        "kernel_seconds_of_starts": starts,
        "kernel_seconds_of_marches": seconds,
        "seconds_to_prepare_on_processor": ready - begun,
        "wall_seconds_of_card": ended - ready,
        "jumps_per_kernel_second": len(designs) / march.kernel_seconds,
        "newton_iterations": iterations,
        "nanoseconds_an_iteration": 1e9 * seconds / iterations,
        "bytes_sent": march.card.bytes_sent,
        "bytes_fetched": march.card.bytes_fetched,
        "estimated_bytes_an_iteration": sum(traffic["l1_and_l2"]),
        "seconds_at_full_bandwidth": bound,
        "share_of_bandwidth": bound / seconds,
        "threads_busy_in_their_warps": busy,
        "share_of_bandwidth_while_busy": bound / seconds / busy,
        **occupancy(march),
    }


def tuning(tier: str, designs: Sequence[tuple[float, ...]]) -> list[dict[str, Any]]:
    """Seconds of the marches for other blocks and registers."""
    from numba import cuda

    from snapjump.engine.cuda import kernels

    source = kernels.march.py_func
    base = with_tier(tier, backend=CudaBackend())
    march = prepared(base, designs)
    assert isinstance(march, CardMarch)
    march.find_starts()
    starts = [values.copy() for values in march.queue[1:5]]
    rows = []
    for registers, block in itertools.product(REGISTERS, BLOCKS):
        if block == BLOCKS[0]:
            kernels.march = cuda.jit(lto=False, max_registers=registers)(source)
        tried = CardMarch(
            models=march.models, masses=march.masses, states=march.states,
            termination=march.termination, mesh=march.mesh,
            simulation=replace(base, backend=CudaBackend(threads_per_block=block)),
        )  # fmt: skip
        for target, values in zip(tried.queue[1:5], starts, strict=True):
            target[...] = values
        tried.run()
        rows.append({"seconds": tried.kernel_seconds, **occupancy(tried)})
        print(rows[-1], file=sys.stderr)
    return rows


def report(
    tiers: tuple[str, ...] = ("draft", "standard"),
    points: int = 15,
    designs: int = 256,
    tune: bool = False,
) -> dict[str, Any]:
    """All figures; ``points`` of the grid along each axis, ``designs`` for the processor, too."""
    check_card(0)
    from numba import cuda

    every = grid(points)
    bandwidth = copy_bandwidth()
    name = "simulator" if simulated() else cuda.get_current_device().name
    found: dict[str, Any] = {
        "card": name.decode() if isinstance(name, bytes) else str(name),
        "copy_bytes_a_second": bandwidth,
    }
    for tier in tiers:
        print(f"measuring {tier} ...", file=sys.stderr)
        same = agreement(tier, designs)
        found[tier] = {"agreement": same, **costs(tier, every, bandwidth)}
        print(json.dumps({tier: found[tier]}), file=sys.stderr)
    return {**found, "tuning": tuning(tiers[-1], every)} if tune else found


if __name__ == "__main__":
    measured(report)
