"""Locks between processes."""

import os
import subprocess
import sys
import threading
import time

import pytest
from command_line import ROOT

from snapjump.files.lock import FileLock

HOLD = """
import sys
from pathlib import Path
from snapjump.files.lock import FileLock
lock = FileLock(Path(sys.argv[1]))
lock.acquire()
print("held", flush=True)
sys.stdin.read()
"""


def test_a_lock_excludes_other_processes_and_ends_with_its_own(tmp_path):
    path = tmp_path / "x.lock"
    holder = subprocess.Popen(
        [sys.executable, "-c", HOLD, str(path)], stdin=subprocess.PIPE, stdout=subprocess.PIPE
    )
    assert holder.stdout is not None
    assert holder.stdout.readline() == b"held\n"
    assert not FileLock(path).acquire(wait=False)
    holder.kill()
    holder.communicate()
    lock = FileLock(path)
    assert lock.acquire(wait=False)
    lock.release()


def test_a_lock_that_was_removed_is_another(tmp_path):
    path = tmp_path / "x.lock"
    first, waiting = FileLock(path), FileLock(path)
    first.acquire()
    waits = threading.Thread(target=waiting.acquire)
    waits.start()
    time.sleep(0.1)  # until it waits for the file that is there now
    first.remove()
    waits.join()
    assert path.exists() and not FileLock(path).acquire(wait=False)
    waiting.remove()
    assert not path.exists()


def test_a_shared_lock_is_shared_with_others_that_share_it(tmp_path):
    path = tmp_path / "lock"
    first, second = FileLock(path, shared=True), FileLock(path, shared=True)
    assert first.acquire(wait=False) and second.acquire(wait=False)
    alone = FileLock(path)
    assert not alone.acquire(wait=False)
    first.release()
    assert not alone.acquire(wait=False)
    second.release()
    assert alone.acquire(wait=False)
    assert not first.acquire(wait=False)
    alone.release()


WITHOUT = """
import os, signal, sys
sys.modules["fcntl"] = None  # as on Windows
del os.sched_getaffinity, signal.SIGHUP
from pathlib import Path
from snapjump.files.lock import FileLock
with FileLock(Path("x.lock")) as lock:
    assert FileLock(Path("x.lock")).acquire(wait=False)
from snapjump.executor.local import Local
print(Local().executor().cores, flush=True)
from snapjump.__main__ import main
sys.argv[1:] = ["accuracy=draft", "figures=false", "tracking=off", "hydra.run.dir=out"]
sys.exit(main())
"""


@pytest.mark.processes
def test_a_system_without_posix_works_without(tmp_path):
    command = [sys.executable, "-c", WITHOUT]
    paths = {**os.environ, "PYTHONPATH": str(ROOT)}
    run = subprocess.run(command, capture_output=True, text=True, cwd=tmp_path, env=paths)
    assert run.returncode == 0, run.stderr
    assert run.stdout.startswith(f"{os.cpu_count()}\njump ") and "apex" in run.stdout
