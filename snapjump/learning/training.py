"""``training``: how a forward model is trained, and on which of a dataset's jumps."""

import math
from collections.abc import Mapping
from dataclasses import dataclass, fields
from typing import Any

from snapjump.checks import ParameterError, check_group, check_integer, check_number

LARGEST = 2**30
WARM_UP = 0.02  # of the epochs, in which the learning rate rises


@dataclass(frozen=True)
class Training:
    """Shares of a dataset, and gradient descent by Adam.

    ``rows``: jumps that are learned from, those of the validation included; None for all.
    """

    test_share: float = 0.2
    validation_share: float = 0.1
    rows: int | None = None
    epochs: int = 240
    patience: int = 60
    batch_first: int = 64
    batch_last: int = 1024
    learning_rate: float = 1e-3
    threads: int = 1

    def __post_init__(self) -> None:
        for share in ("test_share", "validation_share"):
            check_number(f"training.{share}", getattr(self, share), 0.01, 0.9)
        if self.rows is not None:
            check_integer("training.rows", self.rows, 1, LARGEST)
        check_integer("training.epochs", self.epochs, 1, 1_000_000)
        check_integer("training.patience", self.patience, 1, 1_000_000)
        check_integer("training.batch_first", self.batch_first, 1, LARGEST)
        check_integer("training.batch_last", self.batch_last, self.batch_first, LARGEST)
        if self.batch_last != self.batch_first << self.doublings:
            allowed = f"training.batch_first = {self.batch_first} times a power of two"
            raise ParameterError("training.batch_last", self.batch_last, allowed)
        check_number("training.learning_rate", self.learning_rate, 0.0, 1.0, above=True)
        check_integer("training.threads", self.threads, 1, 1024)

    @property
    def doublings(self) -> int:
        """How often the size of a batch doubles."""
        return (self.batch_last // self.batch_first).bit_length() - 1

    def batch_size(self, epoch: int) -> int:
        """Jumps of a batch: each size for an equal stretch of the epochs."""
        return self.batch_first << (epoch * (self.doublings + 1) // self.epochs)

    def rate(self, epoch: int) -> float:
        """The learning rate: it rises for a short while, then falls to zero as a cosine."""
        rise = min(1.0, (epoch + 1) / (1.0 + WARM_UP * self.epochs))
        return self.learning_rate * rise * 0.5 * (1.0 + math.cos(math.pi * epoch / self.epochs))


def make_training(group: Any) -> Training:
    """From a group that has every key. Raises ParameterError."""
    check_group("training", group)
    values: Mapping[str, Any] = group
    known = [field.name for field in fields(Training)]
    for key in values:
        if key not in known:
            allowed = "training has " + ", ".join(known)
            raise ParameterError(f"training.{key}", values[key], allowed)
    for key in known:
        if key not in values:
            raise ParameterError(f"training.{key}", None, "a value, which cannot be left out")
    return Training(**values)
