"""What is no scheduler, has no workers or other sources, is told in time; and who may give work."""

import contextlib
import http.server
import socket
import threading
import time
import urllib.request
from collections.abc import Iterator

import pytest
from command_line import free_port
from dask_processes import start, wait_for_scheduler
from small_datasets import BACKEND, generated, small

from snapjump.checks import ParameterError
from snapjump.dataset import work
from snapjump.executor import dask as module
from snapjump.executor.dask import DaskExecutor
from snapjump.files.sealed import read_sealed

pytestmark = pytest.mark.processes

SPECIFICATION = small(192, 16)


def test_nobody_else_can_give_work_to_workers_that_are_started_here():
    from distributed import Client

    with DaskExecutor(None, 1) as executor:
        assert executor.at_once == 1
        address = executor._cluster.scheduler_address
        assert address.startswith("tls://127.0.0.1:")
        with pytest.raises((OSError, TypeError, ValueError)):
            Client(address.replace("tls", "tcp"), timeout=2)
        with pytest.raises((OSError, TypeError, ValueError)):
            Client(address, timeout=2)
        assert not pages(executor)


def pages(executor: DaskExecutor) -> list[str]:
    """Pages of the scheduler that anybody on this machine can read."""
    found = []
    port = executor._cluster.scheduler.http_server
    for place in ("info/main/workers.html", "json/counts.json", "metrics", "sysmon", "health"):
        with contextlib.suppress(OSError):
            urllib.request.urlopen(f"http://127.0.0.1:{port.port}/{place}", timeout=1)
            found.append(place)
    return found


@pytest.fixture
def silent_port() -> Iterator[int]:
    """A port that takes connections and says nothing."""
    with socket.create_server(("127.0.0.1", 0)) as listening:
        yield listening.getsockname()[1]


def refused_by(executor: DaskExecutor) -> tuple[str, float]:
    """The one line, and the seconds until it came."""
    begun = time.monotonic()
    with pytest.raises(ParameterError, match=r"executor\.scheduler") as caught:
        executor.__enter__()
    assert "\n" not in str(caught.value)
    return str(caught.value), time.monotonic() - begun


def test_what_never_answers_is_no_scheduler(silent_port, monkeypatch):
    monkeypatch.setattr(module, "ANSWER_S", 2.0)
    line, seconds = refused_by(DaskExecutor(f"tcp://127.0.0.1:{silent_port}", 1))
    assert "the address of a dask scheduler" in line and seconds < 5.0


def test_a_web_server_is_no_scheduler(monkeypatch):
    monkeypatch.setattr(module, "ANSWER_S", 2.0)
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), http.server.SimpleHTTPRequestHandler)
    server.daemon_threads = True
    threading.Thread(target=server.serve_forever, daemon=True).start()
    line, seconds = refused_by(DaskExecutor(f"tcp://127.0.0.1:{server.server_port}", 1))
    server.shutdown()
    assert "the address of a dask scheduler" in line and seconds < 5.0


def test_a_scheduler_without_workers_is_told_and_waited_for_if_asked(tmp_path, capsys):
    port = free_port()
    address = f"tcp://127.0.0.1:{port}"
    processes = [start("scheduler", "--host", "127.0.0.1", "--port", str(port))]
    try:
        wait_for_scheduler(address)
        line, seconds = refused_by(DaskExecutor(address, 1, wait_s=1.0))
        assert "there was none for 1 s" in line and seconds < 10.0
        worker = ("--nthreads", "1", "--no-nanny", "--local-directory", str(tmp_path))
        processes.append(start("worker", address, *worker))
        with DaskExecutor(address, 1, wait_s=60.0) as executor:
            assert executor.at_once == 1
    finally:
        for process in processes:
            process.kill()
            process.wait()


def test_workers_of_other_sources_are_told_before_anything_is_compiled(cluster, monkeypatch):
    address, _ = cluster
    monkeypatch.setattr(module, "package_files", lambda: [])
    line, seconds = refused_by(DaskExecutor(address, 1))
    assert "one whose workers have this snapjump; tcp://127.0.0.1:" in line and seconds < 20.0


def test_a_worker_compares_sources_before_it_prepares(monkeypatch):
    monkeypatch.setattr(work, "prepared", None)
    job = {"specification": {"source_sha256": "another"}, "backend": BACKEND, "plugins": []}
    with pytest.raises(ParameterError, match="source_sha256"):
        work.make_shard(job, None)


def test_a_scheduler_that_dies_ends_the_work_in_time(cluster, tmp_path, monkeypatch):
    address, (*_, scheduler) = cluster
    monkeypatch.setattr(module, "ANSWER_S", 3.0)
    died: list[float] = []

    def kill(done: float, text: str) -> None:
        if done > 0.0 and not died:
            died.append(time.monotonic())
            scheduler.kill()

    with pytest.raises(OSError, match=f"the scheduler {address} has gone"):
        generated(tmp_path / "d", SPECIFICATION, DaskExecutor(address, 1), progress=kill)
    assert time.monotonic() - died[0] < 20.0
    assert read_sealed(tmp_path / "d" / "manifest.json") is not None  # of what is done
