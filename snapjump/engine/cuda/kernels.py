"""The programs of the card: every thread runs the engine's own loop on one robot after another.

A thread has one column of every array of the memory, which is laid out with the robots last so
that neighbouring threads read neighbouring numbers, and takes its robots from a queue that all
share. To it both look like the memory and the queue of a march of width one: what it runs is
:func:`snapjump.engine.march.march` itself, compiled from the same source.
"""

from typing import Any

from numba import cuda

from snapjump.engine import march as engine
from snapjump.engine.cuda.availability import simulated
from snapjump.engine.march import Queue
from snapjump.engine.work import System, Work

# Optimised once more when it is linked, a program would be compiled with roundings merged (see
# snapjump.engine.cuda.rounding). The simulator, which links nothing, does not know the word.
PROGRAM = {"cache": True} if simulated() else {"cache": True, "lto": False}
device_function = cuda.jit(device=True)
find_starts_of_thread = device_function(engine.find_starts.py_func)
march_of_thread = device_function(engine.march.py_func)


@device_function
def own_memory(memory: Any, thread: Any) -> Work:
    """The thread's column of every array, as the memory of one lane."""
    lane = slice(thread, thread + 1)
    system = memory.system
    return Work(
        memory.state[:, lane],
        memory.start[:, lane],
        memory.origin[:, lane],
        memory.drift[:, lane],
        memory.change[:, lane],
        memory.velocity[:, :, lane],
        memory.acceleration[:, :, lane],
        memory.sliding_velocity[:, lane],
        memory.active_set[:, lane],
        memory.clock[:, lane],
        memory.numbers[:, lane],
        memory.weights[:, lane],
        memory.mesh,
        System(
            system.residual[:, lane],
            system.band[:, :, lane],
            system.border[:, :, lane],
            system.padded_residual[:, lane],
            system.padded_band[:, :, lane],
            system.padded_border[:, :, lane],
            system.frame_residual[:, lane],
            system.square[:, :, lane],
            system.mounts[:, lane],
            system.padded_frame_residual[:, lane],
            system.frame_band[:, :, lane],
            system.frame_border[:, :, lane],
            system.levers[:, :, lane],
            system.last_residual[:, lane],
            system.last_square[:, :, lane],
        ),
    )


@device_function
def own_queue(queue: Any, thread: Any) -> Queue:
    """The queue that all share, with the thread's own counts and robot."""
    return Queue(
        queue.numbers,
        queue.state,
        queue.velocity,
        queue.acceleration,
        queue.status,
        queue.outcome,
        queue.cursor,
        queue.counts[thread],
        queue.carried[thread : thread + 1],
    )


@cuda.jit(**PROGRAM)
def clear(numbers: Any) -> None:
    """Set all numbers of an array to zero."""
    for k in range(cuda.grid(1), numbers.shape[0], cuda.gridsize(1)):
        numbers[k] = 0.0


@cuda.jit(**PROGRAM)
def find_starts(template: Any, masses: Any, memory: Any, queue: Any, blocks: Any) -> None:
    """Follow the static branches of at most ``blocks`` robots a thread to their starts."""
    thread = cuda.grid(1)
    if thread < memory.clock.shape[1]:
        own = own_memory(memory, thread)
        find_starts_of_thread(template, masses, own, own_queue(queue, thread), (0,), blocks)


@cuda.jit(**PROGRAM)
def march(
    template: Any,
    masses: Any,
    scheme: Any,
    stepping: Any,
    ending: Any,
    limits: Any,
    recorder: Any,
    memory: Any,
    queue: Any,
    passes: Any,
) -> None:
    """Go on with every thread's robots for at most so many passes of the time loop."""
    thread = cuda.grid(1)
    if thread < memory.clock.shape[1]:
        march_of_thread(
            template,
            masses,
            scheme,
            stepping,
            ending,
            limits,
            recorder,
            own_memory(memory, thread),
            own_queue(queue, thread),
            (0,),
            passes,
        )
