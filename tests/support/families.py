"""Every member of every family, by its name."""

from snapjump.declare import members
from snapjump.declare.members import member_class, member_names


def of(*families):
    return {f: {n: member_class(f, n) for n in member_names(f)} for f in families}


FAMILIES = of(*members.FAMILIES)  # those of a simulation
EVERY = FAMILIES | of("plan", "executor", "surrogate", "inverse")
