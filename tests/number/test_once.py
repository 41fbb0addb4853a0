"""Processes that need a kernel at the same time: one compiles it, and says so if it takes long."""

import os
import subprocess
import sys
import time

import pytest

from snapjump.number import announcement, once
from snapjump.number.once import one_process_compiles
from snapjump.statics.resting_gap import resting_gap

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
    pipes = {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE, "text": True}
    environment = {**os.environ, "NUMBA_CACHE_DIR": str(tmp_path)}
    command = [sys.executable, "-c", COMPILE]
    processes = [subprocess.Popen(command, env=environment, **pipes) for _ in range(3)]
    # All have been imported and none has begun.
    assert [process.stdout.readline() for process in processes] == 3 * ["ready\n"]
    for process in processes:
        process.stdin.close()
    counts = [process.stdout.read().split() for process in processes]
    assert [process.wait() for process in processes] == [0, 0, 0]
    assert sorted(counts) == [["0", "1"], ["1", "0"], ["1", "0"]]


def test_the_lock_is_free_after_a_failure(tmp_path, monkeypatch):
    monkeypatch.setattr(once, "folder_in_use", lambda: tmp_path)
    for _ in range(2):
        with pytest.raises(ZeroDivisionError), one_process_compiles(resting_gap, (1.0, 2.0), 1.0):
            raise ZeroDivisionError
    assert len(list((tmp_path / "compiling").iterdir())) == 1


class Kernel:
    """Takes its time, before or after it has been compiled."""

    def __init__(self, seconds, compiled_at_once=False):
        self.seconds, self.compiled_at_once = seconds, compiled_at_once
        self.signatures, self.calls = [], []

    def __call__(self, *args):
        self.calls.append(args)
        if self.compiled_at_once:
            self.signatures.append(args)
        time.sleep(self.seconds)


def test_only_a_long_compilation_is_announced(monkeypatch, capsys):
    monkeypatch.setattr(announcement, "PATIENCE_SECONDS", 0.05)
    slow = Kernel(0.3)
    announcement.load(slow, 1, 2)
    assert "compiling kernels, once" in capsys.readouterr().err
    assert slow.calls == [(1, 2)]
    for silent in (Kernel(0.0), Kernel(0.3, compiled_at_once=True)):
        announcement.load(silent, 1)
        assert capsys.readouterr().err == ""
