"""Options of the backends."""

from dataclasses import dataclass

from snapjump.checks import ParameterError

WIDTHS = (2, 4, 8, 16)


@dataclass(frozen=True)
class ScalarBackend:
    """One robot at a time, with its whole trajectory."""


@dataclass(frozen=True)
class LanesBackend:
    """Robots side by side in the lanes of SIMD instructions: for batches, outcomes only."""

    width: int = 8

    def __post_init__(self) -> None:
        if type(self.width) is not int or self.width not in WIDTHS:
            raise ParameterError("backend.width", self.width, "one of 2, 4, 8, 16")
