"""Studies of parts: each with cells, sources and words of its own, done again when these change."""

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from typing import Any

from snapjump.files.sources import Source, combined_hash
from snapjump.run.studies.base import Cell, Done, Row
from snapjump.run.studies.fingerprint import sources
from snapjump.run.studies.study import Study

from .paper.base import Found, Part


class Parted(Study):
    """A study that does and concludes its parts one by one.

    Cells name the sources of their own part among their inputs, so that an edited part is done
    again and no other.
    """

    parts: Mapping[str, Part]

    def cells_of(
        self, parts: Iterable[type[Part]], groups: Mapping[str, Any], seed: int
    ) -> list[Cell]:
        """The cells of parts, which the study then consists of, labelled by their names."""
        self.parts = {part.name: part() for part in parts}
        return [
            cell
            for name, part in self.parts.items()
            for cell in labelled(part.plan(groups, seed), name, source_digest(part))
        ]

    def compute(self, cell: Cell) -> list[Row]:
        """The rows of a cell, by its part."""
        return self.parts[cell.inputs["part"]].compute(cell.inputs)

    def found(self, done: Mapping[str, Done]) -> dict[str, Found]:
        """What each part comes to."""
        of: dict[str, dict[str, Done]] = {name: {} for name in self.parts}
        for label, one in done.items():
            name = one.cell.inputs["part"]
            of[name][label.removeprefix(f"{name}: ")] = one
        return {name: part.conclude(of[name]) for name, part in self.parts.items()}


def labelled(cells: Sequence[Cell], part: str, digest: str) -> list[Cell]:
    """A part's cells among those of all parts, with the hash of what computes them."""
    return [
        replace(
            cell,
            name=f"{part}: {cell.name}",
            inputs={**cell.inputs, "part": part, "sources": digest},
        )
        for cell in cells
    ]


# Modules that say what was found, draw it and judge it: no row depends on them, nor on words.md.
TOLD = re.compile(r"experiments\.\w+\.((\w+\.)?(words|figure)|limits)")


def row_sources(part: Part) -> list[Source]:
    """The modules that compute a part, and those that they import."""
    used = sources(part.sources or (type(part).__module__,))
    return [one for one in used if not TOLD.fullmatch(one.name)]


def source_digest(part: Part) -> str:
    """A hash of these."""
    return combined_hash(row_sources(part))[:16]
