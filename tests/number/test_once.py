"""Processes that need a kernel at the same time: one compiles it, and says so if it takes long."""

import os
import subprocess
import sys
import time

from snapjump.number import announcement

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


class Kernel:
    """Takes its time; ``compiles`` says whether a signature appears meanwhile."""

    def __init__(self, seconds):
        self.signatures = []
        self.seconds = seconds
        self.calls = []

    def __call__(self, *args):
        self.calls.append(args)
        time.sleep(self.seconds)


def test_only_a_long_compilation_is_announced(monkeypatch, capsys):
    monkeypatch.setattr(announcement, "PATIENCE_SECONDS", 0.05)
    quick, slow, running = Kernel(0.0), Kernel(0.3), Kernel(0.3)
    announcement.load(quick, 1)
    assert capsys.readouterr().err == ""
    announcement.load(slow, 1, 2)
    assert "compiling kernels, once" in capsys.readouterr().err
    assert slow.calls == [(1, 2)]

    def starts_at_once(*args):
        running.signatures.append(args)
        time.sleep(0.3)

    starts_at_once.signatures = running.signatures
    announcement.load(starts_at_once, 1)
    assert capsys.readouterr().err == ""
