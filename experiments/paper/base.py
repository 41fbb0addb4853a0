"""A part of the paper that is done again: one figure or several, and what they are to show."""

from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, ClassVar

from experiments.paper.statement import Statement
from snapjump.studies.base import Cell, Done, Row, Section


@dataclass(frozen=True)
class Found:
    """What a part comes to: its section of the report, its statements with their verdicts, and
    flat numbers for result.json (keys in snake_case with units)."""

    section: Section
    statements: Sequence[Statement]
    summary: Mapping[str, Any] = field(default_factory=dict)


class Part(ABC):
    """Base of all parts. ``name``: as in ``figure=<name>``; ``sources``: the modules that the rows
    of its cells depend on, which does not include those that draw or judge."""

    name: ClassVar[str]
    sources: ClassVar[tuple[str, ...]]

    @abstractmethod
    def plan(self, groups: Mapping[str, Any], seed: int) -> Sequence[Cell]:
        """All cells. ``groups``: ``accuracy=standard`` as plain groups
        (:func:`experiments.compositions.composed` builds it), with the run's backend."""

    @abstractmethod
    def compute(self, inputs: Mapping[str, Any]) -> list[Row]:
        """The rows of a cell with these inputs; raises ParameterError for what is refused."""

    @abstractmethod
    def conclude(self, done: Mapping[str, Done]) -> Found:
        """The section and the verdicts, from all cells by the names that ``plan`` gave them.

        Cells that failed are there too, with their status and without rows."""
