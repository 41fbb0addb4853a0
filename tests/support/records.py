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


def only_run(folder: Path) -> tuple[Any, Any, set[str]]:
    """That of the commands' database: the run, its dataset and its files."""
    (run,), client = runs_in(f"sqlite:///{folder / 'mlruns.db'}")
    (given,) = run.inputs.dataset_inputs
    return run, given, {file.path for file in client.list_artifacts(run.info.run_id)}
