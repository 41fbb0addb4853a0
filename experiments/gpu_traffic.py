"""Memory traffic of a jump: ``python -m experiments.gpu_traffic``.

A part of one jump is marched in plain Python, every access to its memory counted. An access
counts as traffic unless it hits one of the last few hundred numbers that were touched: a thread's
share of the caches. On a card those are about 128 numbers of L1 (256 KiB for 256 threads of a
multiprocessor), 350 with L2. Prints one JSON object, with the memory that robots take there.
"""

from collections import OrderedDict
from typing import Any, NamedTuple

import numpy as np

from snapjump.backend.cuda import CudaBackend
from snapjump.batch import simulate_batch, variant, variants
from snapjump.composition import Simulation, with_tier
from snapjump.engine import clock as c
from snapjump.engine import march as engine
from snapjump.engine.cuda.plan import make_plan
from snapjump.engine.recorder.none import NoRecorder
from snapjump.engine.view import PlainWork
from snapjump.engine.work import FIELDS, WINDOWS, Memory
from snapjump.scenes.card_march import SHARED
from snapjump.scenes.jump_march import jump_march
from snapjump.scenes.jump_start import jump_model

from .command import measured
from .designs import BASELINE, spread_designs

CACHES = {"l1": 128, "l1_and_l2": 350}
MANY = 10**9  # robots, more than any card has room for


class Cache:
    """The last so many numbers touched; what is read into it and written back from it, and how
    often a number was not in it."""

    def __init__(self, numbers: int):
        self.numbers = numbers
        self.reads = self.writes = self.misses = 0
        self.kept: OrderedDict[int, bool] = OrderedDict()  # address: whether it was written

    def touch(self, address: int, written: bool) -> None:
        """Access a number. A write needs no read before: whole lines are written at once."""
        if address in self.kept:
            self.kept.move_to_end(address)
            self.kept[address] |= written
            return
        self.misses += 1
        self.reads += not written
        self.kept[address] = written
        if len(self.kept) > self.numbers:
            _, dirty = self.kept.popitem(last=False)
            self.writes += dirty


class Counted:
    """An array that tells caches of every access."""

    def __init__(self, values: Any, addresses: Any, caches: list[Cache]):
        self.values, self.addresses, self.caches = values, addresses, caches

    @property
    def shape(self) -> tuple[int, ...]:
        return tuple(self.values.shape)

    def _touch(self, index: Any, written: bool) -> None:
        for cache in self.caches:
            cache.touch(int(self.addresses[index]), written)

    def __getitem__(self, index: Any) -> Any:
        part = self.values[index]
        if isinstance(part, np.ndarray):
            return Counted(part, self.addresses[index], self.caches)
        self._touch(index, False)
        return part

    def __setitem__(self, index: Any, value: Any) -> None:
        self._touch(index, True)
        self.values[index] = value


def counted(array: Any, caches: list[Cache]) -> Counted:
    """One lane's part of an array."""
    values = array[..., 0]
    addresses = np.full(values.shape, values.ctypes.data, dtype=np.int64)
    for axis, stride in enumerate(values.strides):
        places = stride * np.arange(values.shape[axis])
        addresses += places.reshape([-1 if k == axis else 1 for k in range(values.ndim)])
    return Counted(values, addresses, caches)


class Traffic(NamedTuple):
    """Bytes a pass that a cache of so many numbers reads and writes."""

    read: float
    written: float


def measure(simulation: Simulation, passes: int) -> dict[str, Traffic]:
    """Traffic of a jump's first ``passes`` passes for every size of cache."""
    model = jump_model(simulation)
    march = jump_march([simulation], [model])
    march.find_starts()
    caches = {name: Cache(numbers) for name, numbers in CACHES.items()}
    all_of_them = list(caches.values())

    def view(memory: Memory, lanes: Any) -> PlainWork:
        work = PlainWork(memory)
        for name, field in [*zip(FIELDS, FIELDS, strict=True), *WINDOWS.items()]:
            if field in FIELDS:
                setattr(work, name, counted(getattr(memory, name), all_of_them))
        return work

    compiled = engine.view_work
    vars(engine).update(view_work=view)  # uncompiled, the loop finds it by its name
    try:
        with np.errstate(all="ignore"):
            engine.march.py_func(
                model, march.masses, march.method, NoRecorder(), march.memory, march.queue, (0,),
                passes,
            )  # fmt: skip
    finally:
        vars(engine).update(view_work=compiled)
    done = float(march.memory.clock[c.ITERATIONS, 0])
    return {
        name: Traffic(8.0 * cache.reads / done, 8.0 * cache.writes / done)
        for name, cache in caches.items()
    }


def room(simulation: Simulation) -> dict[str, int]:
    """Bytes of a robot that is simulated on a card, and of one in the queue; how many are
    simulated at once in the memory that the backend takes by itself."""
    backend = CudaBackend()
    march = jump_march([simulation], [jump_model(simulation)])
    thread = march.memory.block.nbytes
    robot = sum(getattr(march.queue, name)[:1].nbytes for name in SHARED)
    plan = make_plan(MANY, thread, robot, backend.memory_gib, backend.threads_per_block)
    return {"bytes_a_thread": thread, "bytes_queued": robot, "robots_at_once": plan.threads}


def report(tier: str = "standard", passes: int = 60, designs: int = 256) -> dict[str, Any]:
    """Bytes that every cache reads and writes, the mean number of passes of jumps spread over the
    paper's ranges, and the memory that they take."""
    base = with_tier(tier)
    simulation = variant(base, BASELINE)
    batch = simulate_batch(variants(base, spread_designs(designs)))
    return {
        "tier": tier,
        "passes": passes,
        "nodes": len(simulation.discretization.masses()),
        "passes_of_a_jump": round(float(batch.newton_iterations.mean())),
        **room(simulation),
    } | {
        name: {
            "numbers": CACHES[name],
            "read_bytes_a_pass": round(traffic.read),
            "written_bytes_a_pass": round(traffic.written),
        }
        for name, traffic in measure(simulation, passes).items()
    }


if __name__ == "__main__":
    measured(report)
