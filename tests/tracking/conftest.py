"""A sweep of four jumps, and what a store knows about it afterwards."""

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from records import runs_in

Runs = dict[str, Any]
LAGS = ("0.02", "0.05", "0.1", "0.15")
JUMP = ("sim=jump", "accuracy=draft", "figures=false")
SWEEP = ("-m", *JUMP, "design.delta_alpha=" + ",".join(LAGS))
TWO_AT_A_TIME = ("hydra/launcher=joblib", "hydra.launcher.n_jobs=2")


@pytest.fixture
def runs_of() -> Callable[[str], tuple[list[Any], list[Any], Any]]:
    """Parents, children and the client of the experiment in a store."""

    def find(uri: str) -> tuple[list[Any], list[Any], Any]:
        runs, client = runs_in(uri)
        parents = [run for run in runs if "mlflow.parentRunId" not in run.data.tags]
        return parents, [run for run in runs if run not in parents], client

    return find


@pytest.fixture
def check_sweep(runs_of) -> Callable[[str, Path], None]:
    """Asserts that a store holds one parent and a complete child for each of the four jumps."""

    def check(uri: str, folder: Path) -> None:
        (parent,), children, client = runs_of(uri)
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
        assert len(list(folder.glob("outputs/sweeps/*/*/result.json"))) == len(LAGS)

    return check
