"""Outputs of a scene: figures whose name, unit, meaning and reader are declared once.

An output is a method of its scene's :class:`Outputs` that :func:`output` decorates. Its name is the
output's name in every file, its docstring the meaning, and what it returns the figure. From there
take it ``result.json``, ``Batch``, datasets, the closing block, MLflow and the table of the docs.
"""

from collections.abc import Callable
from functools import cached_property, wraps
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

T = TypeVar("T")
NUMBER, INTEGER, FLAG, WORD = "number", "integer", "flag", "word"
# A flag may be None: not known.
TYPES: dict[str, Any] = {NUMBER: np.float64, INTEGER: np.int64, FLAG: object, WORD: object}


class Output(cached_property[T]):
    """A declared figure: read at first use, then kept as an attribute.

    ``unit``: 1 without a dimension, empty for words and flags; ``kind``: NUMBER, INTEGER, FLAG or
    WORD; ``of``: the statuses that have it, empty for all; ``timing``: differs from run to run;
    ``unknown``: NaN says that it is not known, and not that anything went wrong; ``reads``: what
    must have been recorded of the march, without which there is no such figure;
    ``show``: heading and text of its place in the closing block, empty to leave it out.
    """

    def __init__(
        self,
        read: Callable[[Any], T],
        unit: str,
        kind: str,
        of: tuple[str, ...],
        timing: bool,
        unknown: bool,
        reads: tuple[str, ...],
        show: str | None,
    ):
        super().__init__(known_of(of, read) if of else read)
        self.name = read.__name__
        self.meaning = " ".join((read.__doc__ or "").split()).rstrip(".")
        self.unit, self.kind, self.of, self.timing = unit, kind, of, timing
        self.unknown, self.reads = unknown, reads
        self.show = f"{self.name}: {{}}" if show is None else show


def output(
    unit: str = "",
    *,
    kind: str = NUMBER,
    of: tuple[str, ...] = (),
    timing: bool = False,
    unknown: bool = False,
    reads: tuple[str, ...] = (),
    show: str | None = None,
) -> Callable[[Callable[[Any], T]], Output[T]]:
    """Declare a method to be an output; without ``show`` its name is its heading."""
    return lambda read: Output(read, unit, kind, of, timing, unknown, reads, show)


def known_of(statuses: tuple[str, ...], read: Callable[[Any], Any]) -> Callable[[Any], Any]:
    """A reader that gives NaN for any other status."""

    @wraps(read)
    def masked(found: "Outputs") -> Any:
        known = found.ended_as(statuses)
        if not known.any():  # there may be nothing to read
            return np.full(known.shape, np.nan)
        return np.where(known, read(found), np.nan)

    return masked


class Outputs:
    """Outputs of simulations of a scene; a figure has an item for each of them, or is one."""

    def statuses(self) -> list[str]:
        """How each of them ended."""
        return ["ok"]

    @output(kind=WORD, show="")
    def status(self) -> list[str]:
        """How it ended: ok, no_jump, or the failure that explains what is missing."""
        return self.statuses()

    @cached_property
    def _words(self) -> NDArray[Any]:
        return np.array(self.status)

    def ended_as(self, statuses: tuple[str, ...]) -> NDArray[np.bool_]:
        """Which of them ended in one of these statuses."""
        return np.logical_or.reduce([self._words == status for status in statuses])

    @classmethod
    def declared(cls) -> list[Output[Any]]:
        """All outputs, the scene's own before those that it shares with others."""
        names = dict.fromkeys(name for owner in cls.__mro__ for name in vars(owner))
        found = (getattr(cls, name) for name in names)
        return [each for each in found if isinstance(each, Output)]

    def reported(self) -> list[Output[Any]]:
        """The declared ones that these simulations have."""
        return self.declared()

    def columns(self) -> dict[str, NDArray[Any]]:
        """Every output that there is by name, as an array (R,) of its kind."""
        return {
            each.name: np.atleast_1d(np.asarray(getattr(self, each.name), TYPES[each.kind]))
            for each in self.reported()
        }

    def rows(self, *names: str) -> list[dict[str, Any]]:
        """Outputs of each simulation by name, as plain numbers and words: these, or all."""
        columns = self.columns()
        kept = {name: columns[name].tolist() for name in names or columns}
        return [dict(zip(kept, values, strict=True)) for values in zip(*kept.values(), strict=True)]
