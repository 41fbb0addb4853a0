"""Designs that are prepared one by one, each with the reason if it is refused."""

from collections.abc import Sequence
from dataclasses import dataclass

from snapjump.arrays import Array
from snapjump.batch.thresholds import thresholds
from snapjump.batch.variants import variant
from snapjump.checks import ParameterError
from snapjump.composition import Simulation
from snapjump.engine.model import Model
from snapjump.engine.status import BAD_DESIGN, NO_THRESHOLD
from snapjump.scenes.frame_body import compression
from snapjump.scenes.jump_start import NoThresholdError, jump_model
from snapjump.statics.threshold_curve import ThresholdCurve


@dataclass(frozen=True)
class Alone:
    """What became of designs, by their rows: simulations and models of those that can be simulated;
    why the others cannot, as a status and in one line."""

    simulations: dict[int, Simulation]
    models: dict[int, Model]
    refused: dict[int, tuple[int, str]]


def prepare_alone(
    base: Simulation,
    designs: Array,
    rows: Sequence[int],
    curve: ThresholdCurve | None,
    inputs: Sequence[str],
) -> Alone:
    """Models of some rows of the designs (R, I). A curve has thresholds for all of them at once."""
    possible: dict[int, Simulation] = {}
    found = Alone({}, {}, {})
    for k in rows:
        try:
            simulation = variant(base, designs[k], inputs)
            compression(simulation)
        except ParameterError as error:
            found.refused[k] = BAD_DESIGN, str(error)
        else:
            possible[k] = simulation
    known = thresholds(list(possible.values()), curve)
    for (k, simulation), threshold in zip(possible.items(), known, strict=True):
        try:
            found.models[k] = jump_model(simulation, threshold)
            found.simulations[k] = simulation
        except NoThresholdError as error:
            found.refused[k] = NO_THRESHOLD, str(error)
        except ParameterError as error:
            found.refused[k] = BAD_DESIGN, str(error)
    return found
