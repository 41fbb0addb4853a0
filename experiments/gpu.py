"""What a graphics card makes of the paper's dataset: ``python -m experiments.gpu``.

Agreement with the processor, design by design; kernel time of the whole grid at every tier; bytes
moved against the bandwidth that the card's own copies reach, and where the gap goes. ``--tune``
also tries blocks and registers. Prints one JSON object; without a card, one line.
"""

import argparse
import itertools
import json
import sys
import time
from collections import Counter
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from experiments.designs import HIGH, LOW, spread_designs
from experiments.gpu_traffic import BASELINE, measure
from snapjump.backend.cuda import CudaBackend
from snapjump.backend.lanes import LanesBackend
from snapjump.batch import prepare_designs, variants
from snapjump.batch.simulate import marches
from snapjump.checks import ParameterError
from snapjump.composition import Simulation, with_tier
from snapjump.cuda.availability import check_card
from snapjump.engine import clock as c
from snapjump.engine.status import NAMES
from snapjump.scenes.card_march import CardMarch
from snapjump.scenes.runner import MOST_ITERATIONS, March
from snapjump.statics.threshold_curve import ThresholdCurve

WARP = 32
COMPRESSIONS = (LOW[1], HIGH[1])
COPIED_BYTES = 2**30
TRAFFIC_PASSES = 60
REGISTERS = (None, 168, 128, 96)  # None: as many as the compiler likes
BLOCKS = (32, 64, 128)


def grid(points: int) -> list[tuple[float, ...]]:
    """The paper's designs (delta_alpha, epsilon, m_bar, mu), so many values of each."""
    axes = [np.linspace(low, high, points) for low, high in zip(LOW, HIGH, strict=True)]
    return [tuple(float(v) for v in row) for row in itertools.product(*axes)]


def prepared(base: Simulation, designs: Sequence[tuple[float, ...]]) -> March:
    """A march of all designs, with their models and guesses."""
    curve = ThresholdCurve.through(base.robot, base.discretization, *COMPRESSIONS)
    ready = prepare_designs(base, np.array(designs), curve)
    backend = base.backend
    [(_, march)] = marches(
        ready.simulations, ready.models, backend.width, backend.thread_count, MOST_ITERATIONS
    )
    return march


def marched(base: Simulation, designs: Sequence[tuple[float, ...]]) -> March:
    """The same, simulated."""
    march = prepared(base, designs)
    march.find_starts()
    march.run()
    return march


def apexes(march: March) -> Any:
    """x_bar and y_bar of all designs (R, 2)."""
    outcome = march.queue.outcome
    fall = np.array([m.load.acceleration for m in march.models])
    rise = np.maximum(outcome[:, c.COM_VY], 0.0)
    x = outcome[:, c.COM_X] + outcome[:, c.COM_VX] * rise / fall
    return np.column_stack([x, outcome[:, c.COM_Y] + 0.5 * rise**2 / fall])


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
    """Registers, local memory and resident blocks of the marching kernel."""
    from numba import cuda

    from snapjump.cuda import kernels

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
    traffic = measure(variants(with_tier(tier), [BASELINE])[0], TRAFFIC_PASSES)
    bound = iterations * sum(traffic["l1_and_l2"]) / bandwidth
    busy = busy_share(march)
    return {
        "jumps": len(designs),
        "statuses": {
            NAMES[int(k)]: n for k, n in Counter(march.queue.outcome[:, c.STATUS]).items()
        },
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

    from snapjump.cuda import kernels

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
            models=march.models,
            masses=march.masses,
            states=march.states,
            simulation=replace(base, backend=CudaBackend(threads_per_block=block)),
            ending=march.ending,
            mesh=march.mesh,
        )
        for target, values in zip(tried.queue[1:5], starts, strict=True):
            target[...] = values
        tried.run()
        rows.append({"seconds": tried.kernel_seconds, **occupancy(tried)})
        print(rows[-1], file=sys.stderr)
    return rows


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--tiers", nargs="*", default=["draft", "standard"])
    parser.add_argument("--points", type=int, default=15, help="of the grid along each axis")
    parser.add_argument("--designs", type=int, default=256, help="compared with the processor")
    parser.add_argument("--tune", action="store_true", help="try blocks and registers")
    arguments = parser.parse_args()
    try:
        check_card(0)
    except ParameterError as error:
        print(error)
        sys.exit(2)
    from numba import cuda

    designs = grid(arguments.points)
    bandwidth = copy_bandwidth()
    name = cuda.get_current_device().name
    report: dict[str, Any] = {
        "card": name.decode() if isinstance(name, bytes) else str(name),
        "copy_bytes_a_second": bandwidth,
    }
    for tier in arguments.tiers:
        print(f"measuring {tier} ...", file=sys.stderr)
        report[tier] = {
            "agreement": agreement(tier, arguments.designs),
            **costs(tier, designs, bandwidth),
        }
        print(json.dumps({tier: report[tier]}), file=sys.stderr)
    if arguments.tune:
        report["tuning"] = tuning(arguments.tiers[-1], designs)
    print(json.dumps(report, indent=2))


if __name__ == "__main__":
    main()
