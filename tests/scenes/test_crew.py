"""Threads that share work: all of it is done, and whatever goes wrong stops them all at once."""

import time
from itertools import count

import pytest

from snapjump.scenes.crew import Worker, run_crew


def crew(size):
    return [Worker(None, None) for _ in range(size)]


@pytest.mark.parametrize("size", [1, 3])
def test_slices_until_nothing_is_left(size):
    workers = crew(size)
    slices = {id(worker): 0 for worker in workers}
    reports = []

    def advance(worker):
        time.sleep(0.01)
        slices[id(worker)] += 1
        return slices[id(worker)] == 20

    run_crew(workers, advance, lambda: reports.append(sum(slices.values())))
    assert set(slices.values()) == {20}
    assert reports[-1] == 20 * size
    assert len(reports) >= 2
    assert all(0.2 <= worker.kernel_seconds < 2.0 for worker in workers)


def test_an_error_in_one_thread_stops_all_and_is_raised():
    workers = crew(3)

    def advance(worker):
        time.sleep(0.01)
        if worker is workers[1]:
            raise FloatingPointError("broken")
        return False

    begun = time.perf_counter()
    with pytest.raises(FloatingPointError, match="broken"):
        run_crew(workers, advance, lambda: None)
    assert time.perf_counter() - begun < 2.0


@pytest.mark.parametrize("size", [1, 2])
def test_an_interruption_stops_all_threads(size):
    """Ctrl-C is raised in the main thread, which does nothing but wait and report."""
    seen = count()
    reports = count()

    def advance(worker):
        time.sleep(0.01)
        next(seen)
        return False

    def interrupted():
        if next(reports) == 2:
            raise KeyboardInterrupt

    begun = time.perf_counter()
    with pytest.raises(KeyboardInterrupt):
        run_crew(crew(size), advance, interrupted)
    assert time.perf_counter() - begun < 2.0
    stopped = next(seen)
    time.sleep(0.05)
    assert next(seen) == stopped + 1
