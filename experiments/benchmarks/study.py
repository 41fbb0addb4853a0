"""``python run.py task=benchmarks``: numbers of the literature, beside those of this library."""

from collections.abc import Mapping, Sequence
from typing import Any

from snapjump.run.studies.base import Cell, Conclusion, Done, Section, Table

from ..compositions import composed, groups_of
from ..paper.limits import limit_rows
from ..paper.study import duration
from ..paper.words import Words
from ..parted import Parted
from .base import ALL_VERDICTS, LIMITS, Compared, Comparison, Source
from .cascade.part import Cascade
from .cubes.part import Cubes
from .delay.part import Delay
from .rotations.part import Rotations
from .slowing.part import Slowing
from .span.part import Span
from .surface.part import Surface
from .symmetries.part import Symmetries

# In the order of the report; a new one is a folder, with its words.md, an entry in sources.yaml,
# and a name here.
PARTS: dict[str, type[Source]] = {
    part.name: part
    for part in (Symmetries, Surface, Delay, Slowing, Span, Rotations, Cascade, Cubes)
}

WORDS = Words(__file__)
TITLE = "Beside the literature"


class Benchmarks(Parted):
    """A section for each source, and the limits by which they are judged."""

    sources = ("experiments.benchmarks.arches",)
    scene = "jump"

    def plan(self, config: Mapping[str, Any]) -> list[Cell]:
        """The cells of all sources."""
        groups = groups_of(config)
        composed(groups)
        return self.cells_of(PARTS.values(), groups, config["seed"])

    def conclude(self, done: Mapping[str, Done]) -> Conclusion:
        """How many agree, then a section for each source, then the limits."""
        found = self.found(done)
        comparisons = [
            one for part in found.values() if isinstance(part, Compared) for one in part.comparisons
        ]
        read = Section(WORDS("title introduction"), WORDS.paragraphs("introduction"))
        limits = Section(
            "Limits", [], tables={"limits": Table(WORDS("caption limits"), limit_rows(LIMITS))}
        )
        return Conclusion(
            title=TITLE,
            findings=[f"Of {len(comparisons)} rows: {counts(comparisons)}.", duration(done)],
            tables={},
            figures={},
            sections=[read, *(part.section for part in found.values()), limits],
            summary={
                **{f"rows_{v.replace(' ', '_')}": count(comparisons, v) for v in ALL_VERDICTS},
                **{key: value for part in found.values() for key, value in part.summary.items()},
            },
        )


def count(comparisons: Sequence[Comparison], verdict: str) -> int:
    """How many rows have this verdict."""
    return sum(one.verdict == verdict for one in comparisons)


def counts(comparisons: Sequence[Comparison]) -> str:
    """How many rows came to which verdict."""
    return ", ".join(f"{count(comparisons, verdict)} {verdict}" for verdict in ALL_VERDICTS)
