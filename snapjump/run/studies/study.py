"""A study as a task: it does the cells that are missing, then concludes from all of them."""

import traceback
from abc import ABC, abstractmethod
from collections import Counter
from collections.abc import Collection, Mapping, Sequence
from pathlib import Path
from typing import Any, ClassVar

from snapjump.checks import ParameterError, check_integer
from snapjump.files.atomic import write_text
from snapjump.files.json_file import finite
from snapjump.files.provenance import now
from snapjump.files.result_folder import ResultFolder
from snapjump.files.sealed import sha256_of
from snapjump.run.studies import base
from snapjump.run.studies.base import Cell, Conclusion, Done, Row
from snapjump.run.studies.children import children
from snapjump.run.studies.fingerprint import fingerprint
from snapjump.run.studies.report import write_report
from snapjump.run.studies.store import CellStore
from snapjump.run.tasks.base import OK, Outcome, Progress, Task
from snapjump.tracking.parts.tracked import write_children

# Relative to where the command is run, like the folders of all results.
STORE = Path("outputs/studies")
CELLS_FAILED = "cells_failed"


class Study(Task, ABC):
    """Base of all studies. A study plans cells, computes one, and concludes from all.

    ``sources``: the modules that a cell's rows depend on, if not just the study's own; when one
    of them changes, or a module of the experiments that it imports, cells are done again.
    ``choices``: keys of the configuration that only choose among cells: runs with others share what
    is finished; ``scene``: the only one that the study is of, if there is one.
    """

    sources: ClassVar[tuple[str, ...]] = ()
    choices: ClassVar[tuple[str, ...]] = ()
    scene: ClassVar[str] = ""

    def __init__(self) -> None:
        self.config: Mapping[str, Any] = {}
        self.cells: Sequence[Cell] = ()
        self._told: list[tuple[str, str]] = []

    @abstractmethod
    def plan(self, config: Mapping[str, Any]) -> Sequence[Cell]:
        """All cells, in the order in which they are done; raises ParameterError for bad input."""

    @abstractmethod
    def compute(self, cell: Cell) -> list[Row]:
        """The rows of one cell; raises ParameterError for what cannot be composed."""

    @abstractmethod
    def conclude(self, done: Mapping[str, Done]) -> Conclusion:
        """Tables, figures and findings from all cells by name, in their order."""

    @property
    def full(self) -> bool:
        """Whether hours may be spent."""
        return bool(self.config["effort"] == "full")

    def prepare(self, config: Mapping[str, Any]) -> None:
        """Check everything, and plan the cells."""
        self.config = config
        task = config["task"]
        for key in self.options:
            if key not in task:
                raise ParameterError(f"task.{key}", None, "a value, which cannot be left out")
        if self.scene and config["sim"]["name"] != self.scene:
            allowed = f"{self.scene} with task={task['name']}"
            raise ParameterError("sim", config["sim"]["name"], allowed)
        self.cells = self.plan(config)
        assert len({cell.name for cell in self.cells}) == len(self.cells), "cells share a name"

    def count(self, key: str, defaults: tuple[int, int], low: int, high: int) -> int:
        """An integer of the task's, in [low, high]; where none is given, the default of the effort,
        (quick, full). Raises ParameterError."""
        given = self.config["task"][key]
        chosen: int = defaults[self.full] if given is None else given
        check_integer(f"task.{key}", chosen, low, high)
        return chosen

    def run(self, folder: ResultFolder, progress: Progress) -> Outcome:
        """Do what is missing, conclude, and leave tables, figures, report and records of cells."""
        name = str(self.config["task"]["name"])
        roots = self.sources or (type(self).__module__,)
        done: dict[str, Done] = {}
        failures: list[str] = []
        determining = {k: value for k, value in self.config.items() if k not in self.choices}
        place = f"{name}-{fingerprint(determining, roots)}"
        with CellStore(STORE / place) as store:
            for k, cell in enumerate(self.cells):
                progress(k / len(self.cells), cell.name)
                kept = store.load(cell)
                done[cell.name] = kept or store.save(self._attempt(cell, folder, failures))
        if failures:
            write_text(folder.path / "failures.txt", "\n".join(failures))
        progress(1.0, "drawing")
        conclusion = self.conclude(done)
        write_report(folder, conclusion, bool(self.config["figures"]))
        write_children(folder, children(done.values(), conclusion.metrics))
        counts = {"cells": len(done), **_counts(done.values(), folder.path.name)}
        words = [f"{n} {word.removeprefix('cells_')}" for word, n in counts.items() if n]
        self._told = [
            (name, conclusion.title),
            ("cells", ", ".join(words).replace("cells", "in all")),
            *[("finding" if k == 0 else "", text) for k, text in enumerate(conclusion.findings)],
        ]
        # An order that cannot be observed is no failure of the study.
        summary, _ = finite({**conclusion.summary, **counts})
        if failures:
            return Outcome(CELLS_FAILED, f"{len(failures)} cells: see failures.txt", summary)
        return Outcome(OK, "", summary)

    def report(self, outcome: Outcome) -> list[tuple[str, str]]:
        return self._told

    def reads(self, config: Mapping[str, Any]) -> dict[str, str]:
        """Cells say what they read, files included."""
        if not self.cells:
            self.prepare(config)
        inputs, _ = finite([cell.inputs for cell in self.cells])
        return {"cells": sha256_of(inputs)}

    def _attempt(self, cell: Cell, folder: ResultFolder, failures: list[str]) -> Done:
        started_at = now()
        rows: list[Row] = []
        status, message = base.OK, ""
        try:
            rows = list(self.compute(cell))
        except ParameterError as error:
            status, message = base.REFUSED, str(error)
        except Exception as error:
            status, message = base.FAILED, f"{type(error).__name__}: {error}"
            failures.append(f"{cell.name}\n{traceback.format_exc()}")
        return Done(cell, status, message, rows, folder.path.name, started_at, now())


def _counts(done: Collection[Done], run: str) -> dict[str, int]:
    """Counts of cells by status, and of those that had been done by an earlier run."""
    counts = Counter(one.status for one in done)
    found = {f"cells_{status}": counts[status] for status in (base.OK, base.REFUSED, base.FAILED)}
    return {**found, "cells_kept": sum(one.run != run for one in done)}
