"""Small datasets: real ones of a coarse simulation, and shards of made-up numbers."""

from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from snapjump.dataset.columns import Rows, columns_of, slope_columns
from snapjump.dataset.folder import DatasetFolder
from snapjump.dataset.generate import Generation, generate
from snapjump.dataset.manifest import write_manifest
from snapjump.dataset.read import Dataset, load_dataset
from snapjump.dataset.shard import write_shard
from snapjump.dataset.specification import Specification, specify
from snapjump.declare.outputs import FLAG, INTEGER, NUMBER, WORD
from snapjump.executor.local import LocalExecutor

BACKEND = {"name": "lanes"}
CONFIG: dict[str, Any] = {
    "accuracy": {"name": "draft"},
    "discretization": {"name": "der", "elements": 24},
    "stepping": {"name": "adaptive", "tolerance": 1e-5},
    "contact": {"name": "logbarrier", "distance_m": 1e-3},
    "backend": BACKEND,
}
# Friction with derivatives that are asked for.
WIDE_STICK = {"name": "implicit", "velocity_threshold_m_s": 0.01}
# The same for the command line.
OVERRIDES = (
    "task=dataset", "accuracy=draft", "discretization.elements=24", "stepping.tolerance=1e-5",
    "contact.distance_m=1e-3",
)  # fmt: skip


def small(
    count: int = 24,
    shard_size: int = 8,
    sensitivities: bool = False,
    outputs: Sequence[str] = (),
    **changes: Any,
) -> Specification:
    """The specification of few coarse jumps."""
    plan = {"name": "latin_hypercube", "count": count}
    return specify({**CONFIG, "plan": plan, **changes}, shard_size, sensitivities, outputs)


def generated(
    path: Path, specification: Specification, executor: Any = None, **options: Any
) -> Generation:
    """What becomes of generating a dataset in a folder."""
    folder, executor = DatasetFolder(path), executor or LocalExecutor()
    folder.check(specification)
    locks = folder.claim(options.get("part", 1), options.get("parts", 1))
    progress = options.pop("progress", silent)
    try:
        return generate(folder, specification, executor, BACKEND, progress, **options)
    finally:
        for lock in locks:
            lock.release()


def made_up_rows(specification: Specification, number: int) -> Rows:
    """Numbers that look like those of a shard: a tenth of the designs failed."""
    first, last = specification.stretch(number)
    count = last - first
    random = np.random.default_rng(number)
    rows: dict[str, Any] = {}
    for column in columns_of(specification.axes):
        if column.kind == NUMBER:
            rows[column.name] = random.normal(size=count)
        elif column.kind == INTEGER:
            rows[column.name] = random.integers(0, 1000, count)
        elif column.kind == FLAG:
            rows[column.name] = random.random(count) < 0.9
        elif column.kind == WORD:
            rows[column.name] = np.array(["", "much friction"], object)[
                random.integers(0, 2, count)
            ]
    rows["index"] = np.arange(first, last)
    columns = [axis.column for axis in specification.axes]
    rows |= dict(zip(columns, specification.plan.designs(first, last).T, strict=True))
    failed = np.arange(first, last) % 10 == 3
    rows["status"] = np.where(failed, "step_underflow", "ok").astype(object)
    for name in ("x_bar", "y_bar"):
        rows[name][failed] = np.nan
    return rows


def written(path: Path, specification: Specification, rows_of: Callable[[int], Rows]) -> Any:
    """The folder of a complete dataset with these rows, by the number of their shard."""
    folder = DatasetFolder(path)
    folder.open(specification)
    for number in range(specification.shards):
        write_shard(folder, specification, number, rows_of(number))
    write_manifest(folder, specification)
    return folder


def made_up(path: Path, specification: Specification) -> DatasetFolder:
    """A complete dataset of made-up numbers."""
    return written(path, specification, partial(made_up_rows, specification))


def made_up_dataset(path: Path, specification: Specification) -> Dataset:
    return load_dataset(made_up(path, specification).path)


def smooth_dataset(path: Path, specification: Specification, **columns: Any) -> Dataset:
    """A complete dataset whose apexes (and slopes, if it has sensitivities) follow a smooth law.

    ``columns``: other values of some columns, the same in every row.
    """
    from forward_models import law  # needs torch

    def rows_of(number: int) -> Rows:
        rows = dict(made_up_rows(specification, number))
        apexes, slopes = law(specification.plan.designs(*specification.stretch(number)))
        rows["status"] = np.full(len(apexes), "ok", dtype=object)
        rows |= {"x_bar": apexes[:, 0], "y_bar": apexes[:, 1]}
        for i, apex in enumerate(("x_bar", "y_bar")):
            for j, name in enumerate(slope_columns(apex, specification.axes)):
                known = slopes[:, i, j] if specification.sensitivities else np.nan
                rows[name] = np.full(len(apexes), known)
        for name, value in columns.items():
            rows[name] = np.full(len(apexes), value, rows[name].dtype)
        return rows

    return load_dataset(written(path, specification, rows_of).path)


def silent(share: float, text: str) -> None:
    """No progress is shown."""
