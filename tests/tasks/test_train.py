"""``python run.py task=train``: what it leaves, records, finds again, refuses and survives."""

import json
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hydra_config import hydra_config
from PIL import Image
from refusals import refused
from small_datasets import small, smooth_dataset

from snapjump.checks import ParameterError
from snapjump.dataset.folder import default_path
from snapjump.dataset.read import open_dataset
from snapjump.dataset.specification import specify
from snapjump.files.result_folder import ResultFolder
from snapjump.learning.forward_model import open_forward_model
from snapjump.tasks.train import Train

ROOT = Path(__file__).resolve().parents[2]
QUICK = ("surrogate.width=16", "surrogate.blocks=1", "training.epochs=5", "training.batch_last=64")
SMALL = ("task=train", *QUICK)
Config = Callable[..., dict[str, Any]]


@pytest.fixture(scope="module")
def dataset(tmp_path_factory) -> Path:
    """200 jumps by a smooth law."""
    path = tmp_path_factory.mktemp("datasets") / "smooth"
    smooth_dataset(path, small(200, 200))
    return path


@pytest.fixture
def config(dataset, tmp_path, monkeypatch) -> Config:
    """What Hydra would compose, for a run in a folder of its own."""
    monkeypatch.chdir(tmp_path)
    return partial(hydra_config, *SMALL, f"dataset.path={dataset}")


def silent(share: float, text: str) -> None:
    """No progress."""


def test_a_forward_model_and_its_record(command, database, dataset, tmp_path):
    done = command(*SMALL, f"dataset.path={dataset}")
    assert done.returncode == 0, done.stderr
    (folder,) = {file.parent for file in tmp_path.glob("outputs/20*/*/result.json")}
    result = json.loads((folder / "result.json").read_text())
    assert result["status"] == "ok" and result["epochs"] == 5 and result["rows_train"] == 144
    assert result["dataset_sha256"] == open_dataset(dataset).sha256
    assert result["checkpoint"] == str((folder / "forward_model.safetensors").relative_to(tmp_path))
    assert result["checkpoint"] in done.stdout and "MAE" in done.stdout
    model = open_forward_model(folder / "forward_model.safetensors")
    assert model.about["measures"]["mae_bar"] == result["mae_bar"] > 0.0
    assert model.about["configuration"]["training"]["epochs"] == 5
    assert result["inference_us"] > 0.0 and result["parameters"] > 600
    assert len((folder / "curves.csv").read_text().splitlines()) == 6
    assert np.asarray(Image.open(folder / "training.png")).std() > 5.0
    check_record(tmp_path, result)


def check_record(folder: Path, result: dict[str, Any]) -> None:
    """The run has the dataset as its input, the curves against epochs, and the file."""
    from mlflow.tracking import MlflowClient

    client = MlflowClient(tracking_uri=f"sqlite:///{folder / 'mlruns.db'}")
    experiment = client.get_experiment_by_name("snapjump")
    assert experiment is not None
    (run,) = client.search_runs([experiment.experiment_id])
    assert run.data.metrics["mae_bar"] == pytest.approx(result["mae_bar"])
    assert run.data.params["training.epochs"] == "5" and run.data.params["surrogate.width"] == "16"
    (given,) = run.inputs.dataset_inputs
    assert given.dataset.digest == result["dataset_sha256"][:36]
    assert [tag.value for tag in given.tags] == ["training"]
    for name in ("train_loss", "validation_mae_bar", "learning_rate"):
        history = client.get_metric_history(run.info.run_id, name)
        assert [metric.step for metric in history] == [1, 2, 3, 4, 5]
    artifacts = {file.path for file in client.list_artifacts(run.info.run_id)}
    assert {"forward_model.safetensors", "curves.csv", "training.png"} <= artifacts


def test_a_killed_training_goes_on(command, dataset, tmp_path):
    long = (*SMALL, f"dataset.path={dataset}", "training.epochs=100", "training.patience=100")
    off = ("tracking=off", "figures=false")
    process = subprocess.Popen(
        [sys.executable, str(ROOT / "run.py"), *long, *off],
        cwd=tmp_path,
        stderr=subprocess.DEVNULL,
        stdout=subprocess.DEVNULL,
    )
    while not list(tmp_path.glob("outputs/training/*/last.ckpt")):
        assert process.poll() is None
        time.sleep(0.01)
    process.send_signal(signal.SIGKILL)
    process.wait()
    (folder,) = tmp_path.glob("outputs/training/*")
    assert not (folder / "forward_model.safetensors").exists()
    done = command(*long, *off)
    assert done.returncode == 0, done.stderr
    curves = json.loads((folder / "curves.json").read_text())["curves"]
    assert [row["epoch"] for row in curves] == list(range(1, 101))
    assert "trained" in done.stdout and not list(folder.glob(".last*"))


