"""A profile of a pass of the time loop: times of its pieces on states frozen along a march.

Each piece is compiled by itself, so that the time of a part is a difference: of contact, for
example, that of the assembly with it and without.
"""

import statistics
import time
import timeit
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from typing import Any

from numba import njit

from snapjump.composition import Simulation
from snapjump.contact.none import NoContact
from snapjump.engine.assemble import assemble
from snapjump.engine.clock import TIME
from snapjump.engine.linearised import solve_in_registers
from snapjump.engine.march import march as march_on
from snapjump.engine.model import Model, with_numbers
from snapjump.engine.newton import StageLimits, newton_iteration
from snapjump.engine.stage import stage_motion
from snapjump.engine.view import view_work
from snapjump.engine.work import FIELDS, Memory, make_memory
from snapjump.friction.none import NoFriction
from snapjump.scenes.jump_march import jump_march
from snapjump.scenes.runner import March

MOMENTS = 8
PASSES_BETWEEN = 250
REPEATS, COUNT, PASSES = 9, 100, 20
LIMITS = StageLimits(1e-9, 0.1, 25.0, 4.0)


@njit(cache=True, error_model="numpy")
def frozen(template: Any, scheme: Any, memory: Any, lanes: Any) -> Any:
    """Model, stage and memory of lanes, at a state that does not move."""
    work = view_work(memory, lanes)
    return with_numbers(template, work.numbers), stage_motion(scheme, work), work


@njit(cache=True, error_model="numpy")
def assemble_often(
    template: Any, masses: Any, scheme: Any, memory: Any, lanes: Any, count: int
) -> None:
    """Residual and tangent, node by node."""
    model, motion, work = frozen(template, scheme, memory, lanes)
    for _ in range(count):
        assemble(model, motion, masses, work)


@njit(cache=True, error_model="numpy")
def solve_often(
    template: Any, masses: Any, scheme: Any, memory: Any, lanes: Any, count: int
) -> None:
    """Residual and tangent, and the solution of the linear system."""
    model, motion, work = frozen(template, scheme, memory, lanes)
    for _ in range(count):
        solve_in_registers(model, motion, masses, work)


@njit(cache=True, error_model="numpy")
def iterate_often(
    template: Any, masses: Any, scheme: Any, memory: Any, lanes: Any, count: int
) -> None:
    """A whole Newton iteration, of which no lane takes the correction."""
    model, motion, work = frozen(template, scheme, memory, lanes)
    nobody = work.clock[TIME] < -1.0
    for _ in range(count):
        newton_iteration(model, motion, masses, work, nobody, LIMITS)


def typical(call: Callable[[int], object], count: int) -> float:
    """Microseconds of a core for one of ``count`` calls: the median of several times."""
    times = timeit.repeat(lambda: call(count), timer=time.thread_time, number=1, repeat=REPEATS)
    return 1e6 * statistics.median(times) / count


@contextmanager
def untouched(memory: Memory) -> Iterator[None]:
    """Put back afterwards what lanes carry on from pass to pass."""
    kept = memory.block.copy()
    yield
    memory.block[...] = kept


def groundless(model: Model, memory: Memory) -> tuple[Model, Memory]:
    """The model without contact and friction, and its memory in the same state."""
    kept: list[int] = []
    position = 0
    for name, member in zip(Model._fields, model, strict=True):
        if name not in ("contact", "friction"):
            kept += range(position, position + len(member))
        position += len(member)
    other = make_memory(memory.sizes._replace(numbers=len(kept)), memory.mesh)
    for name in FIELDS:
        values = getattr(memory, name)
        getattr(other, name)[...] = values[kept] if name == "numbers" else values
    return model._replace(contact=NoContact.Law(), friction=NoFriction.Law()), other


def pieces(march: March) -> dict[str, tuple[Any, Model, Memory]]:
    """Kernels, each of which does more of a Newton iteration than the one before, and what they
    do it with."""
    model, memory = march.models[0], march.crew[0].memory
    return {
        "free": (assemble_often, *groundless(model, memory)),
        "assembly": (assemble_often, model, memory),
        "solution": (solve_often, model, memory),
        "iteration": (iterate_often, model, memory),
    }


def caller(march: March, kernel: Any, model: Model, memory: Memory) -> Callable[[int], object]:
    """A function that has a kernel do its piece so many times, and has done it once."""
    lanes = (0,) * march.lanes

    def call(count: int) -> None:
        kernel(model, march.masses, march.scheme, memory, lanes, count)

    call(1)
    return call


def timed(march: March) -> dict[str, float]:
    """Microseconds of the pieces of all lanes, at the state they are in."""
    return {name: typical(caller(march, *piece), COUNT) for name, piece in pieces(march).items()}


def parts(found: Mapping[str, Any]) -> dict[str, Any]:
    """What each part of a pass adds, of what the pieces and a whole pass take.

    ``stages``: what a pass does besides the Newton iteration (stages and steps that begin and
    end, error estimates, the ending, refilling).
    """
    return {
        "assembly": found["free"],
        "contact": found["assembly"] - found["free"],
        "solve": found["solution"] - found["assembly"],
        "correction": found["iteration"] - found["solution"],
        "stages": found["pass"] - found["iteration"],
        "pass": found["pass"],
    }


def moments(march: March) -> Iterator[Callable[[int], object]]:
    """Moments of a march; yields what marches on for so many passes."""
    worker = march.crew[0]
    march.find_starts()
    march_on(*march.arguments(worker), 1)
    for _ in range(MOMENTS):
        march_on(*march.arguments(worker), PASSES_BETWEEN)
        yield lambda count: march_on(*march.arguments(worker), count)


def split(simulations: Sequence[Simulation], models: Sequence[Model], lanes: int) -> dict[str, Any]:
    """Microseconds of a pass's parts for one lane: means over moments of a march."""
    march = jump_march(simulations, models, lanes=lanes)
    rows: list[dict[str, float]] = []
    for go_on in moments(march):
        whole = typical(go_on, PASSES)
        with untouched(march.crew[0].memory):
            rows.append(parts({**timed(march), "pass": whole}))
    return {key: round(statistics.mean(row[key] for row in rows) / lanes, 4) for key in rows[0]}
