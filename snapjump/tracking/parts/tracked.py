"""A record made from the files of a job, so that it can be written at any time after."""

from collections.abc import Mapping, Sequence
from dataclasses import asdict, replace
from datetime import datetime
from typing import Any

import numpy as np

from snapjump.files.atomic import write_text
from snapjump.files.json_file import read_json, write_json
from snapjump.files.result_folder import ResultFolder
from snapjump.tracking.base import Curves, DatasetUse, Model, Record, State, Tracker, TrackingError
from snapjump.tracking.parts.title import title_of

MARK = "tracking.json"
CHILDREN = "children.json"
DATASETS = "datasets.json"
CURVES = "curves.csv"
MODEL = "model.json"
# Tasks that simulate nothing: what is configured of a simulation says nothing of them.
NO_SIMULATION = ("train", "export")
OF_A_SIMULATION = (
    *("accuracy", "sim", "robot", "design", "environment", "discretization", "frame", "contact"),
    *("friction", "damping", "drag", "drive", "integrator", "stepping", "backend"),
)
SENTENCES = ("accuracy.known_error", "integrator.rows")  # which no column has room for
# What is for the records alone, and no result.
OWN = (MARK, CHILDREN, DATASETS, MODEL)
STATES: dict[str, State] = {
    "ok": "FINISHED",
    "no_jump": "FINISHED",
    "unreachable": "FINISHED",
    "not_reached": "FINISHED",
    "interrupted": "KILLED",
}


def record_folder(
    tracker: Tracker, folder: ResultFolder, name: str | None = None, parent_id: str | None = None
) -> str:
    """Record a job under a parent, or what of it is not recorded yet; returns where, for people.
    ``name``: of a cell; others are called by what they are.
    Raises TrackingError; then the next call goes on with the record that was begun."""
    kept = read_json(folder.path / MARK) or {}
    place = {"place": tracker.place, "parent_id": parent_id}
    same_place = {key: kept.get(key) for key in place} == place
    mark: dict[str, Any] = kept if same_place else dict(place)
    finished_at = (folder.provenance() or {}).get("finished_at")
    record = make_record(folder, name, parent_id)
    if "run_id" not in mark or mark.get("finished_at") != finished_at:
        run_id = tracker.open(record, mark.get("run_id"))
        if run_id is None:
            return ""
        below = mark.get("children", {}) if mark.get("run_id") == run_id else {}
        sent = mark.get("sent", {}) if mark.get("run_id") == run_id else {}
        ours = {"name": name, "run_id": run_id, "children": below, "files": False, "sent": sent}
        mark = {**place, **ours}
        write_json(folder.path / MARK, mark)
        tracker.write(run_id, replace(record, curves=beyond(record.curves, sent)))
        try:
            record_children(tracker, folder, run_id, below)
        finally:
            write_json(folder.path / MARK, mark)
        mark["finished_at"] = finished_at
        write_json(folder.path / MARK, mark)
    if mark.get("files") is False:
        try:
            tracker.send(mark["run_id"], record)
        except TrackingError as error:
            raise TrackingError(f"all but the files ({error})") from error
        write_json(folder.path / MARK, {**mark, "files": True})
    return f"{mark['place']} run {mark['run_id']}"


def write_children(folder: ResultFolder, children: Sequence[Mapping[str, Any]]) -> None:
    """Leave what is to be recorded below a job's own record.
    Each child has a name, a status, a message, started_at, finished_at, params and metrics."""
    write_json(folder.path / CHILDREN, {"children": list(children)})


def write_datasets(folder: ResultFolder, datasets: Sequence[DatasetUse]) -> None:
    """Leave which datasets a job made or used, for its record."""
    write_json(folder.path / DATASETS, {"datasets": [asdict(use) for use in datasets]})


def write_model(folder: ResultFolder, model: Model) -> None:
    """Leave which file of a job is a model to be registered."""
    write_json(folder.path / MODEL, {**asdict(model), "file": model.file.name})


def read_model(folder: ResultFolder) -> Model | None:
    """The model that a job left with :func:`write_model`."""
    found = read_json(folder.path / MODEL)
    return None if found is None else Model(**{**found, "file": folder.path / found["file"]})


def write_curves(folder: ResultFolder, rows: Sequence[Mapping[str, float]]) -> None:
    """Leave numbers against steps as a table; the first column is the step, a whole number.
    Writes no file if there are no rows. A value that is not finite is left out."""
    if rows:
        import pandas as pd

        table = pd.DataFrame(rows)
        write_text(folder.path / CURVES, table.where(np.isfinite(table)).to_csv(index=False))


