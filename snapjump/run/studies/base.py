"""Parts of a study: named cells, their rows, tables, figures and the conclusion."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

Row = dict[str, Any]

OK = "ok"
REFUSED = "refused"  # the composition makes no sense, and says why: a result as good as any
FAILED = "failed"  # a defect: done again when the study is started again


@dataclass(frozen=True)
class Cell:
    """One computation: ``inputs`` are plain JSON values, and all that it depends on."""

    name: str
    inputs: Mapping[str, Any]


@dataclass(frozen=True)
class Done:
    """A finished cell: its table of rows, null where a number is not finite.
    ``run``: the run that did it; ``started_at``, ``finished_at``: UTC, ISO 8601."""

    cell: Cell
    status: str
    message: str
    rows: list[Row]
    run: str
    started_at: str
    finished_at: str

    def column(self, key: str) -> NDArray[np.float64]:
        """A column of numbers, NaN where there is none."""
        return column(self.rows, key)


def column(rows: Sequence[Row], key: str) -> NDArray[np.float64]:
    """A column of some rows, NaN where there is no number."""
    values = [row.get(key) for row in rows]
    return np.array([np.nan if value is None else float(value) for value in values])


@dataclass(frozen=True)
class Table:
    """Rows under a caption; units stand in the keys of the rows.
    ``digits``: significant digits for reading, by column, where four are not right."""

    caption: str
    rows: Sequence[Row]
    digits: Mapping[str, int] = field(default_factory=dict)

    @property
    def header(self) -> list[str]:
        return list(dict.fromkeys(key for row in self.rows for key in row))


@dataclass(frozen=True)
class Figure:
    """A caption, and what draws the picture into a PNG file of that path."""

    caption: str
    draw: Callable[[Path], Any]


@dataclass(frozen=True)
class Section:
    """A part of a long report under its own heading: paragraphs, then figures, then tables."""

    title: str
    paragraphs: Sequence[str]
    figures: Mapping[str, Figure] = field(default_factory=dict)
    tables: Mapping[str, Table] = field(default_factory=dict)


@dataclass(frozen=True)
class Conclusion:
    """The results of a study: findings, tables and figures.

    ``summary``: flat numbers for result.json; ``findings``: sentences; ``metrics``: further
    numbers of single cells, for their records; ``blocks``: Markdown that replaces what stands
    between ``<!-- name:begin -->`` and ``<!-- name:end -->`` in README.md or docs/*.md when it is
    published; ``sections``: what follows in the report, where no name of a figure or a table may
    be used twice.
    """

    title: str
    findings: Sequence[str]
    tables: Mapping[str, Table]
    figures: Mapping[str, Figure]
    summary: Mapping[str, Any] = field(default_factory=dict)
    metrics: Mapping[str, Mapping[str, float]] = field(default_factory=dict)
    blocks: Mapping[str, str] = field(default_factory=dict)
    sections: Sequence[Section] = ()
