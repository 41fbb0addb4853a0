"""A simulation with other inputs."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from snapjump.arrays import Array
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


@dataclass(frozen=True, eq=False)
class Variants(Sequence[Simulation]):
    """The same of rows (R, I) that are known to be allowed, each made when it is asked for."""

    base: Simulation
    rows: Array
    paths: Sequence[str]

    def __len__(self) -> int:
        return len(self.rows)

    def __getitem__(self, which: Any) -> Any:
        """A row's simulation, or those of a slice."""
        if isinstance(which, slice):
            return Variants(self.base, self.rows[which], self.paths)
        return variant(self.base, self.rows[which], self.paths)
