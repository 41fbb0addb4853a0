"""What stops a run: Ctrl-C at any time, SIGTERM and SIGHUP leave a marked run, no traceback."""

import signal
import subprocess
import sys
import time

import pytest
from command_line import RUN, begun, result_in

pytestmark = pytest.mark.processes

LONG = ("accuracy=reference", "tracking=off", "figures=false")


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGHUP])
def test_a_signal_leaves_a_marked_run(tmp_path, number):
    process = begun(tmp_path, *LONG, until="outputs/*/*/config.yaml")
    process.send_signal(number)
    _, errors = process.communicate(timeout=300)
    assert process.returncode == 130 and "Traceback" not in errors
    folder, result = result_in(tmp_path)
    told = "interrupted by the user" if number == signal.SIGINT else f"stopped by {number.name}"
    assert (result["status"], result["message"]) == ("interrupted", told)
    assert not [path for path in folder.iterdir() if path.name.startswith(".")]


def test_what_nohup_ignores_is_ignored(tmp_path):
    command = f"trap '' HUP; exec {sys.executable} {RUN} sim=cantilever tracking=off figures=false"
    process = subprocess.Popen(["bash", "-c", command], cwd=tmp_path)
    while not list(tmp_path.glob("outputs/*/*")):
        time.sleep(0.01)
    process.send_signal(signal.SIGHUP)
    assert process.wait(300) == 0 and result_in(tmp_path)[1]["status"] == "ok"


@pytest.mark.parametrize("task", ["simulate", "inverse", "dataset", "train", "export"])
def test_ctrl_c_while_a_task_prepares(tmp_path, task):
    given = {"inverse": ["target=[3,12]"], "train": [f"dataset.path={tmp_path}"]}
    process = begun(
        tmp_path, f"task={task}", "tracking=off", *given.get(task, []), until="outputs/*/*"
    )
    process.send_signal(signal.SIGINT)
    _, errors = process.communicate(timeout=300)
    assert process.returncode == 130 and "Traceback" not in errors, errors
    assert "interrupted" in errors


@pytest.mark.parametrize("seconds", [0.2, 0.4, 0.7, 1.0])
def test_ctrl_c_while_starting(tmp_path, seconds):
    process = subprocess.Popen(
        [sys.executable, str(RUN), *LONG], cwd=tmp_path, stderr=subprocess.PIPE, text=True
    )
    time.sleep(seconds)
    process.send_signal(signal.SIGINT)
    _, errors = process.communicate(timeout=300)
    assert process.returncode == 130 and "Traceback" not in errors, errors
