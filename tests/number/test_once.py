"""Processes that need the same kernel at the same time: one compiles it, the others find it."""

import os
import subprocess
import sys

COMPILE = """
import sys
from snapjump.contact.logbarrier import LogBarrier
from snapjump.statics.resting_gap import resting_gap
from snapjump.number.announcement import load
print("ready", flush=True)
sys.stdin.read()
load(resting_gap, LogBarrier.Law(1.0, 1.0, 1.0), 1.0, 1.0)
print(sum(resting_gap.stats.cache_hits.values()), sum(resting_gap.stats.cache_misses.values()))
"""


def test_one_of_three_processes_compiles(tmp_path):
    processes = [
        subprocess.Popen(
            [sys.executable, "-c", COMPILE],
            env={**os.environ, "NUMBA_CACHE_DIR": str(tmp_path)},
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
        )
        for _ in range(3)
    ]
    # All have been imported and none has begun.
    assert [process.stdout.readline() for process in processes] == 3 * ["ready\n"]
    counts = []
    for process in processes:
        process.stdin.close()
    for process in processes:
        counts.append(process.stdout.read().split())
        assert process.wait() == 0
    assert sorted(counts) == [["0", "1"], ["1", "0"], ["1", "0"]]


def test_the_lock_is_free_after_a_failure(tmp_path, monkeypatch):
    import numba
    import pytest

    from snapjump.number.once import one_process_compiles
    from snapjump.statics.resting_gap import resting_gap

    monkeypatch.setattr(numba.config, "CACHE_DIR", str(tmp_path))
    for _ in range(2):
        with pytest.raises(ZeroDivisionError), one_process_compiles(resting_gap, (1.0, 2.0), 1.0):
            raise ZeroDivisionError
    assert len(list((tmp_path / "compiling").iterdir())) == 1
