"""What becomes of many jumps, as arrays with one row a jump."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from snapjump.batch.prepare import Prepared
from snapjump.batch.sensitivities import Sensitivities, apex_sensitivities
from snapjump.composition import Simulation
from snapjump.engine import clock as c
from snapjump.scenes.flight_check import checked_status
from snapjump.scenes.jump_outputs import JumpOutputs
from snapjump.scenes.jump_start import jump_model
from snapjump.scenes.march_outputs import side_by_side

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Batch(JumpOutputs):
    """Outputs of R jumps, arrays (R): :class:`snapjump.scenes.jump_outputs.JumpOutputs` has them.

    Counts of designs that are refused are 0, all else of them is NaN. The time in kernels, of all
    together, has starts and idle lanes in it. lane_passes: iterations that all lanes together had
    time for. sensitivities: of the apex, or None where none were asked for.
    """

    lane_passes: int
    sensitivities: Sensitivities | None = None


class Marched(NamedTuple):
    """What M marches ended with: outcomes (M, ROWS), seconds of a core in the kernels, iterations
    that lanes had time for; if asked for slopes of the flights (M, 4, 4), distances of grazes (M).
    """

    outcome: Array
    kernel_seconds: float
    lane_passes: int
    slopes: tuple[Array, Array] | None


def batch_of(base: Simulation, ready: Prepared, marched: Marched) -> Batch:
    """The batch of R designs, of which M were marched."""
    rows, chosen = len(ready.status), ready.chosen
    # Where no design has a model, any gives the kinds of numbers that are not known.
    models = ready.models or [jump_model(Simulation())]
    model = side_by_side(models, chosen, rows)
    outcome = np.zeros((rows, c.ROWS))
    outcome[:, c.STATUS] = ready.status
    outcome[chosen] = marched.outcome
    outcome[:, c.STATUS] = checked_status(model, float(base.discretization.masses().sum()), outcome)
    sensitivities = None
    if marched.slopes is not None:
        flights, grazes = np.zeros((rows, 4, 4)), np.full(rows, np.nan)
        flights[chosen], grazes[chosen] = marched.slopes
        sensitivities = apex_sensitivities(outcome, model.load.acceleration, flights, grazes)
    passes = marched.lane_passes
    return Batch(base, model, outcome, marched.kernel_seconds, passes, sensitivities)
