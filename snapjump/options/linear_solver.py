"""Options of the linear solvers."""

from snapjump.declare.fields import Part


class BandedSolverOptions(Part):
    """Bordered banded elimination: nodes as a band, the frame as its border."""

    group = "linear_solver"
