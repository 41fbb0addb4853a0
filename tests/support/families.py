"""Every member of every family, by its name."""

import pytest

from snapjump.declare import members
from snapjump.declare.members import member_class, member_names


def of(*families):
    return {f: {n: member_class(f, n) for n in member_names(f)} for f in families}


def pairs(families):
    """(family, member) of each of them."""
    return [(family, name) for family, members in families.items() for name in members]


FAMILIES = of(*members.FAMILIES)  # those of a simulation
OTHERS = of("plan", "executor", "surrogate", "inverse", "uncertainty")
EVERY = FAMILIES | OTHERS
MEMBERS = pairs(FAMILIES)

of_simulations = pytest.mark.parametrize(("family", "name"), MEMBERS)
of_all_families = pytest.mark.parametrize(("family", "name"), pairs(EVERY))
