"""Robots that can march together: one program, one mesh of their beams."""

from collections.abc import Sequence

from snapjump.checks import ParameterError
from snapjump.composition import Simulation

SAME = ("sim", "discretization", "integrator", "stepping", "backend")
OF_ONE_KIND = ("frame", "contact", "friction", "damping", "drag", "drive")


def check_alike(simulations: Sequence[Simulation]) -> None:
    """Raises ParameterError for a robot whose program is not the first one's."""
    first = simulations[0]
    for other in simulations[1:]:
        for family in (*SAME, *OF_ONE_KIND):
            ours, theirs = getattr(first, family), getattr(other, family)
            if family in SAME and theirs != ours:
                raise ParameterError(family, theirs, f"the first robot's: {ours}")
            if family == "drive" and theirs.in_common != ours.in_common:
                words, _ = theirs.in_common
                raise ParameterError("drive", theirs.name, f"{words} of the first robot")
            if type(theirs) is not type(ours):
                raise ParameterError(family, theirs.name, f"{ours.name}, as of the first robot")
