"""Options of the backends."""

from dataclasses import dataclass

from snapjump.checks import check_choice


@dataclass(frozen=True)
class ScalarBackend:
    """One robot at a time, with its whole trajectory."""


@dataclass(frozen=True)
class LanesBackend:
    """Robots side by side in the lanes of SIMD instructions: for batches, outcomes only."""

    width: int = 8

    def __post_init__(self) -> None:
        check_choice("backend.width", str(self.width), ("2", "4", "8", "16"))
