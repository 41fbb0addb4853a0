"""The base of all MLflow trackers: one run per record, written in one batch at the end."""

import json
import logging
import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from functools import cached_property
from typing import TYPE_CHECKING, Any

from snapjump.tracking.base import DatasetUse, Record, Tracker, TrackingError

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


class MlflowStore(Tracker):
    """Records in one ``experiment`` of the MLflow store that is at ``place``."""

    experiment: str = "snapjump"

    @property
    def artifacts(self) -> str | None:
        """Where files are put, None to leave that to the store."""
        return None

    def prepare(self) -> None:
        """Make the store ready for use, if it does not look after that itself."""

    @cached_property
    def client(self) -> "MlflowClient":
        """The client; importing it takes more than a second."""
        for key, value in ENVIRONMENT.items():
            os.environ.setdefault(key, value)
        from mlflow.tracking import MlflowClient

        logging.getLogger("mlflow").setLevel(logging.WARNING)
        logging.getLogger("alembic").setLevel(logging.WARNING)
        return MlflowClient(tracking_uri=self.place, registry_uri=self.place)

    def record(self, record: Record, run_id: str | None = None) -> str:
        """Write one record, into the run of an earlier attempt if there is one; its id."""
        parent = {"mlflow.parentRunId": record.parent_id} if record.parent_id else {}
        with tracking_errors(self.place):
            if run_id and self._goes_on(lambda: self._complete(run_id, record)):
                return run_id
            created = self._create(record.name, record.started_ms, parent)
            self._complete(created, record)
        return created

    def open_parent(self, name: str, run_id: str | None) -> str:
        """Start the run of a whole sweep, or go on with the one that an earlier start made."""
        with tracking_errors(self.place):
            if run_id and self._goes_on(lambda: self.client.update_run(run_id, status="RUNNING")):
                return run_id
            return self._create(name, None, {"sweep": "true"})

    def close_parent(self, run_id: str, record: Record) -> None:
        with tracking_errors(self.place):
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
        points = [
            Metric(key, value, record.ended_ms, step)
            for key, curve in record.curves.items()
            for step, value in curve
        ]
        first, *more = _pieces(params, PARAMS_PER_BATCH) or [[]]
        self.client.log_batch(run_id, metrics=metrics, params=first, tags=tags)
        for some in more:
            self.client.log_batch(run_id, params=some)
        for some in _pieces(points, METRICS_PER_BATCH):
            self.client.log_batch(run_id, metrics=some)
        if record.datasets:
            self.client.log_inputs(run_id, [_input(use) for use in record.datasets])
        for file in record.files:
            self.client.log_artifact(run_id, str(file))
        self.client.set_terminated(run_id, record.state, record.ended_ms)

    def _experiment_id(self) -> str:
        from mlflow.exceptions import MlflowException

        place = None if self.artifacts is None else f"{self.artifacts}/{self.experiment}"
        found = self.client.get_experiment_by_name(self.experiment)
        if found is None:
            try:
                return str(self.client.create_experiment(self.experiment, place))
            except MlflowException:
                # Another process has just created it, or the reason will come up again.
                found = self.client.get_experiment_by_name(self.experiment)
                if found is None:
                    raise
        return str(found.experiment_id)

    def _goes_on(self, continued: Callable[[], Any]) -> bool:
        """Whether an earlier run can be continued so: it may be gone, or have been made with other
        parameters, which MLflow never changes."""
        from mlflow.exceptions import MlflowException

        try:
            continued()
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


def _pieces(items: Sequence[Any], size: int) -> list[Any]:
    return [items[first : first + size] for first in range(0, len(items), size)]


def _cut(value: Any, longest: int) -> str:
    return str(value)[:longest]