def read_curves(folder: ResultFolder) -> Curves:
    """The curves that a job left with :func:`write_curves`; nothing if it left none."""
    if not (folder.path / CURVES).exists():
        return {}
    import pandas as pd

    table = pd.read_csv(folder.path / CURVES, index_col=0, dtype=str)
    known = {key: column.dropna().items() for key, column in table.items() if column.count()}
    return {key: [(int(step), float(v)) for step, v in curve] for key, curve in known.items()}


def record_children(
    tracker: Tracker, folder: ResultFolder, parent_id: str, ids: dict[str, str]
) -> None:
    """Record what a job left with :func:`write_children`; puts into ``ids`` those by name."""
    for child in (read_json(folder.path / CHILDREN) or {}).get("children", []):
        record = Record(
            name=child["name"],
            state=STATES.get(child["status"], "FAILED"),
            started_ms=milliseconds(child["started_at"]),
            ended_ms=milliseconds(child["finished_at"]),
            params=flat(child["params"]),
            metrics=child["metrics"],
            tags={"status": child["status"], "message": child["message"]},
            parent_id=parent_id,
        )
        ids[record.name] = str(tracker.open(record, ids.get(record.name)))
        tracker.write(ids[record.name], record)


def beyond(curves: Curves, sent: Mapping[str, int]) -> Curves:
    """The steps of curves after those that were recorded while the job was under way."""
    return {
        key: [(step, value) for step, value in curve if step > sent.get(key, -1)]
        for key, curve in curves.items()
    }


def make_record(
    folder: ResultFolder,
    name: str | None = None,
    parent_id: str | None = None,
    command: str | None = None,
) -> Record:
    """The record of a job, from its files; ``command``: of one that is under way."""
    config = folder.config() or {}
    result = dict(folder.result() or {"status": "interrupted"})
    origin = folder.provenance() or {}
    told = command or str(origin.get("command"))
    words = {key: str(value) for key, value in result.items() if isinstance(value, (str, bool))}
    return Record(
        name=name or title_of(config, told),
        state=STATES.get(result["status"], "FAILED"),
        started_ms=milliseconds(origin.get("started_at")),
        ended_ms=milliseconds(origin.get("finished_at")),
        params={k: v for k, v in flat(told_of(config)).items() if k not in SENTENCES},
        metrics=numbers_of(result),
        tags={
            **words,
            **tags_of(config),
            "command": told,
            "folder": str(folder.path.absolute()),
            "git_dirty": str(origin.get("git_dirty")).lower(),
            "mlflow.source.git.commit": str(origin.get("git_revision")),
            "mlflow.source.name": "snapjump",
            "source_sha256": str(origin.get("source_sha256")),
        },
        files=[file for file in folder.files() if file.name not in OWN],
        parent_id=parent_id,
        datasets=[
            DatasetUse(**use)
            for use in (read_json(folder.path / DATASETS) or {}).get("datasets", [])
        ],
        curves=read_curves(folder),
        model=read_model(folder),
    )


def told_of(config: Mapping[str, Any]) -> dict[str, Any]:
    """What of a configuration says anything of its run, and fits a table."""
    found = {key: value for key, value in config.items() if key != "tracking"}
    if config.get("task", {}).get("name") in NO_SIMULATION:
        found = {key: value for key, value in found.items() if key not in OF_A_SIMULATION}
    return found


def tags_of(config: Mapping[str, Any]) -> dict[str, str]:
    """What runs are told apart and filtered by."""
    config = told_of(config)
    found = {
        "task": config.get("task", {}).get("name"),
        "scene": config.get("sim", {}).get("name"),
        "tier": config.get("accuracy", {}).get("name"),
        "dataset": (config.get("dataset") or {}).get("path"),
    }
    return {key: str(value) for key, value in found.items() if value is not None}


def numbers_of(result: Mapping[str, Any]) -> dict[str, float]:
    """The numbers of a result."""
    numbers = {key: v for key, v in result.items() if isinstance(v, (int, float))}
    return {key: float(v) for key, v in numbers.items() if not isinstance(v, bool)}


def flat(values: Mapping[str, Any], prefix: str = "") -> dict[str, Any]:
    """Nested keys joined by dots."""
    found: dict[str, Any] = {}
    for key, value in values.items():
        if isinstance(value, Mapping):
            found.update(flat(value, f"{prefix}{key}."))
        else:
            found[f"{prefix}{key}"] = value
    return found


def milliseconds(text: str | None) -> int:
    """A time in ISO 8601, or now, in ms since 1970."""
    time = datetime.now() if text is None else datetime.fromisoformat(text)
    return int(1000 * time.timestamp())
