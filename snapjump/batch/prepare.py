"""Robots of many designs: their models, or why there is none."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from snapjump.arrays import Array
from snapjump.batch.alone import prepare_alone
from snapjump.batch.thresholds import check_curve
from snapjump.batch.together import many, prepare_together
from snapjump.batch.variants import Variants
from snapjump.composition import Simulation
from snapjump.declare.inputs import DEFAULT_INPUTS
from snapjump.engine.models import Models
from snapjump.engine.status import RUNNING
from snapjump.scenes.frame_body import compression
from snapjump.statics.threshold_curve import ThresholdCurve
from snapjump.units import Scales


@dataclass(frozen=True)
class Prepared:
    """The M of R designs that can be simulated: their simulations and models.

    simulations, models (M); chosen (M): which designs they are; status (R): RUNNING, or why a
    design cannot be simulated (see :mod:`snapjump.engine.status`); refusals: why in one line, by
    the number of the design. alike: the simulations as one, whose inputs are arrays (M), where
    their robots have the same scales and frames of the same mesh; else None.
    """

    simulations: Sequence[Simulation]
    models: Models
    chosen: NDArray[np.int64]
    status: NDArray[np.int64]
    refusals: dict[int, str] = field(default_factory=dict)
    alike: Simulation | None = None

    def spread(self, values: Array, otherwise: float = np.nan) -> Array:
        """Values (M, ...) of the designs that are simulated among those of all (R, ...)."""
        everyone = np.full((len(self.status), *values.shape[1:]), otherwise)
        everyone[self.chosen] = values
        return everyone

    def of_each(self, read: Callable[[Simulation], Any]) -> Array:
        """Numbers (M) that are read off their simulations."""
        if self.alike is not None:
            return np.broadcast_to(read(self.alike), self.chosen.shape)
        return np.array([read(simulation) for simulation in self.simulations])

    @cached_property
    def compressions(self) -> Array:
        """End shortenings (M) of their beams."""
        return self.of_each(compression)

    @cached_property
    def scales(self) -> Scales:
        """Units (M each) of their numbers."""
        robots = [self.alike] if self.alike is not None else self.simulations
        scales = [simulation.robot.scales for simulation in robots]
        units: Any = np.array([(one.length_m, one.time_s, one.mass_kg) for one in scales])
        return Scales(*np.broadcast_to(units.reshape(-1, 3), (len(self.chosen), 3)).T)


def prepare_designs(
    base: Simulation,
    designs: Array,
    curve: ThresholdCurve | None = None,
    inputs: Sequence[str] = DEFAULT_INPUTS,
) -> Prepared:
    """Models of designs (R, I), whose columns are values of these inputs.

    Thresholds are taken from the curve where it reaches, and computed elsewhere. Refused designs
    get a status. Raises ParameterError for a curve of another robot or mesh.
    """
    check_curve(base, curve)
    together = prepare_together(base, designs, curve, inputs)
    left = np.delete(np.arange(len(designs)), together.rows)
    alone = prepare_alone(base, designs, left.tolist(), curve, inputs)
    status = np.full(len(designs), RUNNING)
    status[list(alone.refused)] = [code for code, _ in alone.refused.values()]
    refusals = {row: line for row, (_, line) in alone.refused.items()}
    chosen, others = np.flatnonzero(status == RUNNING), list(alone.models.values())
    if not len(together.rows):
        simulations = list(alone.simulations.values())
        return Prepared(simulations, Models.of(others), chosen, status, refusals)
    order = np.argsort(np.concatenate([together.rows, np.array([*alone.models], dtype=np.int64)]))
    models, kept = together.models.followed_by(others)[order], designs[chosen]
    alike = many(base, kept, inputs)
    return Prepared(Variants(base, kept, inputs), models, chosen, status, refusals, alike)
