"""Records of sweeps and jumps in a database file, fresh or not, and on a real tracking server."""

import json
import os
import shutil
import subprocess
import sys
import time
import urllib.request
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from command_line import free_port
from records import database_in, runs_in

pytestmark = pytest.mark.processes

LAGS = ("0.02", "0.05", "0.1", "0.15")
JUMP = ("sim=jump", "accuracy=draft", "figures=false")
SWEEP = ("-m", *JUMP, "design.delta_alpha=" + ",".join(LAGS))
TWO_AT_A_TIME = ("hydra/launcher=joblib", "hydra.launcher.n_jobs=2")
START_TIMEOUT_S = 120.0


def families_in(uri: str) -> tuple[list[Any], list[Any], Any]:
    """Parents, children and the client of the experiment in a store."""
    runs, client = runs_in(uri)
    parents = [run for run in runs if "mlflow.parentRunId" not in run.data.tags]
    return parents, [run for run in runs if run not in parents], client


def check_sweep(uri: str, folder: Path) -> None:
    """A store holds one parent and a complete child for each of the four jumps."""
    (parent,), children, client = families_in(uri)
    assert parent.info.status == "FINISHED"
    assert parent.data.metrics["cells"] == parent.data.metrics["cells_ok"] == len(LAGS)
    artifacts = {file.path for file in client.list_artifacts(parent.info.run_id)}
    assert {"summary.csv", "summary.md", "summary.png"} <= artifacts
    assert {run.data.tags["mlflow.parentRunId"] for run in children} == {parent.info.run_id}
    assert sorted(run.data.params["design.delta_alpha"] for run in children) == sorted(LAGS)
    for run in children:
        result = json.loads((Path(run.data.tags["folder"]) / "result.json").read_text())
        assert run.info.status == "FINISHED" and run.data.tags["status"] == "ok"
        assert run.data.metrics["x_bar"] == result["x_bar"]
        assert run.data.metrics["y_bar"] == result["y_bar"]
        assert run.data.params["accuracy.name"] == "draft"
        artifacts = {file.path for file in client.list_artifacts(run.info.run_id)}
        assert {"config.yaml", "provenance.json", "result.json", "trajectory.npz"} <= artifacts
    assert len(results(folder)) == len(LAGS)


def results(folder: Path) -> dict[Path, int]:
    """Result files of all cells, with the time each was written (ns)."""
    return {path: path.stat().st_mtime_ns for path in folder.glob("outputs/sweeps/*/*/result.json")}


def test_a_sweep_on_a_fresh_file_and_its_restart(command, process, tmp_path):
    process(*SWEEP, *TWO_AT_A_TIME)
    check_sweep(database_in(tmp_path), tmp_path)
    before = results(tmp_path)
    assert command(*SWEEP).stdout.count("(kept)") == len(LAGS)
    assert results(tmp_path) == before
    # The same parent, and no second record of any cell.
    check_sweep(database_in(tmp_path), tmp_path)


def test_a_restart_does_what_is_missing_and_each_cell_keeps_its_record(command, database, tmp_path):
    sweep = ("-m", *JUMP, "design.delta_alpha=0.02,0.05,0.1")
    command(*sweep)
    before = results(tmp_path)
    lost, changed, kept = sorted(before)
    lost.unlink()
    changed.write_text(json.dumps({"status": "interrupted"}))
    assert command(*sweep).stdout.count("(kept)") == 1
    after = results(tmp_path)
    assert {path for path in before if after[path] != before[path]} == {lost, changed}
    parents, children, _ = families_in(database_in(tmp_path))
    assert len(parents) == 1
    assert [run.data.tags["status"] for run in children] == ["ok"] * 3


def test_a_failed_cell_does_not_stop_the_others(command, database, tmp_path):
    # A barrier too thin for any step, the usual one, and one that is not allowed.
    distances = ("1e-09", "0.0005", "-1")
    done = command("-m", *JUMP, f"contact.distance_m={','.join(distances)}", code=3)
    rows = [line.split() for line in done.stdout.splitlines()]
    statuses = {row[0]: row[1] for row in rows if row and row[0] in distances}
    assert statuses == {"1e-09": "step_underflow", "0.0005": "ok", "-1": "bad_input"}
    (parent,), children, _ = families_in(database_in(tmp_path))
    assert parent.info.status == "FAILED"
    recorded = {run.data.tags["status"]: run.info.status for run in children}
    assert recorded == {"ok": "FINISHED", "bad_input": "FAILED", "step_underflow": "FAILED"}


def test_bad_input_in_a_cell_and_of_a_sweep(command, refusal):
    done = command("-m", *JUMP, "tracking=off", "design.epsilon=0.2,0.9", code=2)
    assert "design.epsilon = 0.9 is not allowed" in done.stdout
    line = refusal("-m", "tracking=off", "contact=logbarrier,foo")
    assert line.startswith("contact = 'foo' is not allowed")


def test_jumps_on_an_existing_database_are_runs_of_their_own(command, database, tmp_path):
    for tracking in ("sqlite", "off", "sqlite", "off", "sqlite"):
        command(*JUMP, f"tracking={tracking}")
    runs, children, _ = families_in(database_in(tmp_path))
    assert len(runs) == 3 and not children
    assert not (tmp_path / "mlruns").exists()


@pytest.fixture
def server(tables, tmp_path) -> Iterator[str]:
    """The address of an ``mlflow server`` without records on loopback."""
    port, store = str(free_port()), tmp_path / "server"
    uri = f"http://127.0.0.1:{port}"
    store.mkdir()
    shutil.copy(tables, store / "store.db")
    command = [sys.executable, "-m", "mlflow", "server", "--host", "127.0.0.1", "--port", port]
    command += ["--workers", "1", "--backend-store-uri", f"sqlite:///{store}/store.db"]
    command += ["--artifacts-destination", str(store / "artifacts")]
    with open(store / "log", "wb") as log:
        options = {"stdout": log, "stderr": log, "cwd": store, "start_new_session": True}
        process = subprocess.Popen(command, **options)
    try:
        wait_until_it_answers(process, uri, store / "log")
        yield uri
    finally:
        # The server's workers are its children: the whole session goes.
        os.killpg(process.pid, 9)
        process.wait()


def wait_until_it_answers(process: "subprocess.Popen[bytes]", uri: str, log: Path) -> None:
    end = time.monotonic() + START_TIMEOUT_S
    while time.monotonic() < end:
        assert process.poll() is None, log.read_text()
        try:
            urllib.request.urlopen(f"{uri}/health", timeout=1)
        except OSError:
            time.sleep(0.2)
        else:
            return
    raise AssertionError(f"no answer from {uri}: {log.read_text()}")


@pytest.mark.slow
def test_a_sweep_on_a_server(process, server, tmp_path):
    done = process(*SWEEP, *TWO_AT_A_TIME, "tracking=server", f"tracking.uri={server}")
    assert "4 cells: 4 ok" in done.stdout
    check_sweep(server, tmp_path)
    assert not (tmp_path / "mlruns.db").exists() and not (tmp_path / "mlruns").exists()


@pytest.mark.parametrize("sweep", [(), SWEEP], ids=["jump", "sweep"])
def test_a_server_that_is_not_there_is_bad_input(refusal, sweep):
    uri = f"http://127.0.0.1:{free_port()}"
    line = refusal(*sweep, "tracking=server", f"tracking.uri={uri}")
    assert line.startswith(f"tracking.uri = '{uri}' is not allowed")
