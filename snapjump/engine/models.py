"""Models of many robots of one composition: all their numbers in one array."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from snapjump.arrays import Array
from snapjump.engine.model import Model, numbers_in, numbers_of, with_numbers


def numbers_of_columns(model: Sequence[Any], robots: int) -> Array:
    """All numbers (R, P) of so many robots that are one model, or members of one, whose numbers are
    the same for all or arrays (R)."""
    values = [value for member in model for value in numbers_in(member)]
    numbers = np.empty((robots, len(values)))
    for k, value in enumerate(values):
        numbers[:, k] = value
    return numbers


@dataclass(frozen=True, eq=False)
class Models(Sequence[Model]):
    """Models of R robots, each of which is made when it is asked for.

    ``kind``: a model of the same members; ``numbers`` (R, P): as of
    :func:`snapjump.engine.model.numbers_of`.
    """

    kind: Any
    numbers: Array

    @classmethod
    def of(cls, models: Sequence[Model]) -> "Models":
        """The same models, if they are of one composition."""
        if isinstance(models, cls):
            return models
        if not models:
            return cls(None, np.zeros((0, 0)))
        return cls(models[0], np.array([numbers_of(model) for model in models]))

    @classmethod
    def of_columns(cls, model: Model, robots: int) -> "Models":
        """So many robots, one at least, that are one model with arrays (R) for numbers."""
        numbers = numbers_of_columns(model, robots)
        return cls(with_numbers(model, numbers[0].tolist()), numbers)

    def followed_by(self, others: Sequence[Model]) -> "Models":
        """These, and others of the same composition."""
        rows = [numbers_of(model)[None] for model in others]
        return Models(self.kind, np.concatenate([self.numbers, *rows]))

    def __len__(self) -> int:
        return len(self.numbers)

    def __getitem__(self, which: Any) -> Any:
        """A robot's model, of plain numbers; or the models of a slice, or of an array of rows."""
        found = self.numbers[which]
        if found.ndim == 2:
            return Models(self.kind, found)
        return with_numbers(self.kind, found.tolist())
