"""Robots that can march together: one program, one mesh of their beams."""

from collections.abc import Sequence

from snapjump.checks import ParameterError
from snapjump.composition import Simulation

SAME = ("sim", "discretization", "integrator", "stepping", "backend")
OF_ONE_KIND = ("frame", "contact", "friction", "damping")


def check_alike(simulations: Sequence[Simulation]) -> None:
    """Raises ParameterError for a robot whose program is not the first one's."""
    first = simulations[0]
    for other in simulations[1:]:
        for family in SAME:
            if getattr(other, family) != getattr(first, family):
                raise ParameterError(
                    family, getattr(other, family), f"the first robot's: {getattr(first, family)}"
                )
        for family in OF_ONE_KIND:
            if type(getattr(other, family)) is not type(getattr(first, family)):
                raise ParameterError(
                    family,
                    getattr(other, family).name,
                    f"{getattr(first, family).name}, as of the first robot",
                )
