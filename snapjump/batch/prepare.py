"""Robots of many designs: their models, or why there is none."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from snapjump.arrays import Array
from snapjump.batch.variants import variant
from snapjump.checks import ParameterError
from snapjump.composition import Simulation
from snapjump.declare.inputs import DEFAULT_INPUTS
from snapjump.engine.model import Model
from snapjump.engine.status import BAD_DESIGN, NO_THRESHOLD, RUNNING
from snapjump.scenes.frame_body import compression
from snapjump.scenes.jump_start import NoThresholdError, jump_model
from snapjump.statics.threshold import Threshold
from snapjump.statics.threshold_curve import ThresholdCurve


@dataclass(frozen=True)
class Prepared:
    """The M of R designs that can be simulated: their simulations and models.

    simulations, models (M); chosen (M): which designs they are; status (R): RUNNING, or why a
    design cannot be simulated (see :mod:`snapjump.engine.status`); refusals: why in one line, by
    the number of the design.
    """

    simulations: list[Simulation]
    models: list[Model]
    chosen: NDArray[np.int64]
    status: NDArray[np.int64]
    refusals: dict[int, str] = field(default_factory=dict)

    def spread(self, values: Array, otherwise: float = np.nan) -> Array:
        """Values (M, ...) of the designs that are simulated among those of all (R, ...)."""
        everyone = np.full((len(self.status), *values.shape[1:]), otherwise)
        everyone[self.chosen] = values
        return everyone


def beam_of(simulation: Simulation) -> Any:
    """The dimensionless beam, which thresholds are of."""
    return simulation.discretization.beam(simulation.robot)


def check_curve(base: Simulation, curve: ThresholdCurve | None) -> None:
    """Require a curve of a beam like the simulation's. Raises ParameterError."""
    if curve is None:
        return
    given = curve.discretization.beam(curve.robot)
    needed = beam_of(base)
    if given != needed:
        raise ParameterError("curve", given, f"one of this robot and mesh, {needed}")


def covered(simulation: Simulation, curve: ThresholdCurve | None) -> bool:
    """Whether the curve is of the simulation's beam, and reaches its pre-compression."""
    if curve is None:
        return False
    own = beam_of(simulation) == curve.discretization.beam(curve.robot)
    return own and bool(curve.covers(compression(simulation)))


def thresholds(
    simulations: list[Simulation], curve: ThresholdCurve | None
) -> list[Threshold | None]:
    """The threshold of each from the curve; None where that does not reach, or is of another
    beam."""
    if curve is None:
        return [None] * len(simulations)
    shortenings = np.array([compression(simulation) for simulation in simulations])
    angles, depths = curve.values(np.clip(shortenings, curve.low, curve.high))
    return [
        Threshold(float(angle), float(depth), curve.angle_error) if covered(one, curve) else None
        for one, angle, depth in zip(simulations, angles, depths, strict=True)
    ]


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
    status = np.full(len(designs), RUNNING)
    possible: dict[int, Simulation] = {}
    refusals: dict[int, str] = {}
    for k, design in enumerate(designs):
        try:
            simulation = variant(base, design, inputs)
            compression(simulation)
        except ParameterError as error:
            status[k], refusals[k] = BAD_DESIGN, str(error)
        else:
            possible[k] = simulation
    models: dict[int, Model] = {}
    known = thresholds(list(possible.values()), curve)
    for (k, simulation), threshold in zip(possible.items(), known, strict=True):
        try:
            models[k] = jump_model(simulation, threshold)
        except NoThresholdError as error:
            status[k], refusals[k] = NO_THRESHOLD, str(error)
        except ParameterError as error:
            status[k], refusals[k] = BAD_DESIGN, str(error)
    chosen = np.array(list(models), dtype=np.int64)
    kept = [possible[k] for k in models]
    return Prepared(kept, list(models.values()), chosen, status, refusals)
