"""The contract of a task: what ``task=<name>`` does with a configuration."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, Protocol

from snapjump.declare.scenes import Progress
from snapjump.files.result_folder import ResultFolder

# Statuses that any task may end in, beside those of its own that name a failure.
OK = "ok"
NO_JUMP = "no_jump"
BAD_INPUT = "bad_input"
INTERRUPTED = "interrupted"
NOT_FINITE = "not_finite"
UNREACHABLE = "unreachable"
ERROR = "error"
# An unreachable target is an answer: no restart of a sweep would find another.
FINISHED = frozenset({OK, NO_JUMP, UNREACHABLE})


@dataclass
class Outcome:
    """The outcome of a task: a status, one line why, and the flat numbers of ``result.json``."""

    status: str
    message: str = ""
    summary: dict[str, Any] = field(default_factory=dict)

    @property
    def finished(self) -> bool:
        return self.status in FINISHED


class Task(Protocol):
    """One instance does one job. ``prepare`` is quick and finds every bad input; ``run`` works."""

    def prepare(self, config: Mapping[str, Any]) -> None:
        """Take the resolved configuration; raises ParameterError before any work is done."""

    def run(self, folder: ResultFolder, progress: Progress) -> Outcome:
        """Work, and leave arrays and figures in the folder; ``result.json`` is the caller's."""

    def report(self, outcome: Outcome) -> list[tuple[str, str]]:
        """The closing block, as (heading, text); the first is the title."""
