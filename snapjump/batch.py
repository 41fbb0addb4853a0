"""Many jumps of one composition side by side in the lanes of SIMD instructions."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from snapjump.composition import Simulation
from snapjump.ending.flight import FlightEnding
from snapjump.engine import clock as c
from snapjump.engine.model import Model
from snapjump.engine.status import NAMES, NO_JUMP, OK
from snapjump.error_estimate import ErrorEstimate, error_estimate
from snapjump.parameters.design import Design
from snapjump.parameters.environment import Environment
from snapjump.scenes.card_march import check_backend, march_on
from snapjump.scenes.flight_check import checked_status
from snapjump.scenes.frame_body import frame_mesh
from snapjump.scenes.jump_start import jump_model, resting_guess
from snapjump.scenes.runner import MOST_ITERATIONS

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Batch:
    """Outcomes of R jumps.

    x_bar, y_bar (R): apex in L, NaN for failures; status (R): names; newton_iterations, steps
    (R); kernel_seconds: for all of them; min_gap_m (R): smallest at the end of a step, NaN if
    none was done; error_sum_bar (R): estimates of all steps added up, in L;
    coarsest_contact_step (R): largest step times contact frequency; estimate: of the errors.
    """

    x_bar: Array
    y_bar: Array
    status: list[str]
    newton_iterations: Array
    steps: Array
    kernel_seconds: float
    min_gap_m: Array
    error_sum_bar: Array
    coarsest_contact_step: Array
    estimate: ErrorEstimate


def variants(
    base: Simulation, designs: Sequence[tuple[float, float, float, float]]
) -> list[Simulation]:
    """The simulation with other (delta_alpha, epsilon, mass_bar, mu), in this order."""
    return [
        replace(
            base,
            design=Design(epsilon=epsilon, delta_alpha=delta_alpha),
            environment=Environment(mu=mu, mass_bar=mass_bar),
        )
        for delta_alpha, epsilon, mass_bar, mu in designs
    ]


def march_together(
    simulations: Sequence[Simulation],
    models: Sequence[Model],
    lanes: int,
    most_iterations: float,
) -> tuple[Array, float]:
    """Outcome (R, ROWS) of jumps whose frames have one mesh, and the kernel's seconds."""
    base = simulations[0]
    states = np.array([resting_guess(s, m) for s, m in zip(simulations, models, strict=True)])
    march = march_on(base)(
        models=list(models),
        masses=base.discretization.masses(),
        states=states,
        simulation=base,
        ending=FlightEnding(base.sim.time_limit_s / base.robot.scales.time_s),
        lanes=lanes,
        most_iterations=most_iterations,
        mesh=frame_mesh(base, models[0].frame),
    )
    march.find_starts()
    return march.run(), march.kernel_seconds


def simulate_batch(
    simulations: Sequence[Simulation], lanes: int = 8, most_iterations: float = MOST_ITERATIONS
) -> Batch:
    """Simulate jumps, ``lanes`` at a time, each for at most so many Newton iterations.

    With ``backend=cuda`` they run on the card instead, one in each of its threads.

    They differ in numbers of the model only: design, environment, gravity, rotation, and values of
    the contact, friction and damping laws. Frames whose mesh depends on the design march with
    those of the same mesh.
    """
    base = simulations[0]
    check_backend(base)
    models = [jump_model(s) for s in simulations]
    groups: dict[tuple[int, ...], list[int]] = {}
    for k, (simulation, model) in enumerate(zip(simulations, models, strict=True)):
        groups.setdefault(tuple(frame_mesh(simulation, model.frame)), []).append(k)
    outcome = np.zeros((len(models), c.ROWS))
    kernel_seconds = 0.0
    for chosen in groups.values():
        outcome[chosen], seconds = march_together(
            [simulations[k] for k in chosen], [models[k] for k in chosen], lanes, most_iterations
        )
        kernel_seconds += seconds
    beam_mass = float(base.discretization.masses().sum())
    status = np.array(
        [checked_status(m, beam_mass, o) for m, o in zip(models, outcome, strict=True)]
    )
    fall = np.array([m.load.acceleration for m in models])
    rise = np.where(status == OK, np.maximum(outcome[:, c.COM_VY], 0.0), 0.0)
    known = np.isin(status, (OK, NO_JUMP))
    x = outcome[:, c.COM_X] + outcome[:, c.COM_VX] * rise / fall
    y = outcome[:, c.COM_Y] + 0.5 * rise**2 / fall
    beam_over_frame = np.array([1.0 / m.frame.mass for m in models])
    estimate = error_estimate(base, outcome[:, c.ERROR_SUM], beam_over_frame)
    gap = outcome[:, c.SMALLEST_GAP] * base.robot.scales.length_m
    return Batch(
        x_bar=np.where(known, x, np.nan),
        y_bar=np.where(known, y, np.nan),
        status=[NAMES[k] for k in status],
        newton_iterations=outcome[:, c.ITERATIONS],
        steps=outcome[:, c.STEPS],
        kernel_seconds=kernel_seconds,
        min_gap_m=np.where(outcome[:, c.STEPS] > 0.0, gap, np.nan),
        error_sum_bar=outcome[:, c.ERROR_SUM],
        coarsest_contact_step=outcome[:, c.COARSEST],
        estimate=estimate._replace(within_tier=estimate.within_tier & known),
    )
