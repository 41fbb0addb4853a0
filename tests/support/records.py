"""What a store of records holds."""

from pathlib import Path
from typing import Any


def runs_in(uri: str) -> tuple[list[Any], Any]:
    """The runs of the experiment, and the client that asks for more."""
    from mlflow.tracking import MlflowClient

    client = MlflowClient(tracking_uri=uri)
    experiment = client.get_experiment_by_name("snapjump")
    assert experiment is not None
    return list(client.search_runs([experiment.experiment_id])), client


def database_in(folder: Path) -> str:
    """The tracking database of the commands that run in a folder."""
    return f"sqlite:///{folder / 'mlruns.db'}"


def only_run(folder: Path) -> tuple[Any, Any, set[str]]:
    """The only run of the commands in a folder, its dataset and its files."""
    (run,), client = runs_in(database_in(folder))
    (given,) = run.inputs.dataset_inputs
    return run, given, {file.path for file in client.list_artifacts(run.info.run_id)}
