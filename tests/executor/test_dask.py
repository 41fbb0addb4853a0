"""The dask executor: workers on loopback, of which one is killed in the middle of its work."""

import contextlib
import http.server
import os
import signal
import socket
import subprocess
import sys
import threading
import time
import urllib.request
from collections.abc import Iterator

import pytest
from command_line import ROOT, begun, free_port
from small_datasets import BACKEND, OVERRIDES, generated, small

from snapjump.checks import ParameterError
from snapjump.dataset import work
from snapjump.dataset.read import open_dataset
from snapjump.executor import dask as module
from snapjump.executor.dask import Dask, DaskExecutor
from snapjump.files.sealed import read_sealed

PATIENCE_S = 60.0
SPECIFICATION = small(192, 16)


def start(tool: str, *arguments: str) -> "subprocess.Popen[bytes]":
    """A dask process that finds this library as this one does."""
    return subprocess.Popen(
        [sys.executable, "-m", f"distributed.cli.dask_{tool}", "--no-dashboard", *arguments],
        cwd=ROOT,
        env={**os.environ, "PYTHONPATH": str(ROOT)},
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )


@pytest.fixture
def cluster(tmp_path) -> Iterator[tuple[str, list["subprocess.Popen[bytes]"]]]:
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


def test_a_killed_worker_costs_nothing_but_time(cluster, tmp_path):
    address, workers = cluster
    killed: list[float] = []

    def kill(done: float, text: str) -> None:
        if done > 0.0 and not killed:
            workers[0].send_signal(signal.SIGKILL)
            killed.append(done)

    path = tmp_path / "dask"
    generation = generated(path, SPECIFICATION, DaskExecutor(address, 1), progress=kill)
    assert killed and killed[0] < 0.5 and workers[0].wait(10) == -signal.SIGKILL
    assert generation.manifest["complete"] and generation.made == 192
    generated(tmp_path / "local", SPECIFICATION)
    local, dask = (tmp_path / name / "manifest.json" for name in ("local", "dask"))
    assert local.read_bytes() == dask.read_bytes()
    assert open_dataset(path).sha256 == open_dataset(tmp_path / "local").sha256
    assert not list((path / "shards").glob(".*.json.*"))


def test_workers_started_here_by_the_command_line(process, tmp_path):
    plan = ("plan=latin_hypercube", "plan.count=24", "dataset.shard_size=8")
    done = process(
        *OVERRIDES, *plan, "executor=dask", "dataset.path=d", "tracking=off", "figures=false"
    )
    assert "24 now" in done.stdout
    generated(tmp_path / "local", small())
    here, local = (open_dataset(tmp_path / n).table(["index", "x_bar"]) for n in ("d", "local"))
    assert here.equals(local)


def still_running(group: int) -> list[str]:
    """Processes of a group; not those that are only waiting to be forgotten."""
    import psutil  # which dask needs

    found = []
    for process in psutil.process_iter():
        with contextlib.suppress(ProcessLookupError, psutil.NoSuchProcess):
            alive = process.status() != psutil.STATUS_ZOMBIE
            if os.getpgid(process.pid) == group and alive:
                found.append(process.name())
    return found


def test_ctrl_c_of_a_terminal_stops_all_processes_without_a_word_of_theirs(tmp_path):
    plan = ("plan=sobol", "plan.count=20000", "dataset.shard_size=16", "executor=dask")
    run = (*OVERRIDES, *plan, "dataset.path=d", "tracking=off")
    process = begun(tmp_path, *run, until="d/shards/shard-00002.json", start_new_session=True)
    os.killpg(process.pid, signal.SIGINT)
    out, errors = process.communicate(timeout=PATIENCE_S)
    assert process.returncode == 130
    assert "Traceback" not in errors and "the same command continues what is in d" in out
    # The helper of Python's multiprocessing ends once it hears that all others have.
    end = time.monotonic() + PATIENCE_S
    while still_running(process.pid):
        assert time.monotonic() < end, still_running(process.pid)
        time.sleep(0.1)


def test_what_a_worker_raises_comes_here(cluster):
    address, _ = cluster
    with DaskExecutor(address, 1) as executor:
        assert executor.cores >= 1 and executor.threads is None
        with pytest.raises(KeyError, match="specification"):
            from snapjump.dataset.work import make_shard

            list(executor.answers(make_shard, [{"backend": BACKEND}], lambda share, text: None))


def test_no_scheduler_is_bad_input():
    with pytest.raises(ParameterError, match=r"executor\.scheduler"):
        Dask(f"tcp://127.0.0.1:{free_port()}").executor().check()


def test_without_the_package_it_says_what_to_install(monkeypatch):
    monkeypatch.setattr("snapjump.executor.dask.find_spec", lambda name: None)
    with pytest.raises(ParameterError, match=r"snapjump\[cluster\]"):
        Dask().executor().check()


def test_workers_here_share_the_cores():
    cores = len(os.sched_getaffinity(0))
    assert DaskExecutor(None, 1).threads == cores
    assert DaskExecutor(None, 10 * cores).threads == 1


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
