"""A simulation with other inputs."""

from collections.abc import Iterable, Sequence

import numpy as np
from numpy.typing import NDArray

from snapjump.composition import Simulation
from snapjump.declare.inputs import DEFAULT_INPUTS, with_inputs

Row = Sequence[float] | NDArray[np.float64]


def variant(base: Simulation, row: Row, paths: Sequence[str] = DEFAULT_INPUTS) -> Simulation:
    """The simulation with other values of some inputs, by default of the four.
    Raises ParameterError for a value out of its range."""
    return with_inputs(base, dict(zip(paths, row, strict=True)))


def variants(
    base: Simulation, rows: Iterable[Row], paths: Sequence[str] = DEFAULT_INPUTS
) -> list[Simulation]:
    """The simulation with other values of some inputs, one for each row, in this order."""
    return [variant(base, row, paths) for row in rows]
