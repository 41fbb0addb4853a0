"""What all MLflow trackers share: one run per record, written in one batch at the end."""

import json
import logging
import os
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from functools import cached_property
from typing import TYPE_CHECKING, Any

from snapjump.tracking.base import DatasetUse, Record, TrackingError

if TYPE_CHECKING:
    from mlflow.entities import DatasetInput
    from mlflow.tracking import MlflowClient

PARAMS_PER_BATCH = 100
METRICS_PER_BATCH = 1000
LONGEST_PARAM = 5000
LONGEST_TAG = 5000
LONGEST_DIGEST = 36
ENVIRONMENT = {
    "MLFLOW_DISABLE_TELEMETRY": "true",
    "MLFLOW_SUPPRESS_PRINTING_URL_TO_STDOUT": "true",
    "MLFLOW_ENABLE_ARTIFACTS_PROGRESS_BAR": "false",
    # A server that has gone must not hold up a job whose results are safe on disk.
    "MLFLOW_HTTP_REQUEST_MAX_RETRIES": "2",
    "MLFLOW_HTTP_REQUEST_TIMEOUT": "30",
    "GIT_PYTHON_REFRESH": "quiet",
}


class MlflowStore:
    """Records in one experiment of the MLflow store at ``uri``."""

    def __init__(self, uri: str, experiment: str, artifacts: str | None):
        self.uri, self.experiment, self.artifacts = uri, experiment, artifacts

    @property
    def place(self) -> str:
        return self.uri

    def prepare(self) -> None:
        """Make the store ready for use."""
        raise NotImplementedError

    @cached_property
    def client(self) -> "MlflowClient":
        """The client; importing it takes more than a second."""
        for key, value in ENVIRONMENT.items():
            os.environ.setdefault(key, value)
        from mlflow.tracking import MlflowClient

        logging.getLogger("mlflow").setLevel(logging.WARNING)
        logging.getLogger("alembic").setLevel(logging.WARNING)
        return MlflowClient(tracking_uri=self.uri, registry_uri=self.uri)

    def record(self, record: Record, run_id: str | None = None) -> str:
        """Write one record, into the run of an earlier attempt if there is one; its id."""
        parent = {"mlflow.parentRunId": record.parent_id} if record.parent_id else {}
        with tracking_errors(self.uri):
            if run_id is not None and self._rewrite(run_id, record):
                return run_id
            run_id = self._create(record.name, record.started_ms, parent)
            self._complete(run_id, record)
        return run_id

    def open_parent(self, name: str, run_id: str | None) -> str:
        """Start the run of a whole sweep, or go on with the one that an earlier start made."""
        with tracking_errors(self.uri):
            if run_id is not None and self._reopen(run_id):
                return run_id
            return self._create(name, None, {"sweep": "true"})

    def close_parent(self, run_id: str, record: Record) -> None:
        """Complete the run of a whole sweep."""
        with tracking_errors(self.uri):
            self._complete(run_id, record)

    def _create(self, name: str, started_ms: int | None, tags: Mapping[str, str]) -> str:
        self.prepare()
        run = self.client.create_run(
            self._experiment_id(), start_time=started_ms, tags=dict(tags), run_name=name
        )
        return str(run.info.run_id)

    def _complete(self, run_id: str, record: Record) -> None:
        from mlflow.entities import Metric, Param, RunTag

        params = [Param(key, _cut(value, LONGEST_PARAM)) for key, value in record.params.items()]
        metrics = [Metric(key, value, record.ended_ms, 0) for key, value in record.metrics.items()]
        tags = [RunTag(key, _cut(value, LONGEST_TAG)) for key, value in record.tags.items()]
        self.client.log_batch(run_id, metrics=metrics, params=params[:PARAMS_PER_BATCH], tags=tags)
        for first in range(PARAMS_PER_BATCH, len(params), PARAMS_PER_BATCH):
            self.client.log_batch(run_id, params=params[first : first + PARAMS_PER_BATCH])
        points = [
            Metric(key, value, record.ended_ms, step)
            for key, curve in record.curves.items()
            for step, value in curve
        ]
        for first in range(0, len(points), METRICS_PER_BATCH):
            self.client.log_batch(run_id, metrics=points[first : first + METRICS_PER_BATCH])
        if record.datasets:
            self.client.log_inputs(run_id, [_input(use) for use in record.datasets])
        for file in record.files:
            self.client.log_artifact(run_id, str(file))
        self.client.set_terminated(run_id, record.state, record.ended_ms)

    def _experiment_id(self) -> str:
        from mlflow.exceptions import MlflowException

        found = self.client.get_experiment_by_name(self.experiment)
        if found is None:
            try:
                return str(self.client.create_experiment(self.experiment, self._artifact_folder()))
            except MlflowException:
                # Another process has just created it, or the reason will come up again.
                found = self.client.get_experiment_by_name(self.experiment)
                if found is None:
                    raise
        return str(found.experiment_id)

    def _artifact_folder(self) -> str | None:
        return None if self.artifacts is None else f"{self.artifacts}/{self.experiment}"

    def _rewrite(self, run_id: str, record: Record) -> bool:
        from mlflow.exceptions import MlflowException

        try:
            self._complete(run_id, record)
        except MlflowException:
            # The run is gone, or was made with other parameters, which MLflow never changes.
            return False
        return True

    def _reopen(self, run_id: str) -> bool:
        from mlflow.exceptions import MlflowException

        try:
            self.client.update_run(run_id, status="RUNNING")
        except MlflowException:
            return False
        return True


@contextmanager
def tracking_errors(uri: str) -> Iterator[None]:
    """Turn whatever the store and its network raise into a TrackingError of one line."""
    try:
        yield
    except Exception as error:
        lines = str(error).strip().splitlines() or [type(error).__name__]
        raise TrackingError(f"{uri}: {lines[0]}") from error


def _input(use: DatasetUse) -> "DatasetInput":
    from mlflow.entities import Dataset, DatasetInput, InputTag

    dataset = Dataset(
        name=use.name,
        digest=_cut(use.digest, LONGEST_DIGEST),
        source_type="local",
        source=json.dumps({"uri": use.path}),
        profile=json.dumps({"num_rows": use.rows, "dataset_sha256": use.digest}),
    )
    return DatasetInput(dataset, [InputTag("mlflow.data.context", use.context)])


def _cut(value: Any, longest: int) -> str:
    return str(value)[:longest]
