"""A part of the paper that is done again, its statements, and what became of them."""

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, ClassVar, NamedTuple

from snapjump.engine import status
from snapjump.run.studies.base import OK, Cell, Done, Row, Section

CONFIRMED = "confirmed"
LIMITED = "confirmed within a limit"
NOT_CONFIRMED = "not confirmed"
VERDICTS = (CONFIRMED, LIMITED, NOT_CONFIRMED)


class Statement(NamedTuple):
    """``key``: ``<part>.<name>``, as in the table of limits; ``says``: what the paper says, in our
    words; ``verdict``: one of VERDICTS, decided from the numbers by the part that tests it;
    ``found``: the numbers, as a sentence, with the limit if there is one, and with what the paper's
    own settings give where that differs, and why; ``accuracy``: the tiers, and how far off they
    are."""

    key: str
    says: str
    verdict: str
    found: str
    accuracy: str

    @property
    def command(self) -> str:
        """What regenerates it."""
        return f"`python run.py task=paper figure={self.key.split('.')[0]}`"


def verdict(holds: bool, within_limit: bool = False) -> str:
    """The verdict on a statement that holds throughout, or else within a limit that is told."""
    return CONFIRMED if holds else LIMITED if within_limit else NOT_CONFIRMED


def weakest(*verdicts: str) -> str:
    """Of a statement with several aspects: confirmed if all are, within a limit if none fails."""
    return max(verdicts, key=VERDICTS.index)


def percent(share: float) -> str:
    """A share for reading."""
    return f"{100.0 * share:.2g} %"


def listed(values: Iterable[float], how: str = "g") -> str:
    """Numbers in a sentence."""
    return ", ".join(f"{value:{how}}" for value in values)


def span(values: Iterable[float]) -> tuple[float, float]:
    """The least and the largest."""
    all_of_them = [*values]
    return min(all_of_them), max(all_of_them)


def statement_rows(statements: Sequence[Statement]) -> list[Row]:
    """The table of statements, numbered in their order."""
    return [
        {
            "no.": k,
            "the paper says": statement.says.rstrip("."),
            "verdict": f"**{statement.verdict}**",
            "what we find": statement.found[:1].upper() + statement.found[1:],
            "tested at": statement.accuracy,
            "command": statement.command,
        }
        for k, statement in enumerate(statements, 1)
    ]


def prose(text: str) -> str:
    """A paragraph that is written over several lines, as one."""
    return " ".join(text.split())


def paragraphs(text: str) -> list[str]:
    """Paragraphs, between which there are empty lines."""
    return [prose(one) for one in text.split("\n\n") if one.strip()]


# Of jumps that ended as jumps do.
FINE = status.NAMES[status.OK], status.NAMES[status.NO_JUMP]


def failed(rows: Sequence[Row]) -> list[Row]:
    """Jumps that did not end as jumps do, which have no numbers; what has no status is none."""
    return [row for row in rows if row.get("status", FINE[0]) not in FINE]


@dataclass(frozen=True)
class Found:
    """What a part comes to: its section of the report, its statements with their verdicts, and
    flat numbers for result.json (keys in snake_case with units)."""

    section: Section
    statements: Sequence[Statement]
    summary: Mapping[str, Any] = field(default_factory=dict)


class Part(ABC):
    """Base of all parts. ``name``: as in ``figure=<name>``; ``title``: of its section; ``kinds``:
    what computes the rows of a cell, by the ``kind`` among its inputs; ``every_jump``: its
    statements need all of a sweep; ``sources``: the modules that rows depend on, if not its own."""

    name: ClassVar[str]
    title: ClassVar[str] = ""
    kinds: ClassVar[Mapping[str, Callable[[Mapping[str, Any]], list[Row]]]] = {}
    every_jump: ClassVar[bool] = False
    sources: ClassVar[tuple[str, ...]] = ()

    @abstractmethod
    def plan(self, groups: Mapping[str, Any], seed: int) -> Sequence[Cell]:
        """All cells. ``groups``: ``accuracy=standard`` as plain groups
        (:func:`experiments.compositions.composed` builds it), with the run's backend."""

    def compute(self, inputs: Mapping[str, Any]) -> list[Row]:
        """The rows of a cell with these inputs; raises ParameterError for what is refused."""
        return self.kinds[inputs["kind"]](inputs)

    def conclude(self, done: Mapping[str, Done]) -> Found:
        """The section and the verdicts, from all cells by the names that ``plan`` gave them; no
        verdicts if cells failed, which are then named."""
        return unfinished(self.title, done, self.every_jump) or self.judge(done)

    def judge(self, done: Mapping[str, Done]) -> Found:
        """The same of cells that all have their rows."""
        raise NotImplementedError


def unfinished(title: str, done: Mapping[str, Done], jumps: bool = False) -> Found | None:
    """A section that names the cells without rows, and why; None if there are none.

    jumps: so do cells in which a jump failed, for statements that need all of a sweep.
    """
    told = [f"{name} ({one.status}: {one.message})" for name, one in done.items()
            if one.status != OK]  # fmt: skip
    if jumps:
        told += [incomplete(name, one) for name, one in done.items() if failed(one.rows)]
    if not told:
        return None
    return Found(Section(title, [f"Not judged, for want of these cells: {'; '.join(told)}."]), [])


def incomplete(name: str, one: Done) -> str:
    """A cell with failed jumps, for reading."""
    lost = failed(one.rows)
    reasons = ", ".join(sorted({row["status"] for row in lost}))
    return f"{name} ({len(lost)} of {len(one.rows)} jumps failed: {reasons})"
