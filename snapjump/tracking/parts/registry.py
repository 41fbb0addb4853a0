"""A trained model in MLflow: logged with its signature, and a version in the registry."""

import logging
import warnings
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING

import numpy as np

from snapjump.tracking.base import Model

if TYPE_CHECKING:
    from mlflow.tracking import MlflowClient

FOLDER = "model"
REQUIREMENTS = ["onnxruntime"]  # told, or MLflow would find them out by trying


def register(client: "MlflowClient", run_id: str, model: Model) -> None:
    """Log a model below a run, and register it: each run's is a version."""
    import mlflow.onnx
    import onnx
    from mlflow.exceptions import MlflowException
    from mlflow.models import ModelSignature
    from mlflow.types import Schema, TensorSpec

    def tensor(name: str, columns: int) -> Schema:
        return Schema([TensorSpec(np.dtype(np.float32), (-1, columns), name)])

    signature = ModelSignature(
        tensor("designs", len(model.inputs)), tensor("apexes", len(model.outputs))
    )
    with TemporaryDirectory() as folder, warnings.catch_warnings():
        warnings.simplefilter("ignore")
        logging.getLogger("mlflow").setLevel(logging.ERROR)
        place = Path(folder, FOLDER)
        columns = {"designs": list(model.inputs), "apexes": list(model.outputs)}
        mlflow.onnx.save_model(
            onnx.load(model.file), str(place), signature=signature,
            pip_requirements=REQUIREMENTS, metadata=columns,
        )  # fmt: skip
        client.log_artifacts(run_id, str(place), FOLDER)
    try:
        client.create_registered_model(model.name)
    except MlflowException:
        pass  # it is there; where it is not, the next call says why
    uri = client.get_run(run_id).info.artifact_uri
    client.create_model_version(model.name, f"{uri}/{FOLDER}", run_id)
