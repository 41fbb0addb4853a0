"""``task=inverse`` and ``task=export``: what they print, leave and refuse."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from command_line import result_in
from forward_models import RBF, about, network
from hydra_config import hydra_config
from refusals import key_in, refused
from small_datasets import OVERRIDES, silent

from snapjump.checks import ParameterError
from snapjump.files.result_folder import ResultFolder
from snapjump.learning.checkpoint import write_checkpoint
from snapjump.learning.forward_model import forward_model
from snapjump.run.tasks.base import EXIT_UNREACHABLE, Outcome, exit_code
from snapjump.run.tasks.export import Export
from snapjump.run.tasks.inverse import InverseDesign

# The physical model that the checkpoint claims to know.
MODEL = OVERRIDES[1:]
METHOD = "inverse=gauss_newton"
KEYS = (
    "reachable", "epsilon", "delta_alpha_rad", "predicted_x_bar", "predicted_y_bar",
    "simulated_x_bar", "simulated_y_bar", "error_bar", "error_m", "solve_seconds", "simulations",
)  # fmt: skip
REACHED = [5.0, 14.0]  # by a simulated design
DESIGN = np.array([[0.1, 0.2, 0.768, 0.3]])


@pytest.fixture(scope="module")
def checkpoint(tmp_path_factory) -> Path:
    """A forward model that has learned nothing, of the small datasets' robot."""
    path = tmp_path_factory.mktemp("trained") / "model.safetensors"
    write_checkpoint(path, network(), about())
    return path


@pytest.fixture(scope="module")
def target(checkpoint) -> list[float]:
    """A target that the forward model believes it can reach."""
    found: list[float] = forward_model(checkpoint).predict(DESIGN)[0].tolist()
    return found


@pytest.fixture
def run_task(checkpoint, tmp_path) -> Callable[..., tuple[Outcome, dict[str, str]]]:
    """The task in this process: its outcome and its closing block."""

    def do(*overrides: str) -> tuple[Outcome, dict[str, str]]:
        task, config = prepared(checkpoint, *overrides)
        outcome = task.run(ResultFolder(tmp_path), silent)
        return outcome, dict(task.report(outcome))

    return do


def prepared(checkpoint: Path, *overrides: str) -> tuple[InverseDesign, Any]:
    method = () if any(text.startswith("inverse=") for text in overrides) else (METHOD,)
    given = ["task=inverse", *MODEL, *method, f"checkpoint={checkpoint}", *overrides]
    task, config = InverseDesign(), hydra_config(*given)
    task.prepare(config)
    return task, config


def test_the_command_line(command, checkpoint, tmp_path):
    done = command(
        "task=inverse", *MODEL, f"checkpoint={checkpoint}", f"target={REACHED}", "tracking=off"
    )
    folder, result = result_in(tmp_path)
    assert result["status"] == "ok" and result["reachable"] is True
    assert all(isinstance(result[key], (int, float)) for key in KEYS)
    simulated = np.array([result["simulated_x_bar"], result["simulated_y_bar"]])
    assert result["error_bar"] == pytest.approx(np.hypot(*(simulated - REACHED)))
    assert result["error_bar"] < 0.03
    assert result["error_m"] == pytest.approx(0.02 * result["error_bar"])
    assert (folder / "inverse.png").stat().st_size > 10_000
    costs = [key for key in result if key.startswith("one_percent_") and key.endswith("_bar")]
    assert costs[0] == "one_percent_thickness_m_bar" and len(costs) > 15
    assert {f"one_percent_{name}_bar" for name in ("epsilon", "delta_alpha", "mu")} < {*costs}
    assert result["one_percent_mu_m"] == pytest.approx(0.02 * result["one_percent_mu_bar"])
    assert "thickness_m" in done.stdout
    for word in (
        "target x",
        "design",
        "predicted",
        "simulated",
        " mm)",
        "1 % of",
        "error",
        "simulations",
    ):
        assert word in done.stdout


def test_out_of_reach(run_task, target, tmp_path):
    outcome, lines = run_task(f"target=[{target[0] + 500.0},{target[1]}]")
    assert outcome.status == "not_reached"  # by a method that asks the forward model alone
    assert exit_code(outcome.status) == EXIT_UNREACHABLE == 4
    assert "nearest simulated apex is x" in outcome.message and "\n" not in outcome.message
    assert outcome.summary["reachable"] is None
    assert outcome.summary["simulated_y_bar"] > 1.0
    assert "predicted" in lines and (tmp_path / "inverse.png").exists()


