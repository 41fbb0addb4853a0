"""Options of the linear solvers."""

from dataclasses import dataclass


@dataclass(frozen=True)
class BandedSolverOptions:
    """Bordered banded elimination: nodes as a band, the frame as its border."""
