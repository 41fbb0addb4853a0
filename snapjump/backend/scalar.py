"""``backend=scalar``: one robot at a time, with its whole trajectory."""

from snapjump.backend.base import BackendOptions


class ScalarBackend(BackendOptions):
    """One robot at a time, with its whole trajectory."""

    one_at_a_time = True
    width = 1
