"""The programs of the card: every thread runs the engine's own loop on one robot after another.

A thread has one column of the memory's block, so that neighbouring threads read neighbouring
numbers, and takes its robots from a queue that all share. To it both look like the memory and the
queue of a march of width one: what it runs is :func:`snapjump.engine.march.march` itself, compiled
from the same source.
"""

from typing import Any

from numba import cuda

from snapjump.engine import march as engine
from snapjump.engine.cuda.availability import simulated
from snapjump.engine.queue import Queue
from snapjump.engine.work import Memory

# Optimised once more when it is linked, a program would be compiled with roundings merged (see
# snapjump.engine.cuda.rounding). The simulator, which links nothing, does not know the word.
PROGRAM = {"cache": True} if simulated() else {"cache": True, "lto": False}
device_function = cuda.jit(device=True)
find_starts_of_thread = device_function(engine.find_starts.py_func)
march_of_thread = device_function(engine.march.py_func)


@device_function
def own_memory(memory: Any, thread: Any) -> Memory:
    """The thread's column of the block, as the memory of one lane."""
    return Memory(memory.block[:, thread : thread + 1], memory.sizes, memory.mesh)


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
    if thread < memory.block.shape[1]:
        own = own_memory(memory, thread)
        find_starts_of_thread(template, masses, own, own_queue(queue, thread), (0,), blocks)


@cuda.jit(**PROGRAM)
def march(
    template: Any, masses: Any, method: Any, recorder: Any, memory: Any, queue: Any, passes: Any
) -> None:
    """Go on with every thread's robots for at most so many passes of the time loop."""
    thread = cuda.grid(1)
    if thread < memory.block.shape[1]:
        march_of_thread(
            template,
            masses,
            method,
            recorder,
            own_memory(memory, thread),
            own_queue(queue, thread),
            (0,),
            passes,
        )
