"""Where a run is recorded, what of it is never written, and what is recorded later."""

import json
import os
import shutil
import signal
import socket
import subprocess
import sys
import threading
import time
from pathlib import Path

import pytest
from command_line import RUN, result_in
from forward_models import RBF
from records import database_in, runs_in
from small_datasets import small, smooth_dataset

pytestmark = pytest.mark.processes

SCENE = ("sim=cantilever", "figures=false")
SECRET = "s3cret"
WITH_SECRET = f"http://alice:{SECRET}@127.0.0.1:9"


def everything_below(folder: Path) -> str:
    files = [file for file in folder.rglob("*") if file.is_file()]
    return "".join(file.read_bytes().decode("latin-1") + str(file) for file in files)


@pytest.mark.parametrize("mode", [(), ("-m", "sim.load_bar=1,2")])
def test_a_password_in_the_address_is_refused_and_written_nowhere(refusal, tmp_path, mode):
    given = (*mode, "tracking=server", f"tracking.uri={WITH_SECRET}")
    line = refusal(*SCENE, *given)
    assert SECRET not in line and "MLFLOW_TRACKING_PASSWORD" in line
    assert SECRET not in everything_below(tmp_path)


def test_a_password_in_the_environment_s_address_is_refused(refusal, tmp_path, monkeypatch):
    monkeypatch.setenv("MLFLOW_TRACKING_URI", WITH_SECRET)
    line = refusal(*SCENE)
    assert line.startswith("MLFLOW_TRACKING_URI = 'http://***@127.0.0.1:9'")
    assert SECRET not in line + everything_below(tmp_path)


def test_nothing_of_tracking_or_of_the_environment_reaches_a_checkpoint(
    command, database, tmp_path, monkeypatch
):
    for name in ("PASSWORD", "USERNAME", "TOKEN"):
        monkeypatch.setenv(f"MLFLOW_TRACKING_{name}", f"{SECRET}-{name}")
    smooth_dataset(tmp_path / "data", small(200, 200))
    surrogate = [f"surrogate.{key}={value}" for key, value in RBF.items() if key == "neighbours"]
    command("task=train", "surrogate=rbf", *surrogate, f"dataset.path={tmp_path / 'data'}")
    (model,) = tmp_path.glob("outputs/20*/*/forward_model.safetensors")
    content = model.read_bytes()
    assert b'\\"training\\"' in content and b'\\"tracking\\"' not in content
    assert b"mlruns" not in content
    assert SECRET not in everything_below(tmp_path)


def test_the_environment_says_where_if_the_command_does_not(
    command, database, tmp_path, monkeypatch
):
    elsewhere = tmp_path / "else where"
    elsewhere.mkdir()
    shutil.copy(database, elsewhere / "other.db")
    monkeypatch.setenv("MLFLOW_TRACKING_URI", f"sqlite:///{elsewhere}/other.db")
    command(*SCENE)
    assert len(runs_in(f"sqlite:///{elsewhere}/other.db")[0]) == 1
    command(*SCENE, "tracking=sqlite")
    command(*SCENE, "tracking.path=mlruns.db")
    command(*SCENE, "tracking=off")
    assert len(runs_in(f"sqlite:///{elsewhere}/other.db")[0]) == 1
    assert len(runs_in(database_in(tmp_path))[0]) == 2


@pytest.mark.parametrize(
    ("uri", "told"),
    [("http://127.0.0.1:9", "a server that answers"), ("databricks", "an http address"),
     ("file:./mlruns", "an http address"), ("sqlite:////dev/null/a.db", "/dev/null is none")],
)  # fmt: skip
def test_an_environment_that_leads_nowhere_is_refused(refusal, monkeypatch, uri, told):
    monkeypatch.setenv("MLFLOW_TRACKING_URI", uri)
    for mode in ((), ("-m", "sim.load_bar=1,2")):
        line = refusal(*SCENE, *mode)
        assert line.startswith("MLFLOW_TRACKING_URI = ") and told in line


def test_a_run_is_recorded_later_by_one_command(command, database, tmp_path):
    run = (*SCENE, "tracking.path=db/mlruns.db")
    (tmp_path / "db").mkdir()
    (tmp_path / "db" / "mlruns.db").write_text("no database")
    done = command(*run, code=5)
    folder, result = result_in(tmp_path)
    assert result["status"] == "ok"
    (line,) = [line for line in done.stderr.splitlines() if line.startswith("not recorded: ")]
    again = line.partition("; ")[2].removesuffix(" does it").removeprefix("python run.py ")
    assert again == f"record={folder.relative_to(tmp_path)}"
    before = (folder / "result.json").stat().st_mtime_ns
    shutil.copy(database, tmp_path / "db" / "mlruns.db")
    for _ in range(2):
        assert "recorded: sqlite" in command(again).stdout
    (found,), client = runs_in(f"sqlite:///{tmp_path}/db/mlruns.db")
    assert found.data.metrics["tip_angle_rad"] == result["tip_angle_rad"]
    assert len(client.list_artifacts(found.info.run_id)) == 4
    assert (folder / "result.json").stat().st_mtime_ns == before
    # And elsewhere, where the command says so.
    command(again, "tracking=sqlite")
    assert len(runs_in(database_in(tmp_path))[0]) == 1


def test_what_cannot_be_recorded(refusal, command, tmp_path):
    assert "the folder of a run that has ended" in refusal("record=nowhere")
    assert "command line = 'sim=jump'" in refusal("record=nowhere", "sim=jump")
    command(*SCENE, "tracking=off")
    folder, _ = result_in(tmp_path)
    assert "was not to be recorded" in command(f"record={folder}").stdout


def test_ctrl_c_ends_the_recording_and_the_result_is_there(tmp_path):
    """A server that takes connections and never answers."""
    listening = socket.create_server(("127.0.0.1", 0))
    kept = []
    threading.Thread(target=lambda: kept.append(listening.accept()), daemon=True).start()
    uri = f"http://127.0.0.1:{listening.getsockname()[1]}"
    command = [sys.executable, str(RUN), *SCENE, "tracking=server", f"tracking.uri={uri}"]
    process = subprocess.Popen(
        command, cwd=tmp_path, stderr=subprocess.PIPE, stdout=subprocess.PIPE, text=True,
        env=dict(os.environ),
    )  # fmt: skip
    while not list(tmp_path.glob("outputs/20*/*/result.json")):
        assert process.poll() is None
        time.sleep(0.05)
    time.sleep(4.0)  # it is importing what it records with, or is waiting
    begun = time.monotonic()
    process.send_signal(signal.SIGINT)
    out, errors = process.communicate(timeout=60)
    listening.close()
    assert time.monotonic() - begun < 5.0 and process.returncode == 130
    assert "not recorded: interrupted; python run.py record=outputs/" in errors
    assert "Traceback" not in errors and "cantilever" in out
    assert result_in(tmp_path)[1]["status"] == "ok"
    assert json.loads((result_in(tmp_path)[0] / "provenance.json").read_text())["files"]
