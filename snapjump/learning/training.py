"""``training``: how a forward model is trained, and on which of a dataset's jumps."""

import math

from snapjump.checks import ParameterError, check_integer
from snapjump.declare.fields import Part, integer, number

LARGEST = 2**30
WARM_UP = 0.02  # of the epochs, in which the learning rate rises


class Training(Part):
    """Shares of a dataset, and gradient descent by Adam.
    ``rows``: jumps that are learned from, those of the validation included; None for all."""

    group = "training"

    test_share: float = number(0.2, least=0.01, most=0.9)
    validation_share: float = number(0.1, least=0.01, most=0.9)
    rows: int | None = integer(None, least=1, most=LARGEST)
    epochs: int = integer(240, least=1, most=1_000_000)
    patience: int = integer(60, least=1, most=1_000_000)
    batch_first: int = integer(64, least=1, most=LARGEST)
    batch_last: int = 1024
    learning_rate: float = number(1e-3, above=0.0, most=1.0)
    threads: int = integer(1, least=1, most=1024)

    def __post_init__(self) -> None:
        super().__post_init__()
        check_integer("training.batch_last", self.batch_last, self.batch_first, LARGEST)
        if self.batch_last != self.batch_first << self.doublings:
            allowed = f"training.batch_first = {self.batch_first} times a power of two"
            raise ParameterError("training.batch_last", self.batch_last, allowed)

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
