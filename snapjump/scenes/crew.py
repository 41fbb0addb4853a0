"""Threads that work through one queue, in slices so short that they stop when they are told to."""

import time
from collections.abc import Callable, Sequence
from concurrent.futures import FIRST_EXCEPTION, ThreadPoolExecutor, wait
from dataclasses import dataclass
from threading import Event
from typing import Any

from snapjump.engine.queue import Queue
from snapjump.engine.recorder.none import NoRecorder
from snapjump.engine.work import Memory

REPORT_EVERY_S = 0.1


@dataclass
class Worker:
    """A thread's memory, its view of the queue (robots and cursor are everyone's, what its lanes
    carry is its own), its recorder, and the seconds of a core that its kernels have taken, which
    do not count while other programs have the core."""

    memory: Memory
    queue: Queue
    recorder: Any = NoRecorder()
    kernel_seconds: float = 0.0


Advance = Callable[[Worker], bool]


def run_crew(crew: Sequence[Worker], advance: Advance, report: Callable[[], None]) -> None:
    """Call ``advance`` for every worker until it returns True: none of the work is left.

    A single worker works in this thread, several in one each. ``report`` is called now and then.
    Whatever is raised here or in a thread stops all of them after the slice they are in.
    """
    stop = Event()

    def work(worker: Worker) -> None:
        done = False
        while not (done or stop.is_set()):
            begun = time.thread_time()
            done = advance(worker)
            worker.kernel_seconds += time.thread_time() - begun
            if len(crew) == 1:
                report()

    if len(crew) == 1:
        work(crew[0])
        return
    with ThreadPoolExecutor(len(crew)) as pool:
        try:
            running = {pool.submit(work, worker) for worker in crew}
            while running:
                done, running = wait(running, REPORT_EVERY_S, FIRST_EXCEPTION)
                for future in done:
                    future.result()
                report()
        finally:
            stop.set()
