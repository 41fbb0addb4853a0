"""What becomes of a job, whatever its task does. The tasks here are stand-ins for that."""

import contextlib
import errno
import json
import math
import signal
from collections.abc import Mapping
from typing import Any

import numpy as np
import pytest

from snapjump.checks import ParameterError
from snapjump.files.result_folder import ResultFolder
from snapjump.run.tasks import registry
from snapjump.run.tasks.base import Outcome, Task
from snapjump.run.tasks.execute import SECTIONS, execute
from snapjump.show.terminal.progress import ProgressBar

CONFIG: dict[str, Any] = {
    **{key: {} for key in SECTIONS},
    "task": {"name": "stand_in"},
    "figures": True,
    "seed": 0,
    "effort": "quick",
    "publish": None,
}


class StandIn(Task):
    """A task that does what the test says."""

    def prepare(self, config: Mapping[str, Any]) -> None:
        if "epsilon" in config["design"]:
            raise ParameterError("design.epsilon", config["design"]["epsilon"], "something else")

    def run(self, folder: ResultFolder, progress: Any) -> Outcome:
        raise NotImplementedError

    def report(self, outcome: Outcome) -> list[tuple[str, str]]:
        return [("stand-in", "")]


@pytest.fixture(autouse=True)
def stand_in(monkeypatch) -> None:
    """The task is registered, in this module."""
    monkeypatch.setitem(registry.TASKS, "stand_in", f"{__name__}:StandIn")
    monkeypatch.setattr(registry, "import_module", lambda name: __import__("sys").modules[name])


@pytest.fixture
def becomes(monkeypatch, tmp_path) -> Any:
    """Outcome and result of a task that does what is given with its folder and progress."""

    def run(action: Any) -> tuple[Outcome, dict[str, Any]]:
        monkeypatch.setattr(StandIn, "run", lambda self, *given: action(*given))
        outcome, _ = execute(CONFIG, ResultFolder(tmp_path), [], ProgressBar())
        return outcome, json.loads((tmp_path / "result.json").read_text())

    return run


def raises(error: BaseException) -> Any:
    def action(*given: Any) -> Outcome:
        raise error

    return action


def test_a_good_end(becomes, tmp_path):
    _, result = becomes(lambda *given: Outcome("ok", "", {"x_bar": np.float64(5)}))
    assert result.pop("wall_seconds") >= 0
    assert result == {"status": "ok", "x_bar": 5.0}
    names = [file.name for file in ResultFolder(tmp_path).files()]
    assert names == ["config.yaml", "provenance.json", "result.json"]
    assert ResultFolder(tmp_path).config() == CONFIG


def test_nan_is_null_and_no_good_end_but_a_failure_keeps_its_own_name(becomes):
    outcome, result = becomes(lambda *given: Outcome("ok", "", {"x_bar": math.nan, "y_bar": 1.0}))
    assert outcome.status == result["status"] == "not_finite"
    assert result["x_bar"] is None and result["y_bar"] == 1.0
    assert "x_bar" in result["message"]
    failed = Outcome("not_converged", "at t = 1 ms", {"x_bar": math.nan})
    _, result = becomes(lambda *given: failed)
    assert (result["status"], result["message"]) == ("not_converged", "at t = 1 ms")
    assert result["x_bar"] is None


def test_ctrl_c_leaves_a_marked_run(becomes):
    assert becomes(raises(KeyboardInterrupt()))[1]["status"] == "interrupted"


def test_ctrl_c_that_a_library_swallows_stops_at_the_next_progress(becomes):
    told: list[str] = []

    def swallow(folder: ResultFolder, progress: Any) -> Outcome:
        with contextlib.suppress(KeyboardInterrupt):
            signal.raise_signal(signal.SIGINT)
        told.append("went on")
        progress(0.5, "half")
        told.append("and on")
        return Outcome("ok")

    outcome, _ = becomes(swallow)
    assert outcome.status == "interrupted" and told == ["went on"]


def test_a_defect_leaves_its_traceback(becomes, tmp_path):
    _, result = becomes(raises(ZeroDivisionError("by nought")))
    assert result["status"] == "error"
    assert "ZeroDivisionError: by nought" in result["message"]
    assert "in action" in (tmp_path / "traceback.txt").read_text()


@pytest.mark.parametrize("error", [KeyboardInterrupt(), ModuleNotFoundError("No module 'torch'")])
def test_what_was_not_prepared_does_not_report(monkeypatch, tmp_path, error):
    monkeypatch.setattr(StandIn, "prepare", raises(error))
    outcome, task = execute(CONFIG, ResultFolder(tmp_path), [], ProgressBar())
    assert task is None and outcome.status in ("interrupted", "error")
    assert json.loads((tmp_path / "result.json").read_text())["status"] == outcome.status


def test_a_full_disk_is_one_line_and_the_numbers_are_told(monkeypatch, tmp_path):
    def full(*given: Any, **others: Any) -> Any:
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(StandIn, "run", lambda self, *given: Outcome("ok", "", {"x_bar": 1.0}))
    monkeypatch.setattr(ResultFolder, "write_result", full)
    outcome, task = execute(CONFIG, ResultFolder(tmp_path), [], ProgressBar())
    assert outcome.message == f"No space left on device: the result is not in {tmp_path}"
    assert task is not None and outcome.summary["x_bar"] == 1.0


def test_a_defect_on_a_full_disk_is_one_line(becomes, monkeypatch):
    def full(*given: Any) -> Any:
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr("snapjump.run.tasks.execute.write_text", full)
    outcome, _ = becomes(raises(OSError(errno.ENOSPC, "No space left on device", "a.npz")))
    assert outcome.message == "OSError: [Errno 28] No space left on device: 'a.npz'"


@pytest.mark.parametrize(
    ("change", "key"),
    [
        ({"design": {"epsilon": 9}}, "design.epsilon"),
        ({"seed": -1}, "seed"),
        ({"seed": 1.5}, "seed"),
        ({"figures": "maybe"}, "figures"),
        ({"effort": "heroic"}, "effort"),
        ({"publish": 3}, "publish"),
        ({"publish": "docs"}, "publish"),
        ({"task": {"name": "dream"}}, "task.name"),
        ({"design": 3}, "design"),
        ({"nonsense": 1}, "nonsense"),
    ],
)
def test_bad_input_is_one_line_and_leaves_nothing(tmp_path, change, key):
    outcome, _ = execute({**CONFIG, **change}, ResultFolder(tmp_path), [], ProgressBar())
    assert outcome.status == "bad_input"
    assert outcome.message.startswith(f"{key} = ") and "\n" not in outcome.message
    assert not list(tmp_path.iterdir())
