"""Every member of every family, by its name."""

from snapjump.declare import members
from snapjump.declare.members import member_class, member_names

# Those of a simulation.
FAMILIES = {f: {n: member_class(f, n) for n in member_names(f)} for f in members.FAMILIES}
# And of a dataset.
EVERY = FAMILIES | {
    f: {n: member_class(f, n) for n in member_names(f)} for f in ("plan", "executor")
}
