"""Real processes of dask: a scheduler and its workers, on loopback."""

import contextlib
import os
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

from command_line import ROOT, free_port

from snapjump.checks import ParameterError
from snapjump.executor.dask import DaskExecutor

PATIENCE_S = 60.0


def start(tool: str, *arguments: str) -> "subprocess.Popen[bytes]":
    """A dask process that finds this library as this one does."""
    return subprocess.Popen(
        [sys.executable, "-m", f"distributed.cli.dask_{tool}", "--no-dashboard", *arguments],
        cwd=ROOT,
        env={**os.environ, "PYTHONPATH": str(ROOT)},
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )


@contextlib.contextmanager
def a_cluster(tmp_path: Path) -> Iterator[tuple[str, list["subprocess.Popen[bytes]"]]]:
    """Address of a real scheduler, its two worker processes, and its own."""
    port = free_port()
    address = f"tcp://127.0.0.1:{port}"
    scheduler = start("scheduler", "--host", "127.0.0.1", "--port", str(port))
    worker = ("--nthreads", "1", "--no-nanny", "--local-directory", str(tmp_path))
    workers = [start("worker", address, *worker) for _ in range(2)]
    try:
        wait_for_workers(address)
        yield address, [*workers, scheduler]
    finally:
        for process in (*workers, scheduler):
            process.kill()
            process.wait()


def wait_for_scheduler(address: str) -> None:
    end = time.monotonic() + PATIENCE_S
    while True:
        try:
            return DaskExecutor(address, 1).check()
        except ParameterError:
            assert time.monotonic() < end
            time.sleep(0.2)


def wait_for_workers(address: str) -> None:
    from distributed import Client

    wait_for_scheduler(address)
    with Client(address) as client:
        client.wait_for_workers(2, timeout=PATIENCE_S)
