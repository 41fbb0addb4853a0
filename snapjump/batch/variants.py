"""A simulation with other designs."""

from collections.abc import Iterable, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from snapjump.composition import Simulation

Row = Sequence[float] | NDArray[np.float64]


def variant(base: Simulation, design: Row) -> Simulation:
    """The simulation with another (delta_alpha, epsilon, mass_bar, mu).

    Raises ParameterError for a value out of its range.
    """
    delta_alpha, epsilon, mass_bar, mu = (float(value) for value in design)
    return replace(
        base,
        design=replace(base.design, epsilon=epsilon, delta_alpha=delta_alpha),
        environment=replace(base.environment, mu=mu, mass_bar=mass_bar),
    )


def variants(base: Simulation, designs: Iterable[Row]) -> list[Simulation]:
    """The simulation with other (delta_alpha, epsilon, mass_bar, mu), in this order."""
    return [variant(base, design) for design in designs]
