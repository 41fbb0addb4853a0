"""What becomes of many jumps, as arrays with one row a jump."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from snapjump.batch.prepare import Prepared
from snapjump.batch.sensitivities import Sensitivities, Slopes, apex_sensitivities
from snapjump.composition import Simulation
from snapjump.engine import clock as c
from snapjump.engine.status import NAMES, NO_JUMP, OK
from snapjump.error_estimate import ErrorEstimate, error_estimate
from snapjump.scenes.flight import flight
from snapjump.scenes.flight_check import checked_status

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Batch:
    """Outcomes of R jumps; arrays are (R), and NaN only where the status says why.

    status: names (see :mod:`snapjump.engine.status`).
    x_bar, y_bar: apex in L, of ``ok`` and, where it has come to rest, of ``no_jump``.
    apex_time_s, liftoff_*: of ``ok``, as :mod:`snapjump.scenes.flight` defines them; times count
    from the beginning of the clamps' rotation.
    mount_height_bar: of the clamps above the feet (L), NaN for designs that are refused.
    steps, newton_iterations; kernel_seconds: of a core, for all jumps and in all threads together,
    starts and idle lanes included; kernel_seconds_each: a jump's share of it by its iterations;
    lane_passes: iterations that all lanes together had time for.
    min_gap_m: smallest at the end of a step, NaN if none was done; error_sum_bar: estimates of all
    steps added up, in L; coarsest_contact_step: largest step times contact frequency; estimate: of
    the errors, NaN where there is no apex.
    sensitivities: of the apex, or None where none were asked for.
    """

    status: list[str]
    x_bar: Array
    y_bar: Array
    apex_time_s: Array
    liftoff_time_s: Array
    liftoff_x_bar: Array
    liftoff_y_bar: Array
    liftoff_vx_m_s: Array
    liftoff_vy_m_s: Array
    mount_height_bar: Array
    steps: Array
    newton_iterations: Array
    kernel_seconds: float
    kernel_seconds_each: Array
    lane_passes: int
    min_gap_m: Array
    error_sum_bar: Array
    coarsest_contact_step: Array
    estimate: ErrorEstimate
    sensitivities: Sensitivities | None = None


class Marched(NamedTuple):
    """Of M robots: outcomes (M, ROWS), the kernels' seconds, the iterations that lanes had time
    for, and slopes where these were asked for."""

    outcome: Array
    kernel_seconds: float
    lane_passes: int
    slopes: Slopes | None


def batch_of(base: Simulation, ready: Prepared, marched: Marched) -> Batch:
    """The batch of R designs, of which M were marched."""
    simulations, models, chosen = ready.simulations, ready.models, ready.chosen
    count, kernel_seconds = len(ready.status), marched.kernel_seconds

    def spread(values: Sequence[float] | Array, otherwise: float = np.nan) -> Array:
        """Values of the marched designs among those of all."""
        everyone = np.full((count, *np.shape(values)[1:]), otherwise)
        everyone[chosen] = values
        return everyone

    outcome = spread(marched.outcome, 0.0)
    beam_mass = float(base.discretization.masses().sum())
    status = ready.status.copy()
    status[chosen] = [
        checked_status(m, beam_mass, o) for m, o in zip(models, marched.outcome, strict=True)
    ]
    outcome[:, c.STATUS] = status
    begun = spread([m.clamp.start / m.clamp.rate for m in models])
    fall = spread([m.load.acceleration for m in models])
    flown = flight(begun, fall, outcome)
    known, flew = np.isin(status, (OK, NO_JUMP)), status == OK
    estimates = [
        error_estimate(simulation, summed, 1.0 / model.frame.mass)
        for simulation, model, summed in zip(
            simulations, models, marched.outcome[:, c.ERROR_SUM], strict=True
        )
    ]
    scales = [simulation.robot.scales for simulation in simulations]
    length_m, time_s = spread([s.length_m for s in scales]), spread([s.time_s for s in scales])
    velocity_m_s = spread([s.velocity_m_s for s in scales])
    iterations = outcome[:, c.ITERATIONS]
    gap = outcome[:, c.SMALLEST_GAP] * length_m

    def of_flights(values: Array, unit: Array | float = 1.0) -> Array:
        return np.where(flew, values * unit, np.nan)

    sensitivities = None
    if marched.slopes is not None:
        slopes = Slopes(*(spread(values) for values in marched.slopes))
        sensitivities = apex_sensitivities(outcome, fall, slopes)

    return Batch(
        status=[NAMES[k] for k in status],
        x_bar=np.where(known, flown.apex_x, np.nan),
        y_bar=np.where(known, flown.apex_y, np.nan),
        apex_time_s=of_flights(flown.apex_time, time_s),
        liftoff_time_s=of_flights(flown.liftoff_time, time_s),
        liftoff_x_bar=of_flights(flown.liftoff_x),
        liftoff_y_bar=of_flights(flown.liftoff_y),
        liftoff_vx_m_s=of_flights(flown.liftoff_vx, velocity_m_s),
        liftoff_vy_m_s=of_flights(flown.liftoff_vy, velocity_m_s),
        mount_height_bar=spread([m.frame.mount_y - m.frame.foot_y for m in models]),
        steps=outcome[:, c.STEPS],
        newton_iterations=iterations,
        kernel_seconds=kernel_seconds,
        kernel_seconds_each=kernel_seconds * iterations / max(float(iterations.sum()), 1.0),
        lane_passes=marched.lane_passes,
        min_gap_m=np.where(outcome[:, c.STEPS] > 0.0, gap, np.nan),
        error_sum_bar=outcome[:, c.ERROR_SUM],
        coarsest_contact_step=outcome[:, c.COARSEST],
        estimate=ErrorEstimate(
            np.where(known, spread([float(one.x_percent) for one in estimates]), np.nan),
            np.where(known, spread([float(one.y_percent) for one in estimates]), np.nan),
            known & (spread([float(one.within_tier) for one in estimates]) == 1.0),
        ),
        sensitivities=sensitivities,
    )
