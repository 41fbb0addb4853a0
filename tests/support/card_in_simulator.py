"""Small jumps on numba's simulator of a card: a program of its own, which prints what it found.

The simulator is chosen once a process (``NUMBA_ENABLE_CUDASIM=1``) and runs kernels as the Python
that they are written in. What it is compared with is the same Python, marched without a card.
"""

import json
import sys
from typing import Any

import numpy as np
from plain_march import without_compiling
from pytest import MonkeyPatch
from robots import DESIGNS, QUIET, small_march

from snapjump.engine.cuda.plan import Plan
from snapjump.engine.outcome import STATUS

ROBOTS = (DESIGNS[1], DESIGNS[7])
NO_START = 7.0


def on_card(designs: Any, threads: int, robots_a_chunk: int, duration: float = 20.0) -> Any:
    """The robots in so many threads, so many of them in the queue at a time."""
    march: Any = small_march(designs, 1, duration=duration, backend="cuda", **QUIET)
    march.plan = march.card.plan = Plan(1, threads, robots_a_chunk)
    return march


def difference(march: Any, other: Any) -> float:
    """Largest one of starts and outcomes."""
    names = ("state", "velocity", "acceleration", "status", "outcome")
    pairs = [(getattr(march.queue, name), getattr(other.queue, name)) for name in names]
    return float(max(np.max(np.abs(a - b)) for a, b in pairs))


def main() -> None:
    """March jumps from where the file says, and short ones in chunks, and print the figures."""
    without_compiling(MonkeyPatch())  # for good
    told: list[float] = []
    refilled = on_card(ROBOTS, threads=1, robots_a_chunk=2)
    refilled.find_starts()
    starts = refilled.queue.state.tolist()
    for name, values in np.load(sys.argv[1]).items():
        getattr(refilled.queue, name)[:] = values
    refilled.run(lambda share, word: told.append(share))

    short = small_march(DESIGNS[:3], 1, duration=0.02, **QUIET)
    chunked = on_card(DESIGNS[:3], threads=2, robots_a_chunk=2, duration=0.02)
    for march in (short, chunked):
        march.find_starts()
        march.queue.status[1] = NO_START
        march.run()
    found = {
        "starts": starts, "outcome": refilled.queue.outcome.tolist(), "progress": told,
        "passes": int(refilled.passes), "bytes_sent": refilled.card.bytes_sent,
        "differs_in_chunks": difference(chunked, short),
        "status_in_chunks": chunked.queue.outcome[:, STATUS].tolist(),
    }  # fmt: skip
    print(json.dumps(found))


if __name__ == "__main__":
    main()
