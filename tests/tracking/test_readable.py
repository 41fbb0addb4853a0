"""The store as people see it: kind of experiment, names, tags, parents, the registered model."""

from typing import Any

import numpy as np
import pytest
from records import database_in, runs_in

pytestmark = pytest.mark.processes

QUICK = ("accuracy=draft", "figures=false")


def tagged(runs: list[Any], **tags: str) -> list[Any]:
    return [run for run in runs if tags.items() <= run.data.tags.items()]


def test_runs_can_be_read(command, tmp_path, monkeypatch):
    command("design.epsilon=0.25", *QUICK)
    command("-m", "design.epsilon=0.1,0.2", *QUICK)
    command("task=dataset", "plan=sobol", "plan.count=64", "dataset.path=d", *QUICK)
    few = ("training.validation_share=0.2", "training.epochs=5")
    command("task=train", "dataset.path=d", *few, "figures=false")
    runs, client = runs_in(database_in(tmp_path))
    experiment = client.get_experiment_by_name("snapjump")
    assert experiment.tags["mlflow.experimentKind"] == "custom_model_development"
    assert "x_bar" in experiment.tags["mlflow.note.content"]
    (jump,) = [run for run in runs if run.info.run_name.startswith("jump epsilon=0.25")]
    assert tagged([jump], task="simulate", scene="jump", tier="draft", status="ok") == [jump]
    (parent,) = tagged(runs, task="sweep")
    assert parent.info.run_name == "sweep over design.epsilon"
    assert parent.data.params["design.epsilon"] == "0.1,0.2"
    assert parent.data.tags["command"].endswith(
        "-m design.epsilon=0.1,0.2 accuracy=draft figures=false"
    )
    assert parent.data.metrics["largest_y_bar"] > 10.0
    cells = tagged(runs, **{"mlflow.parentRunId": parent.info.run_id})
    assert {run.info.run_name for run in cells} == {"epsilon=0.1", "epsilon=0.2"}
    (training,) = tagged(runs, task="train")
    assert (
        training.info.run_name.startswith("train path=d") and training.data.tags["dataset"] == "d"
    )
    (version,) = client.search_model_versions("name = 'snapjump-forward-model'")
    assert version.run_id == training.info.run_id
    monkeypatch.chdir(tmp_path)  # where MLflow makes a store of its own
    check_model(version.source)


def check_model(place: str) -> None:
    """The registered model answers, and says what it wants."""
    import mlflow.pyfunc

    model = mlflow.pyfunc.load_model(place)
    assert model.metadata.signature is not None
    assert model.metadata.metadata["designs"] == ["delta_alpha_rad", "epsilon", "mass_bar", "mu"]
    design = np.array([[0.1, 0.2, 0.768, 0.3]], dtype=np.float32)
    assert model.predict({"designs": design})["apexes"].shape == (1, 2)
