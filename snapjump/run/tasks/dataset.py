"""``task=dataset``: all jumps of a plan, in a folder that is continued where it was left."""

import os
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from snapjump.checks import ParameterError
from snapjump.dataset.folder import DatasetFolder, default_path
from snapjump.dataset.generate import Generation, generate
from snapjump.dataset.options import SharedDataset
from snapjump.dataset.read import load_dataset
from snapjump.dataset.shard import read_entry
from snapjump.dataset.specification import specify
from snapjump.dataset.statistics import gather
from snapjump.declare.members import make_member
from snapjump.executor.base import Executor
from snapjump.files.result_folder import ResultFolder
from snapjump.files.sealed import sha256_of
from snapjump.plan.parts.axes import Axis
from snapjump.run.tasks.base import INTERRUPTED, OK, SIMULATION, Outcome, Progress, Task, stretch
from snapjump.run.tasks.complete import check_complete, warn, warn_of_unusual, whole
from snapjump.run.tasks.names import given_overrides
from snapjump.scenes.sensitivities import unresolved
from snapjump.show.plots.dataset import draw_dataset, draw_status
from snapjump.show.terminal.block import number
from snapjump.tracking.base import DatasetUse
from snapjump.tracking.parts.tracked import write_datasets

OF_THIS_RUN = ("made", "kept")  # rows, whatever their status
# Share of the progress bar for the jumps; the rest is for reading them again and drawing.
GENERATION_SHARE = 0.95


class GenerateDataset(Task):
    """Generates what is missing, then looks at all of it."""

    keys = (*SIMULATION, "dataset", "plan", "executor")

    _damaged: Sequence[str] = ()

    def prepare(self, config: Mapping[str, Any]) -> None:
        self._config = config
        self._options: SharedDataset = whole(SharedDataset, config.get("dataset"))
        self._specification = specify(config, *self._options.contents)
        check_complete(config, self._specification.simulation)
        warn_of_unusual(self._specification.simulation)
        if self._options.sensitivities:
            warn(unresolved(self._specification.simulation))
        check_fixed(self._specification.axes, given_overrides())
        self._executor: Executor = make_member("executor", config.get("executor")).executor()
        self._executor.check()
        path = self._options.path or default_path(self._specification)
        self._folder = DatasetFolder(Path(path))
        self._folder.check(self._specification)
        try:
            self._locks = self._folder.claim(self._options.part, self._options.parts)
        except OSError as error:
            allowed = f"a folder that can be written to ({error.strerror})"
            raise self._folder.refused(allowed) from error

    def run(self, folder: ResultFolder, progress: Progress) -> Outcome:
        shown = GENERATION_SHARE if self._config["figures"] else 1.0
        try:
            work = self._folder, self._specification, self._executor, self._config["backend"]
            part = self._options.part, self._options.parts
            generation = generate(*work, stretch(progress, 0.0, shown), *part)
        finally:
            for lock in self._locks:
                lock.release()
        self._damaged = generation.damaged
        for damage in generation.damaged:
            print(f"made again: {damage}", file=sys.stderr)
        if generation.manifest["complete"]:
            progress(shown, "looking at all of it")
            self._conclude(folder, generation)
        return Outcome(OK, "", summary(self._folder, generation))

    def report(self, outcome: Outcome) -> list[tuple[str, str]]:
        found, made_of, place = outcome.summary, self._specification, self._folder.path
        title = f"{self._config['plan']['name']}, {made_of.plan.count:,} jumps at "
        lines = [("dataset", title + str(made_of.simulation.accuracy))]
        if outcome.status == INTERRUPTED:
            again = f"the same command continues what is in {os.path.relpath(place)}"
            return [*lines, ("stopped", again)]
        if "rows" not in found:
            return lines
        counts = {k[5:]: n for k, n in found.items() if k.startswith("rows_") and n}
        told = [f"{n:,} {status}" for status, n in counts.items() if status not in OF_THIS_RUN]
        rate = found["jumps_per_second"]
        speed = f"{number(rate)} jumps/s, {number(found['jumps_per_second_core'])} a core"
        return [
            *lines,
            ("status", ", ".join(told)),
            ("made", f"{found['rows_made']:,} now, {found['rows_kept']:,} before"),
            ("damaged", "; ".join(self._damaged)),
            ("speed", speed if rate else ""),
            ("hash", str(found["dataset_sha256"] or "not before all parts are done")),
            ("dataset in", os.path.relpath(place)),
        ]

    def leaves(self, config: Mapping[str, Any]) -> dict[str, str]:
        options: SharedDataset = whole(SharedDataset, config.get("dataset"))
        made_of = specify(config, *options.contents)
        folder = DatasetFolder(Path(options.path or default_path(made_of)))
        numbers = range(options.part - 1, made_of.shards, options.parts)
        entries = [read_entry(folder, number, made_of.sha256)[0] for number in numbers]
        contents = [entry and entry["content_sha256"] for entry in entries]
        return {"dataset.path": sha256_of([folder.manifest.exists(), *contents])}

    def _conclude(self, folder: ResultFolder, generation: Generation) -> None:
        """Figures of the whole dataset, and what its record names."""
        dataset = load_dataset(self._folder.path)
        plan = self._config["plan"]["name"]
        name = f"{plan}-{self._specification.simulation.accuracy}"
        use = DatasetUse(name, dataset.sha256, str(self._folder.path), dataset.rows, "generated")
        write_datasets(folder, [use])
        if not self._config["figures"]:
            return
        statistics = gather(dataset)
        tier = self._specification.simulation.accuracy
        title = f"{dataset.rows:,} jumps at {tier}, plan {plan}, dataset {dataset.sha256[:8]}"

        def draw(path: Path) -> None:
            draw_dataset(statistics, title, path / "dataset.png")
            draw_status(statistics, dataset.statuses, title, path / "status.png")

        folder.write_figures(draw)


def check_fixed(axes: Sequence[Axis], overrides: Sequence[str]) -> None:
    """Raise ParameterError for the value of an input that varies."""
    for text in overrides:
        path, _, value = text.lstrip("+~").partition("=")
        for axis in axes:
            if path == axis.path:
                low, high = axis.range
                allowed = f"left out: plan.inputs has it vary over [{low:g}, {high:g}]"

                raise ParameterError(path, value, allowed)


def summary(folder: DatasetFolder, generation: Generation) -> dict[str, Any]:
    """The flat numbers of result.json; speeds are of what this run made, null if nothing."""
    manifest = generation.manifest
    rate = generation.made / generation.seconds if generation.made else None
    return {
        "dataset_path": str(folder.path),
        **{key: manifest[key] for key in ("dataset_sha256", "complete", "designs", "rows")},
        **{f"rows_{status}": count for status, count in manifest["statuses"].items()},
        "rows_made": generation.made,
        "rows_kept": generation.kept,
        "shards": len(manifest["shards"]),
        "shards_damaged": len(generation.damaged),
        "generation_seconds": generation.seconds,
        "cores": generation.cores,
        "jumps_per_second": rate,
        "jumps_per_second_core": None if rate is None else rate / generation.cores,
    }