def test_out_of_reach_of_every_search_and_where_was_searched(run_task, target):
    outcome, _ = run_task(f"target=[{target[0] + 500.0},{target[1]}]", "inverse=physics")
    assert outcome.status == "unreachable" and outcome.summary["reachable"] is False
    assert exit_code(outcome.status) == EXIT_UNREACHABLE
    assert "with delta_alpha in [-0.19, 0.19] rad and epsilon in [0.1, 0.3]" in outcome.message
    assert outcome.summary["searched_delta_alpha_rad_least"] == -0.19
    assert "nearest simulated apex" in outcome.message and outcome.summary["simulations"] > 8


def test_a_robust_design(run_task, tmp_path):
    outcome, lines = run_task(f"target={REACHED}", "inverse=physics", "inverse.robust=true")
    found = outcome.summary
    assert found["robust_expected_miss_bar"] <= 1.02 * found["plain_expected_miss_bar"]
    assert "instead of" in lines["robust"]
    assert (tmp_path / "inverse.png").exists()


def test_outside_of_what_was_trained_a_simulator_goes_on(run_task, capsys):
    outcome, lines = run_task(
        "target=[2.0,5.0]",
        "environment.mu=0.9",
        "inverse=finite_difference",
        "inverse.simulations=16",
        "figures=false",
    )
    assert outcome.status in ("ok", "unreachable")
    assert outcome.summary["simulations"] in (16, 32, 48)  # for each of both sides and the middle
    assert outcome.summary["predicted_x_bar"] is None and lines["predicted"] == ""
    (warning,) = capsys.readouterr().err.splitlines()
    assert warning.startswith("warning: environment.mu = 0.9") and "0.6" in warning


def test_a_target_on_a_slope_is_searched_by_simulation(run_task, capsys):
    """The forward model has seen level ground alone."""
    given = ("environment.slope_rad=0.1", "inverse=physics")
    outcome, lines = run_task("target=[2.0,14.0]", *given)
    found = outcome.summary
    assert outcome.status == "ok" and found["predicted_x_bar"] is None
    assert found["error_bar"] < 0.03 and found["slope_rad"] == 0.1
    (warning,) = capsys.readouterr().err.splitlines()
    assert warning.startswith("warning: environment.slope_rad = 0.1") and "goes on" in warning
    # Plumb is along the weight, level across it.
    x, y = (found[f"simulated_{axis}_bar"] for axis in "xy")
    turn = np.array([[np.cos(0.1), -np.sin(0.1)], [np.sin(0.1), np.cos(0.1)]])
    level = [found[f"level_{axis}_bar"] for axis in "xy"]
    assert level == pytest.approx(turn @ [x, y])
    assert "slope 0.1 rad" in lines["inverse"] and lines["on level"].startswith("x ")


BAD_INPUT = (
    "target=[5]", "target=[nan,5]", "target=[5,-1]", "target=far", "environment.mu=0.7",
    "environment.mass_bar=2.5", "inverse.points=1", "inverse.robust=2", "tolerance.mu=-1",
    "tolerance=0", "sim=bounce", "checkpoint=nowhere.safetensors", f"checkpoint={__file__}",
    "robot.length_m=0.03", "environment.slope_rad=0.05", "damping.relaxation_time_s=1e-6",
)  # fmt: skip


@pytest.mark.parametrize("override", BAD_INPUT)
def test_bad_input_is_one_line(checkpoint, override):
    with refused(key_in(override)):
        prepared(checkpoint, *{"target": "target=[5,14]", key_in(override): override}.values())


def test_a_target_must_be_given_and_a_robust_design_be_within_what_was_trained(checkpoint):
    with refused("target"):
        prepared(checkpoint)
    robust = ("inverse=bayesian", "inverse.robust=true")
    with refused("environment.mu"):
        prepared(checkpoint, "target=[5,14]", "environment.mu=0.7", *robust)


def test_a_forward_model_becomes_onnx(command, tmp_path):
    write_checkpoint(tmp_path / "model.safetensors", network(), about())
    done = command("task=export", "checkpoint=model.safetensors", "tracking=off")
    assert done.stderr == "" or "Warning" not in done.stderr
    folder, result = result_in(tmp_path)
    assert 0.0 <= result["max_difference"] < 1e-5
    assert result["onnx_us"] > 0.0 and result["torch_us"] > 0.0
    assert (folder / "forward_model.onnx").stat().st_size > 1000
    assert "us with onnxruntime" in done.stdout and "forward_model.onnx" in done.stdout


@pytest.mark.parametrize("value", ["", 3, "none.safetensors", "text.safetensors"])
def test_checkpoints_that_are_none(value, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "text.safetensors").write_text("a text")
    with refused("checkpoint") as caught:
        Export().prepare({"checkpoint": value, "seed": 0})
    assert caught.value.value == value


def test_what_is_no_network(tmp_path):
    path = str(tmp_path / "model.safetensors")
    write_checkpoint(Path(path), network(RBF), about(RBF))
    with pytest.raises(ParameterError, match="rbf"):
        Export().prepare({"checkpoint": path, "seed": 0})
