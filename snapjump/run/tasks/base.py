"""The contract of a task (``task=<name>``), its statuses and their exit codes."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, ClassVar

from snapjump.declare.families import FAMILIES
from snapjump.declare.scenes import Progress
from snapjump.files.result_folder import ResultFolder
from snapjump.files.sealed import file_sha256

# What a simulation is made of.
SIMULATION = ("accuracy", "robot", "design", "environment", *FAMILIES)
# Statuses that any task may end in, beside those of its own that name a failure.
OK = "ok"
NO_JUMP = "no_jump"
BAD_INPUT = "bad_input"
INTERRUPTED = "interrupted"
NOT_FINITE = "not_finite"
UNREACHABLE = "unreachable"
NOT_REACHED = "not_reached"
ERROR = "error"
# A target that is not reached is an answer: no restart of a sweep would find another.
FINISHED = frozenset({OK, NO_JUMP, UNREACHABLE, NOT_REACHED})

EXIT_OK = 0
EXIT_ERROR = 1
EXIT_BAD_INPUT = 2
EXIT_FAILED = 3
EXIT_UNREACHABLE = 4
EXIT_UNTRACKED = 5
EXIT_INTERRUPTED = 130


@dataclass
class Outcome:
    """The outcome of a task: a status, one line why, and the flat numbers of ``result.json``."""

    status: str
    message: str = ""
    summary: dict[str, Any] = field(default_factory=dict)

    @property
    def finished(self) -> bool:
        return self.status in FINISHED


class Task:
    """One instance does one job. ``prepare`` is quick and finds every bad input; ``run`` works.

    ``keys``: the groups and keys of the configuration that it reads, beside those of every run;
    ``options``: the keys of its ``conf/task/<name>.yaml`` beside ``name``. ``step``, which is set
    before ``run``, may be told numbers of a step of the work, its number first: they are recorded
    as it goes.
    """

    keys: ClassVar[tuple[str, ...]] = SIMULATION
    options: ClassVar[tuple[str, ...]] = ()
    step: Callable[[Mapping[str, float]], None] = staticmethod(lambda row: None)

    def prepare(self, config: Mapping[str, Any]) -> None:
        """Take the resolved configuration; raises ParameterError before any work is done."""
        raise NotImplementedError

    def run(self, folder: ResultFolder, progress: Progress) -> Outcome:
        """Work, and leave arrays and figures in the folder; ``result.json`` is the caller's."""
        raise NotImplementedError

    def report(self, outcome: Outcome) -> list[tuple[str, str]]:
        """The closing block, as (heading, text); the first is the title."""
        raise NotImplementedError

    def reads(self, config: Mapping[str, Any]) -> dict[str, str]:
        """Digests of what the job reads beside its configuration, by key, as that is now.
        Asked before ``prepare`` too; raises ParameterError for what cannot be read."""
        table = (config.get("drive") or {}).get("file")
        return {"drive.file": file_sha256(Path(table))} if isinstance(table, str) else {}

    def leaves(self, config: Mapping[str, Any]) -> dict[str, str]:
        """Digests of what the job has left outside its folder, by key, as that is now."""
        return {}


def stretch(progress: Progress, begin: float, end: float) -> Progress:
    """The progress of a stretch of the work, from one share of it to another."""
    return lambda done, text: progress(begin + (end - begin) * done, text)


def exit_code(status: str) -> int:
    """The exit code of one job."""
    special = {
        BAD_INPUT: EXIT_BAD_INPUT,
        ERROR: EXIT_ERROR,
        INTERRUPTED: EXIT_INTERRUPTED,
        UNREACHABLE: EXIT_UNREACHABLE,
        NOT_REACHED: EXIT_UNREACHABLE,
    }
    return special.get(status, EXIT_OK if status in FINISHED else EXIT_FAILED)


def sweep_exit_code(statuses: Sequence[str]) -> int:
    """The exit code of a sweep: a cell that failed counts before one that had bad input."""
    if all(status in FINISHED for status in statuses):
        return EXIT_OK
    bad = {status for status in statuses if status not in FINISHED}
    return EXIT_BAD_INPUT if bad == {BAD_INPUT} else EXIT_FAILED
