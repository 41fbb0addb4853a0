"""The base of all MLflow trackers: one run per record, written in one batch at the end.

Whatever a store does, nobody waits for it for ever: each step has a deadline, and a store that
missed one is not asked again by this process.
"""

import json
import logging
import os
import time
from collections.abc import Callable, Mapping, Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Any, TypeVar

from snapjump.deadline import LateError, check_left, within
from snapjump.tracking.base import Curves, DatasetUse, Record, Tracker, TrackingError
from snapjump.tracking.parts.registry import register

if TYPE_CHECKING:
    from mlflow.entities import DatasetInput
    from mlflow.tracking import MlflowClient

T = TypeVar("T")
PARAMS_PER_BATCH = 100
METRICS_PER_BATCH = 1000
LONGEST_PARAM = 5000
LONGEST_TAG = 5000
LONGEST_DIGEST = 36
LONGEST_REASON = 200
# In seconds: for tables and imports, which are ours; for numbers; for files, with so much a MB.
READY_S, NUMBERS_S, FILES_S, MEGABYTE_S = 180.0, 20.0, 20.0, 1.0
UNDER_WAY_S = 5.0  # of a job that waits meanwhile
ENVIRONMENT = {
    "MLFLOW_DISABLE_TELEMETRY": "true",
    "MLFLOW_SUPPRESS_PRINTING_URL_TO_STDOUT": "true",
    "MLFLOW_ENABLE_ARTIFACTS_PROGRESS_BAR": "false",
    "MLFLOW_HTTP_REQUEST_MAX_RETRIES": "2",
    "MLFLOW_HTTP_REQUEST_TIMEOUT": "10",
    # Servers ask for an hour of patience.
    "MLFLOW_HTTP_RESPECT_RETRY_AFTER_HEADER": "false",
    "GIT_PYTHON_REFRESH": "quiet",
}
# Otherwise MLflow takes it for a chatbot's, and shows traces and judges in the place of runs.
EXPERIMENT = {
    "mlflow.experimentKind": "custom_model_development",
    "mlflow.note.content": (
        "Simulations, sweeps, datasets, trainings and inverse designs of Snapjump. Columns to look "
        "at: tags task, scene, tier and status; metrics x_bar, y_bar (apex in L), "
        "error_estimate_percent, mae_bar. A sweep is a run with a run below it for each cell: "
        "choose them and press Compare."
    ),
}
_late: set[str] = set()  # places that missed a deadline of this process


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
        # Its words about attempts that fail come again in the one line of what became of them.
        logging.getLogger("urllib3").setLevel(logging.ERROR)
        return MlflowClient(tracking_uri=self.place, registry_uri=self.place)

    def open(self, record: Record, run_id: str | None) -> str:
        self._bounded(READY_S, self._get_ready)
        return self._bounded(NUMBERS_S, lambda: self._open(record, run_id))

    def _get_ready(self) -> None:
        assert self.client
        self.prepare()

    def add(self, run_id: str, params: Mapping[str, Any], curves: Curves) -> None:
        self._bounded(UNDER_WAY_S, lambda: self._add(run_id, params, curves))

    def write(self, run_id: str, record: Record) -> None:
        self._bounded(NUMBERS_S, lambda: self._write(run_id, record))

    def send(self, run_id: str, record: Record) -> None:
        megabytes = sum(file.stat().st_size for file in record.files) / 1e6
        self._bounded(FILES_S + MEGABYTE_S * megabytes, lambda: self._send(run_id, record))

    def _bounded(self, seconds: float, work: Callable[[], T]) -> T:
        """Work with the store that has to end in time. Raises TrackingError of one line."""
        if self.place in _late:
            raise TrackingError(f"{self.place}: it did not answer before")
        try:
            return within(seconds, work)
        except Exception as error:
            if isinstance(error, LateError):
                _late.add(self.place)
            lines = str(error).strip().splitlines() or [type(error).__name__]
            reason = "".join(c if c.isprintable() else "?" for c in lines[0])
            raise TrackingError(f"{self.place}: {reason[:LONGEST_REASON]}") from error

    def _open(self, record: Record, run_id: str | None) -> str:
        if run_id and self._goes_on(run_id, record):
            return run_id
        tags = dict(record.tags)
        if record.parent_id:
            tags["mlflow.parentRunId"] = record.parent_id
        experiment = self._experiment_id()
        check_left()
        run = self.client.create_run(
            experiment, start_time=record.started_ms, tags=_cut_all(tags), run_name=record.name
        )
        return str(run.info.run_id)

    def _goes_on(self, run_id: str, record: Record) -> bool:
        """Whether an earlier run can be continued: it may be gone, or have been made with other
        parameters, which MLflow never changes."""
        from mlflow.exceptions import MlflowException

        try:
            self.client.update_run(run_id, status="RUNNING")
            self._log_params(run_id, record.params)
        except MlflowException:
            return False
        return True

    def _add(self, run_id: str, params: Mapping[str, Any], curves: Curves) -> None:
        self._log_params(run_id, params)
        self._log_curves(run_id, curves, int(1000 * time.time()))

    def _log_curves(self, run_id: str, curves: Curves, at_ms: int) -> None:
        from mlflow.entities import Metric

        points = [
            Metric(key, value, at_ms, step)
            for key, curve in curves.items()
            for step, value in curve
        ]
        for some in _pieces(points, METRICS_PER_BATCH):
            check_left()
            self.client.log_batch(run_id, metrics=some)

    def _write(self, run_id: str, record: Record) -> None:
        from mlflow.entities import Metric, RunTag

        self._log_params(run_id, record.params)
        metrics = [Metric(key, value, record.ended_ms, 0) for key, value in record.metrics.items()]
        tags = [RunTag(key, value) for key, value in _cut_all(record.tags).items()]
        check_left()
        self.client.log_batch(run_id, metrics=metrics, tags=tags)
        self._log_curves(run_id, record.curves, record.ended_ms)
        if record.datasets:
            self.client.log_inputs(run_id, [_input(use) for use in record.datasets])
        check_left()
        self.client.set_terminated(run_id, record.state, record.ended_ms)

    def _log_params(self, run_id: str, values: Mapping[str, Any]) -> None:
        from mlflow.entities import Param

        params = [Param(key, _cut(value, LONGEST_PARAM)) for key, value in values.items()]
        for some in _pieces(params, PARAMS_PER_BATCH):
            check_left()
            self.client.log_batch(run_id, params=some)

    def _send(self, run_id: str, record: Record) -> None:
        for file in record.files:
            check_left()
            self.client.log_artifact(run_id, str(file))
        if record.model is not None:
            check_left()
            register(self.client, run_id, record.model)

    def _experiment_id(self) -> str:
        from mlflow.exceptions import MlflowException

        place = None if self.artifacts is None else f"{self.artifacts}/{self.experiment}"
        found = self.client.get_experiment_by_name(self.experiment)
        if found is None:
            check_left()
            try:
                return str(self.client.create_experiment(self.experiment, place, EXPERIMENT))
            except MlflowException:
                # Another process has just created it, or the reason will come up again.
                found = self.client.get_experiment_by_name(self.experiment)
                if found is None:
                    raise
        for key, value in EXPERIMENT.items():
            if key not in found.tags:  # it was made by an earlier version
                check_left()
                self.client.set_experiment_tag(found.experiment_id, key, value)
        return str(found.experiment_id)


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


def _cut_all(tags: Mapping[str, str]) -> dict[str, str]:
    return {key: _cut(value, LONGEST_TAG) for key, value in tags.items()}
