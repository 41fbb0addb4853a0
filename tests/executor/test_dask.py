"""The dask executor: workers on loopback, of which one is killed in the middle of its work."""

import contextlib
import os
import signal
import time

import pytest
from command_line import begun, free_port
from dask_processes import PATIENCE_S
from small_datasets import BACKEND, OVERRIDES, generated, small

from snapjump.checks import ParameterError
from snapjump.dataset.read import load_dataset
from snapjump.executor.dask import Dask, DaskExecutor
from snapjump.files.cores import own_cores

pytestmark = pytest.mark.processes

SPECIFICATION = small(192, 16)


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
    assert load_dataset(path).sha256 == load_dataset(tmp_path / "local").sha256
    assert not list((path / "shards").glob(".*.json.*"))


def test_workers_started_here_by_the_command_line(process, tmp_path):
    plan = ("plan=latin_hypercube", "plan.count=24", "dataset.shard_size=8")
    done = process(
        *OVERRIDES, *plan, "executor=dask", "dataset.path=d", "tracking=off", "figures=false"
    )
    assert "24 now" in done.stdout
    generated(tmp_path / "local", small())
    here, local = (load_dataset(tmp_path / n).table(["index", "x_bar"]) for n in ("d", "local"))
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
    process = begun(tmp_path, *run, until="d/shards/_shard-00002.json", start_new_session=True)
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
    cores = len(own_cores())
    assert DaskExecutor(None, 1).threads == cores
    assert DaskExecutor(None, 10 * cores).threads == 1
