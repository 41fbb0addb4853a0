"""Processes that need a kernel at the same time: one compiles it, and says so if it takes long."""

import os
import subprocess
import sys

import pytest

from snapjump.engine import march
from snapjump.engine.differentiate_start import differentiate_starts
from snapjump.engine.equilibrate import equilibrate
from snapjump.number import announcement, once
from snapjump.number.once import one_process_compiles
from snapjump.statics.resting_gap import resting_gap

pytestmark = pytest.mark.processes

COMPILE = """
import sys
from snapjump.contact.logbarrier import LogBarrier
from snapjump.statics.resting_gap import resting_gap
from snapjump.number.once import load
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


def test_what_takes_long_is_announced_with_its_place(capsys):
    announcement.announce("find_starts")
    told = capsys.readouterr().err
    assert told.startswith("compiling kernels") and "2 of 3, starts, about" in told
    announcement.announce("find_starts", waiting=True)
    assert "by another process" in capsys.readouterr().err
    announcement.announce("resting_gap")
    assert capsys.readouterr().err == ""


def test_the_announced_programs_are_there():
    programs = (equilibrate, march.find_starts, march.march, differentiate_starts)
    told = {*announcement.STAGES, *announcement.OTHERS}
    assert told - {"cuda"} == {program.__name__ for program in programs}


def test_whether_a_call_would_compile(tmp_path):
    environment = {**os.environ, "NUMBA_CACHE_DIR": str(tmp_path)}
    code = """
from snapjump.contact.logbarrier import LogBarrier
from snapjump.number.once import would_compile
from snapjump.statics.resting_gap import resting_gap
arguments = LogBarrier.Law(1.0, 1.0, 1.0), 1.0, 1.0
print(would_compile(resting_gap, arguments))
resting_gap(*arguments)
print(would_compile(resting_gap, arguments))
"""
    command = [sys.executable, "-c", code]
    runs = [subprocess.run(command, env=environment, capture_output=True, text=True) for _ in "12"]
    assert [run.stdout.split() for run in runs] == [["True", "False"], ["False", "False"]]
