"""``python run.py task=train``: what it leaves, records, finds again, refuses and survives."""

import json
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from command_line import begun, result_in
from forward_models import RBF
from hydra_config import hydra_config
from PIL import Image
from records import database_in, only_run, runs_in
from refusals import key_in, refused
from small_datasets import silent, small, smooth_dataset

from snapjump.checks import ParameterError
from snapjump.dataset.folder import default_path
from snapjump.dataset.read import load_dataset
from snapjump.dataset.specification import specify
from snapjump.files.result_folder import ResultFolder
from snapjump.learning.forward_model import forward_model
from snapjump.run.tasks.train import Train
from snapjump.surrogate.resnet import Resnet

QUICK = ("surrogate.width=16", "surrogate.blocks=1", "training.epochs=5", "training.batch_last=64")
SMALL = ("task=train", *QUICK)
Config = Callable[..., dict[str, Any]]


@pytest.fixture(scope="module")
def dataset(tmp_path_factory) -> Path:
    """200 jumps by a smooth law."""
    path: Path = tmp_path_factory.mktemp("smooth")
    smooth_dataset(path, small(200, 200))
    return path


@pytest.fixture
def configured(dataset, tmp_path, monkeypatch) -> Config:
    """What Hydra would compose, for a run in a folder of its own."""
    monkeypatch.chdir(tmp_path)
    return partial(hydra_config, *SMALL, f"dataset.path={dataset}")


def trained(config: Config, path: Path, **groups: Any) -> tuple[Train, Any]:
    """The task and its outcome, of a configuration with some groups replaced."""
    task = Train()
    task.prepare({**config(), **groups})
    path.mkdir(exist_ok=True)
    return task, task.run(ResultFolder(path), silent)


def test_what_has_no_epochs_has_a_figure_and_no_curves(configured, tmp_path):
    _, outcome = trained(configured, tmp_path, surrogate=RBF)
    assert outcome.status == "ok" and outcome.summary["epochs"] == 0
    assert (tmp_path / "training.png").exists() and not (tmp_path / "curves.csv").exists()


def test_a_training_that_diverges_is_told(configured, tmp_path, monkeypatch):
    monkeypatch.setattr(Resnet, "loss", lambda network, rows: np.nan * network(rows.designs).sum())
    _, outcome = trained(configured, tmp_path)
    assert outcome.status == "not_finite" and "training.learning_rate" in outcome.message
    assert not (tmp_path / "forward_model.safetensors").exists()


def test_a_forward_model_and_its_record(command, database, dataset, tmp_path):
    done = command(*SMALL, f"dataset.path={dataset}")
    folder, result = result_in(tmp_path)
    assert result["status"] == "ok" and result["epochs"] == 5 and result["rows_train"] == 144
    assert result["dataset_sha256"] == load_dataset(dataset).sha256
    assert result["checkpoint"] == str((folder / "forward_model.safetensors").relative_to(tmp_path))
    assert result["checkpoint"] in done.stdout and "MAE" in done.stdout
    model = forward_model(folder / "forward_model.safetensors")
    assert model.about["measures"]["mae_bar"] == result["mae_bar"] > 0.0
    assert model.about["configuration"]["training"]["epochs"] == 5
    assert result["inference_us"] > 0.0 and result["parameters"] > 600
    assert len((folder / "curves.csv").read_text().splitlines()) == 6
    assert np.asarray(Image.open(folder / "training.png")).std() > 5.0
    check_record(tmp_path, result)


def check_record(folder: Path, result: dict[str, Any]) -> None:
    """The run has the dataset as its input, the curves against epochs, and the file."""
    run, given, files = only_run(folder)
    assert run.data.metrics["mae_bar"] == pytest.approx(result["mae_bar"])
    assert run.data.params["training.epochs"] == "5" and run.data.params["surrogate.width"] == "16"
    assert given.dataset.digest == result["dataset_sha256"][:36]
    assert [tag.value for tag in given.tags] == ["training"]
    _, client = runs_in(database_in(folder))
    for name in ("train_loss", "validation_mae_bar", "learning_rate"):
        history = client.get_metric_history(run.info.run_id, name)
        assert [metric.step for metric in history] == [1, 2, 3, 4, 5]
    assert {"forward_model.safetensors", "curves.csv", "training.png"} <= files


@pytest.mark.processes
def test_a_killed_training_goes_on(command, dataset, tmp_path):
    long = (*SMALL, f"dataset.path={dataset}", "training.epochs=100", "training.patience=100")
    off = ("tracking=off", "figures=false")
    process = begun(tmp_path, *long, *off, until="outputs/training/*/last.ckpt")
    process.kill()
    process.communicate()
    (folder,) = tmp_path.glob("outputs/training/*")
    assert not (folder / "forward_model.safetensors").exists()
    done = command(*long, *off)
    curves = json.loads((folder / "curves.json").read_text())["curves"]
    assert [row["epoch"] for row in curves] == list(range(1, 101))
    assert "trained" in done.stdout and not list(folder.glob(".last*"))


def test_what_was_trained_is_found_again(configured, tmp_path):
    kept = []
    for name in ("first", "second"):
        task, outcome = trained(configured, tmp_path / name, figures=False)
        kept.append(outcome.summary["trained_before"])
        assert ("before this run" in str(task.report(outcome))) == kept[-1]
    assert kept == [False, True]
    one, other = (tmp_path / n / "forward_model.safetensors" for n in ("first", "second"))
    assert one.read_bytes() == other.read_bytes()


BAD_INPUT = (
    "training.rows=161", "training.rows=20", "training.test_share=0.99", "training.epochs=0",
    "+training.optimizer=sgd", "~training.epochs", "surrogate.width=0", "dataset.path=''",
    "dataset.path=3", "+dataset.part=1", "~dataset.shard_size",
)  # fmt: skip


@pytest.mark.parametrize("override", BAD_INPUT)
def test_bad_input(configured, override):
    with refused(key_in(override)):
        Train().prepare(configured(override))


def test_a_surrogate_that_needs_slopes_names_the_dataset_without(configured, dataset):
    values = configured()
    values["surrogate"] = {"name": "gradient_mlp", "width": 8, "layers": 1, "slope_weight": 0.1}
    with refused("dataset.path", "dataset.sensitivities=true") as caught:
        Train().prepare(values)
    assert caught.value.value == str(dataset)


def test_a_dataset_that_is_not_there_is_named_with_the_command_that_makes_it(configured, tmp_path):
    values = configured("dataset.path=null", "accuracy=draft", "plan=sobol", "plan.count=64")
    with pytest.raises(ParameterError, match=r"make it with: python run\.py task=dataset") as error:
        Train().prepare(values)
    assert error.value.value == str(default_path(specify(values, 1024)))
    empty = tmp_path / "empty"
    empty.mkdir()
    with pytest.raises(ParameterError, match=r"dataset\.path"):
        Train().prepare(configured(f"dataset.path={empty}"))


def test_the_command_that_makes_a_dataset_has_all_that_determines_it(refusal):
    overrides = ("surrogate=mlp", "training.epochs=3", "accuracy=draft", "plan.points=3")
    line = refusal("task=train", *overrides, "tracking=off", "seed=4")
    expected = "python run.py task=dataset accuracy=draft plan.points=3 seed=4"
    assert line.strip().endswith(expected)