def test_what_was_trained_is_found_again(config, tmp_path):
    kept = []
    for name in ("first", "second"):
        (tmp_path / name).mkdir()
        task = Train()
        task.prepare(config("figures=false"))
        outcome = task.run(ResultFolder(tmp_path / name), silent)
        kept.append(outcome.summary["trained_before"])
        assert ("before this run" in str(task.report(outcome))) == outcome.summary["trained_before"]
    assert kept == [False, True]
    one, other = (tmp_path / n / "forward_model.safetensors" for n in ("first", "second"))
    assert one.read_bytes() == other.read_bytes()


def test_what_has_no_epochs_has_a_figure_and_no_curves(config, tmp_path):
    task = Train()
    values = config()
    values["surrogate"] = {"name": "rbf", "neighbours": 20, "kernel": "cubic", "smoothing": 0.0}
    task.prepare(values)
    outcome = task.run(ResultFolder(tmp_path), silent)
    assert outcome.status == "ok" and outcome.summary["epochs"] == 0
    assert (tmp_path / "training.png").exists() and not (tmp_path / "curves.csv").exists()


def test_a_training_that_diverges_is_told(config, tmp_path, monkeypatch):
    from snapjump.surrogate.resnet import Resnet

    monkeypatch.setattr(Resnet, "loss", lambda network, rows: np.nan * network(rows.designs).sum())
    task = Train()
    task.prepare(config())
    outcome = task.run(ResultFolder(tmp_path), silent)
    assert outcome.status == "not_finite" and "training.learning_rate" in outcome.message
    assert not (tmp_path / "forward_model.safetensors").exists()


@pytest.mark.parametrize(
    ("override", "key"),
    [
        ("training.rows=161", "training.rows"),
        ("training.rows=20", "training.rows"),
        ("training.test_share=0.99", "training.test_share"),
        ("training.epochs=0", "training.epochs"),
        ("+training.optimizer=sgd", "training.optimizer"),
        ("~training.epochs", "training.epochs"),
        ("surrogate.width=0", "surrogate.width"),
        ("dataset.path=''", "dataset.path"),
        ("dataset.path=3", "dataset.path"),
        ("+dataset.part=1", "dataset.part"),
        ("~dataset.shard_size", "dataset.shard_size"),
    ],
)
def test_bad_input(config, override, key):
    with refused(key):
        Train().prepare(config(override))


def test_a_surrogate_that_needs_slopes_names_the_dataset_without(config, dataset):
    values = config()
    values["surrogate"] = {"name": "gradient_mlp", "width": 8, "layers": 1, "slope_weight": 0.1}
    with refused("dataset.path", "dataset.sensitivities=true") as caught:
        Train().prepare(values)
    assert caught.value.value == str(dataset)


def test_a_dataset_that_is_not_there_is_named_with_the_command_that_makes_it(
    config, tmp_path, monkeypatch
):
    values = config("dataset.path=null", "accuracy=draft", "plan=sobol", "plan.count=64")
    with pytest.raises(ParameterError, match=r"make it with: python run\.py task=dataset") as error:
        Train().prepare(values)
    assert error.value.value == str(default_path(specify(values, 1024)))
    empty = tmp_path / "empty"
    empty.mkdir()
    with pytest.raises(ParameterError, match=r"dataset\.path"):
        Train().prepare(config(f"dataset.path={empty}"))


def test_the_command_that_makes_a_dataset_has_all_that_determines_it(command):
    overrides = ("surrogate=mlp", "training.epochs=3", "accuracy=draft", "plan.points=3")
    done = command("task=train", *overrides, "tracking=off", "seed=4")
    assert done.returncode == 2 and done.stderr.count("\n") == 1
    expected = "python run.py task=dataset accuracy=draft plan.points=3 seed=4"
    assert done.stderr.strip().endswith(expected)
