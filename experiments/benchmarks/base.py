"""Comparisons with the literature: quantities, ours and theirs, and what became of them."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType
from typing import Any, NamedTuple

import yaml

from snapjump.run.studies.base import Row, Section

from ..paper.base import VERDICTS, Found, Part, prose, weakest
from ..paper.limits import read_limits, verdict_by
from ..paper.words import Words

INCOMPARABLE = "not comparable"
ALL_VERDICTS = (*VERDICTS, INCOMPARABLE)
UNREADABLE = "not readable"
LIMITS = read_limits(__file__)


class Number(NamedTuple):
    """A number of a source, None where it cannot be read, and where it stands, or why not;
    ``says``: what the source says in words instead."""

    value: float | None
    place: str
    says: str = ""

    def __str__(self) -> str:
        return self.says or (UNREADABLE if self.value is None else f"{self.value:.7g}")


class Literature(NamedTuple):
    """A source: ``title`` of its section, ``reference`` and ``link``; ``read``: how much of it
    could be; ``numbers`` by name."""

    title: str
    reference: str
    link: str
    read: str
    numbers: Mapping[str, Number]


def read_sources(file: Path) -> dict[str, Literature]:
    """All sources, by the part that compares with them."""
    rows = yaml.safe_load(file.read_text(encoding="utf-8"))
    return {
        name: Literature(**{**row, "numbers": {k: Number(**n) for k, n in row["numbers"].items()}})
        for name, row in rows.items()
    }


SOURCES = read_sources(Path(__file__).with_name("sources.yaml"))


class Comparison(NamedTuple):
    """``key``: ``<part>.<name>``, as in the table of limits; ``what``: the quantity, with its unit;
    ``ours``; ``theirs``: a number of the source; ``difference``, in words; ``verdict``: one of
    ALL_VERDICTS; ``remark``: what it is of, or what cannot be compared and why."""

    key: str
    what: str
    ours: str
    theirs: Number
    difference: str
    verdict: str
    remark: str

    def row(self) -> Row:
        """A line of the section's table."""
        return {
            "quantity": self.what,
            "ours": self.ours,
            "theirs": str(self.theirs),
            "difference": self.difference,
            "verdict": f"**{self.verdict}**",
            "remark": self.remark,
            "where theirs stands": self.theirs.place,
        }


@dataclass(frozen=True)
class Compared(Found):
    """What a source comes to; the paper's statements are none of it."""

    comparisons: Sequence[Comparison] = ()


class Source(Part):
    """Base of the parts, each of one source, or of a few that are compared alike; ``words``: its
    words.md, which has ``# <name>: what`` and ``# <name>: remark`` for each comparison."""

    words: Words

    @property
    def literature(self) -> Literature:
        """What it is compared with."""
        return SOURCES[self.name]

    def number(self, name: str) -> float:
        """A number of the source that can be read."""
        value = self.literature.numbers[name].value
        assert value is not None, f"{self.name}.{name} cannot be read"
        return value

    def compared(
        self,
        name: str,
        ours: str,
        difference: str,
        verdict: str,
        theirs: str | Number = "",
        **values: Any,
    ) -> Comparison:
        """A comparison; ``theirs``: the source's number, or its name if that is another; ``values``
        fill its words."""
        what, remark = (self.words(f"{name}: {word}", **values) for word in ("what", "remark"))
        number = self.literature.numbers[theirs or name] if isinstance(theirs, str) else theirs
        return Comparison(f"{self.name}.{name}", what, ours, number, difference, verdict, remark)

    def told(self, name: str, ours: str, theirs: str = "", **values: Any) -> Comparison:
        """A row that cannot be compared; its remark says why."""
        return self.compared(name, ours, "", INCOMPARABLE, theirs, **values)

    def by_limit(self, limit: str, *values: float) -> str:
        """The verdict by one of this part's limits."""
        return verdict_by(LIMITS[f"{self.name}.{limit}"], *values)

    def weakest_of(self, *measured: tuple[str, float]) -> str:
        """The verdict by several limits, each with what is measured."""
        return weakest(*(self.by_limit(limit, value) for limit, value in measured))

    def section(
        self,
        comparisons: Sequence[Comparison],
        figures: Mapping[str, Callable[[Path], Any]] = MappingProxyType({}),
        tables: Mapping[str, Sequence[Row]] = MappingProxyType({}),
        digits: Mapping[str, Mapping[str, int]] = MappingProxyType({}),
        **values: Any,
    ) -> Section:
        """The source, what could be read of it, the comparisons, and what they are drawn from."""
        own = self.literature
        name = f"{self.name}_comparisons"
        section = self.words.section(
            own.title,
            figures,
            {name: [one.row() for one in comparisons], **tables},
            digits,
            **values,
        )
        cited = f"{own.reference} <{own.link}>. What could be read of it: {prose(own.read)}"
        return Section(own.title, [cited, *section.paragraphs], section.figures, section.tables)


def percent_off(ours: float, theirs: float) -> float:
    """The difference (% of theirs), without its sign."""
    return 100.0 * abs(ours / theirs - 1.0)
