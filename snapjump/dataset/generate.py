"""Generating a dataset: what is missing or damaged, on an executor, until all of it is there."""

import time
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from snapjump.batch.progress import BatchProgress
from snapjump.dataset.folder import DatasetFolder
from snapjump.dataset.manifest import Manifest, write_manifest
from snapjump.dataset.shard import read_entry
from snapjump.dataset.specification import Specification
from snapjump.dataset.work import job_of, make_shard
from snapjump.declare.scenes import Progress
from snapjump.executor.base import Executor

ROUNDS = 3  # a shard may be spoilt by a worker that was given up too early


class GenerationError(RuntimeError):
    """Shards that are damaged as often as they are written."""


@dataclass
class Generation:
    """The outcome of a run. ``made``: new rows, in ``seconds`` on ``cores``; ``damaged``: what was
    wrong with shards that were there, and have been made again; ``manifest`` at its end."""

    kept: int = 0
    made: int = 0
    seconds: float = 0.0
    cores: int = 1
    damaged: list[str] = field(default_factory=list)
    manifest: Manifest = field(default_factory=dict)


def generate(
    folder: DatasetFolder,
    specification: Specification,
    executor: Executor,
    backend: Mapping[str, Any],
    progress: Progress,
    part: int = 1,
    parts: int = 1,
) -> Generation:
    """Make the shards of a part that are missing or damaged; the caller has claimed the folder.
    Whatever stops it, shards that are done stay, and the manifest lists them."""
    folder.open(specification)
    numbers = list(range(part - 1, specification.shards, parts))
    folder.sweep(numbers)
    generation = Generation()
    try:
        missing = look(folder, specification, numbers, generation.damaged)
        generation.kept = rows_of(specification, set(numbers) - set(missing))
        if missing:
            with executor:
                maker = _Maker(folder, specification, executor, backend, progress, generation)
                maker.make_all(missing)
            folder.sweep(numbers)  # of workers that were killed
    finally:
        generation.manifest = write_manifest(folder, specification)
    return generation


def look(
    folder: DatasetFolder, specification: Specification, numbers: list[int], damaged: list[str]
) -> list[int]:
    """The shards that are missing or damaged; adds the damage to ``damaged``."""
    missing = []
    for number in numbers:
        entry, reason = read_entry(folder, number, specification.sha256)
        if entry is None:
            missing.append(number)
        if reason:
            damaged.append(reason)
    return missing


def rows_of(specification: Specification, numbers: set[int]) -> int:
    """Rows of these shards."""
    stretches = [specification.stretch(number) for number in numbers]
    return sum(last - first for first, last in stretches)


@dataclass
class _Maker:
    """Makes shards with an executor that has been claimed, and counts rows and time."""

    folder: DatasetFolder
    specification: Specification
    executor: Executor
    backend: Mapping[str, Any]
    progress: Progress
    generation: Generation

    def __post_init__(self) -> None:
        if self.backend["name"] == "lanes" and self.backend.get("threads") is None:
            self.backend = {**self.backend, "threads": self.executor.threads}
        threads = self.backend.get("threads") or self.executor.cores
        self.generation.cores = min(self.executor.cores, self.executor.at_once * threads)

    def make_all(self, missing: list[int]) -> None:
        """Make shards until all of them are whole."""
        for _ in range(ROUNDS):
            self._make(missing)
            missing = look(self.folder, self.specification, missing, [])
            if not missing:
                return
        raise GenerationError(f"shards {missing} are damaged whenever they are written")

    def _make(self, missing: list[int]) -> None:
        kept, specification = self.generation.kept, self.specification
        total = kept + rows_of(specification, set(missing))
        told = BatchProgress(total, self.progress, done=kept)
        jobs = [job_of(self.folder, specification, self.backend, number) for number in missing]
        begun = time.perf_counter()
        try:
            under_way = told.jumps(specification.shard_size)
            answers = self.executor.answers(make_shard, jobs, under_way)
            told.show()
            for entry in answers:
                self.generation.made += entry["rows"]
                told.finish(entry["rows"])
                told.show()
        finally:
            self.generation.seconds += time.perf_counter() - begun
