"""Rounding errors of critical angles, and the largest that is accepted."""

from typing import Any

from snapjump.checks import ParameterError

# Errors stay below so many times the size that roundings of single numbers add up to.
COVERAGE = 4.0
LARGEST_ANGLE_ERROR_RAD = 1e-5


class LostToRoundingError(ParameterError, ArithmeticError):
    """Rounding alone spoils the critical angle of this beam on this mesh."""


def check_angle_error(discretization: Any, error_rad: float) -> None:
    """Require a critical angle to be known well enough. Raises LostToRoundingError."""
    if not error_rad <= LARGEST_ANGLE_ERROR_RAD:
        raise LostToRoundingError(
            "discretization.elements",
            discretization.elements,
            f"a coarser mesh, or a thicker beam: rounding alone moves the critical angle of so "
            f"slender a one by {error_rad:.1g} rad (at most {LARGEST_ANGLE_ERROR_RAD:g})",
        )
