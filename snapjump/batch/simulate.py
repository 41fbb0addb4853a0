"""Batches of jumps: on the processor, or on a card with ``backend=cuda``."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from snapjump.backend.base import MOST_THREADS, WIDTHS
from snapjump.backend.lanes import LanesBackend
from snapjump.batch.alike import check_alike
from snapjump.batch.derivatives import model_derivatives
from snapjump.batch.outcome import Batch, Marched, batch_of
from snapjump.batch.prepare import Prepared, prepare_designs
from snapjump.batch.progress import BatchProgress, Progress
from snapjump.checks import ParameterError, check_integer
from snapjump.composition import Simulation
from snapjump.ending.flight import FlightEnding
from snapjump.engine import clock as c
from snapjump.engine.model import Model
from snapjump.engine.status import RUNNING
from snapjump.scenes.card_march import check_backend, march_on
from snapjump.scenes.jump_start import jump_model
from snapjump.scenes.resting import resting_guesses
from snapjump.scenes.runner import MOST_ITERATIONS, March
from snapjump.scenes.sensitivities import check_differentiable, record_sensitivities
from snapjump.statics.threshold_curve import ThresholdCurve

Array = NDArray[np.float64]


def marches(
    simulations: Sequence[Simulation],
    models: Sequence[Model],
    lanes: int,
    threads: int,
    most_iterations: float,
) -> list[tuple[list[int], March]]:
    """Which jumps march together: those whose frames have one mesh."""
    groups: dict[tuple[int, ...], list[int]] = {}
    for k, (simulation, model) in enumerate(zip(simulations, models, strict=True)):
        groups.setdefault(tuple(simulation.frame.mesh(model.frame)), []).append(k)
    found = []
    for members in groups.values():
        ours = [models[k] for k in members]
        base = simulations[members[0]]
        march = march_on(base)(
            models=ours,
            masses=base.discretization.masses(),
            states=resting_guesses([simulations[k] for k in members], ours),
            simulation=base,
            ending=FlightEnding(base.sim.time_limit_s / base.robot.scales.time_s),
            lanes=lanes,
            threads=threads,
            most_iterations=most_iterations,
            mesh=base.frame.mesh(ours[0].frame),
        )
        found.append((members, march))
    return found


def march_all(
    simulations: Sequence[Simulation],
    models: Sequence[Model],
    lanes: int,
    threads: int,
    most_iterations: float,
    progress: Progress | None,
    numbers: Array | None = None,
) -> Marched:
    """March all; with slopes (M, P, 4) of the models' ``numbers`` those of the flights, too."""
    outcome = np.zeros((len(models), c.ROWS))
    slopes = None if numbers is None else (np.zeros((len(models), 4, 4)), np.zeros(len(models)))
    told = BatchProgress(len(models), progress or (lambda share, text: None))
    kernel_seconds, lane_passes = 0.0, 0
    for members, march in marches(simulations, models, lanes, threads, most_iterations):
        march.find_starts(told.starts(len(members)))
        recorded = None
        if numbers is not None:
            recorded = record_sensitivities(march, numbers[members])
        outcome[members] = march.run(told.jumps(len(members)))
        if slopes is not None and recorded is not None:
            slopes[0][members], slopes[1][members] = recorded
        told.finish(len(members))
        kernel_seconds += march.kernel_seconds
        lane_passes += march.lanes * march.passes
    return Marched(outcome, kernel_seconds, lane_passes, slopes)


def simulate_batch(
    simulations: Sequence[Simulation],
    lanes: int = 8,
    most_iterations: float = MOST_ITERATIONS,
    threads: int = 1,
    progress: Progress | None = None,
) -> Batch:
    """Simulate jumps, ``lanes`` at a time in each thread, each for at most so many iterations.

    They differ in numbers of the model only: design, environment, gravity, rotation, and values of
    the contact, friction and damping laws. Frames whose mesh depends on the design march with
    those of the same mesh. Results depend neither on lanes, threads nor order. With
    ``backend=cuda`` they run on the card, one in each of its threads.

    Raises ParameterError where they differ in more than that.
    """
    check_backend(simulations[0])
    check_alike(simulations)
    models = [jump_model(simulation) for simulation in simulations]
    marched = march_all(simulations, models, lanes, threads, most_iterations, progress)
    everyone = np.arange(len(models)), np.full(len(models), RUNNING)
    return batch_of(simulations[0], Prepared(list(simulations), models, *everyone), marched)


def simulate_designs(
    base: Simulation,
    designs: NDArray[np.float64],
    *,
    curve: ThresholdCurve | None = None,
    progress: Progress | None = None,
    threads: int | None = None,
    lanes: int | None = None,
    sensitivities: bool = False,
) -> Batch:
    """Simulate designs (R, 4) of one robot: delta_alpha (rad), epsilon, mass_bar, mu.

    ``threads`` (default: one a core) with ``lanes`` jumps in each; both default to what ``base``
    says if its backend is ``lanes``, and mean nothing with ``backend=cuda``.
    A curve spares a threshold for every epsilon in its range.
    With ``sensitivities`` the batch has derivatives of every apex; the jumps are the same.
    A design that is refused is a row with the status ``bad_design`` or ``no_threshold``.

    Raises ParameterError for an array of another shape, a scene that is no jump, a number of lanes
    or threads out of range, a curve of another robot or mesh, or a module that sensitivities do
    not know.
    """
    table = np.asarray(designs, dtype=float)
    if table.ndim != 2 or table.shape[1] != 4:
        raise ParameterError(
            "designs", table.shape, "rows of delta_alpha, epsilon, mass_bar, mu: shape (R, 4)"
        )
    if base.sim.name != "jump":
        raise ParameterError("sim", base.sim.name, "jump, for batches")
    check_backend(base)
    backend = base.backend if isinstance(base.backend, LanesBackend) else LanesBackend()
    width = backend.width if lanes is None else lanes
    if width not in (1, *WIDTHS):
        raise ParameterError("lanes", lanes, "1, 2, 4, 8 or 16")
    crew = backend.thread_count if threads is None else threads
    check_integer("threads", crew, 1, MOST_THREADS)
    if sensitivities:
        check_differentiable(base)
        curve = curve or ThresholdCurve.over(base.robot, base.discretization, table[:, 1])
    ready = prepare_designs(base, table, curve)
    numbers = None
    if sensitivities and curve is not None:
        numbers = model_derivatives(base, table[ready.chosen], curve)
    marched = march_all(
        ready.simulations,
        ready.models,
        width,
        crew,
        MOST_ITERATIONS,
        progress,
        numbers,
    )
    return batch_of(base, ready, marched)
