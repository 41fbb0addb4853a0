"""Batches of jumps: on the processor, or on a card with ``backend=cuda``."""

from collections.abc import Sequence
from typing import Any, TypedDict, Unpack

import numpy as np

from snapjump.arrays import Array
from snapjump.backend.base import MOST_THREADS, WIDTHS
from snapjump.backend.lanes import LanesBackend
from snapjump.batch.alike import check_alike
from snapjump.batch.derivatives import model_derivatives, places
from snapjump.batch.loads import check_outputs, reads_of, with_loads
from snapjump.batch.outcome import Batch, Marched, batch_of
from snapjump.batch.prepare import Prepared, prepare_designs
from snapjump.batch.progress import BatchProgress
from snapjump.batch.sensitivities import Slopes
from snapjump.checks import ParameterError, check_integer, check_number
from snapjump.composition import Simulation, with_tier
from snapjump.declare.inputs import (
    DEFAULT_INPUTS,
    check_inputs,
    column_names,
    input_at,
    inputs_of,
    value_at,
)
from snapjump.declare.scenes import Progress
from snapjump.declare.tables import rows_of
from snapjump.engine import outcome as c
from snapjump.engine.load.gravity import Gravity
from snapjump.engine.models import Models
from snapjump.engine.status import RUNNING
from snapjump.scenes.card_march import check_backend
from snapjump.scenes.jump_march import march_from_rest
from snapjump.scenes.jump_start import jump_model
from snapjump.scenes.recorded_loads import KINDS, record_loads
from snapjump.scenes.runner import MOST_ITERATIONS, March
from snapjump.scenes.sensitivities import check_differentiable, record_sensitivities
from snapjump.statics.threshold_curve import ThresholdCurve


def groups_of(ready: Prepared) -> list[list[int]]:
    """Jumps that go together: those with one mesh of the frame and one step control."""
    if ready.alike is not None:
        return [list(range(len(ready.models)))]
    groups: dict[tuple[Any, ...], list[int]] = {}
    for k, (simulation, model) in enumerate(zip(ready.simulations, ready.models, strict=True)):
        # A fixed step in seconds is another one for a robot of another scale of time.
        stepping = simulation.stepping.control(simulation.robot.scales)
        kind = (stepping, *simulation.frame.mesh(model.frame))
        groups.setdefault(kind, []).append(k)
    return list(groups.values())


def marches(
    ready: Prepared, lanes: int, threads: int, most_iterations: float
) -> list[tuple[list[int], March]]:
    """Marches of prepared jumps, and which of them each is of."""
    crew: dict[str, Any] = {"lanes": lanes, "threads": threads, "most_iterations": most_iterations}
    found = []
    for group in groups_of(ready):
        robots = ready.simulations[group[0]], ready.models[group], ready.compressions[group]
        found.append((group, march_from_rest(*robots, **crew)))
    return found


def march_all(
    ready: Prepared,
    lanes: int,
    threads: int,
    most_iterations: float,
    progress: Progress | None,
    numbers: Array | None = None,
    reads: Sequence[str] = (),
) -> Marched:
    """Outcomes of prepared jumps; with slopes (M, P, I) of the models' ``numbers`` also those of
    the flights; with ``reads`` also what these record."""
    count = len(ready.models)
    outcome, slopes = np.zeros((count, c.COLUMNS)), None
    if numbers is not None:
        inputs = numbers.shape[2]
        load, drag = (slopes_of_member(ready, numbers, which) for which in ("load", "drag"))
        slopes = Slopes(np.zeros((count, 4, inputs)), load, drag, np.zeros(count))
    loads: dict[str, Array] = {
        read: np.full((count, KINDS[read].figures), np.nan) for read in reads
    }
    told = BatchProgress(count, progress or (lambda share, text: None))
    kernel_seconds, lane_passes = 0.0, 0
    for group, march in marches(ready, lanes, threads, most_iterations):
        march.find_starts(told.starts(len(group)))
        recorded = None
        if numbers is not None:
            recorded = record_sensitivities(march, numbers[group])
        borne = record_loads(march, reads) if reads else {}
        outcome[group] = march.run(told.jumps(len(group)))
        if slopes is not None and recorded is not None:
            slopes.flights[group] = recorded[0][:, :, : slopes.flights.shape[2]]
            slopes.grazes[group] = recorded[1]
        for read, figures in borne.items():
            loads[read][group] = figures
        told.finish(len(group))
        kernel_seconds += march.kernel_seconds
        lane_passes += march.lanes * march.passes
    return Marched(outcome, kernel_seconds, lane_passes, slopes, loads)


def slopes_of_member(ready: Prepared, numbers: Array, family: str) -> Array:
    """Slopes (M, N, I) of the numbers of the models' members of a family, among those (M, P, I) of
    all their numbers."""
    if not ready.models:
        return np.zeros((0, len(Gravity._fields), numbers.shape[2]))
    return numbers[:, places(ready.models[0], family)]


def simulate_batch(
    simulations: Sequence[Simulation],
    lanes: int = 8,
    most_iterations: float = MOST_ITERATIONS,
    threads: int = 1,
    progress: Progress | None = None,
    outputs: Sequence[str] = (),
) -> Batch:
    """Simulate jumps, ``lanes`` at a time in each thread, each for at most so many iterations.

    They differ in numbers only: of robot, design, environment, and the contact, friction and
    damping laws. Frames whose mesh depends on the design march with those of the same mesh.
    Results depend neither on lanes, threads nor order. With ``backend=cuda`` they run on the card,
    one in each of its threads. ``outputs``: as of :func:`simulate_designs`.

    Raises ParameterError where they differ in more than that, and for outputs that there are not.
    """
    if not simulations:
        raise ParameterError("simulations", [], "one at least")
    check_backend(simulations[0])
    check_alike(simulations)
    check_width(lanes, threads)
    check_number("most_iterations", most_iterations, 1.0)
    asked = check_outputs(simulations[0], outputs)
    count = len(simulations)
    models = Models.of([jump_model(simulation) for simulation in simulations])
    ready = Prepared(list(simulations), models, np.arange(count), np.full(count, RUNNING))
    marched = march_all(ready, lanes, threads, most_iterations, progress, reads=reads_of(asked))
    given = {p: np.array([value_at(s, p) for s in simulations], float) for p in DEFAULT_INPUTS}
    names = column_names([input_at(simulations[0], path) for path in given])
    designs = dict(zip(names, given.values(), strict=True))
    return with_loads(batch_of(simulations[0], ready, marched, designs), asked, marched.loads)


def check_width(lanes: int, threads: int) -> None:
    """Raise ParameterError for lanes that there are not, or threads out of range."""
    if lanes not in (1, *WIDTHS):
        raise ParameterError("lanes", lanes, "1, 2, 4, 8 or 16")
    check_integer("threads", threads, 1, MOST_THREADS)


class Crew(TypedDict, total=False):
    """Who simulates: threads, and jumps side by side in each of them."""

    threads: int | None
    lanes: int | None


def crew_of(
    base: Simulation, threads: int | None = None, lanes: int | None = None
) -> tuple[int, int]:
    """Lanes and threads, those of ``base`` where they are not given. Raises ParameterError."""
    backend = base.backend if isinstance(base.backend, LanesBackend) else LanesBackend()
    width = backend.width if lanes is None else lanes
    count = backend.thread_count if threads is None else threads
    check_width(width, count)
    return width, count


def simulate_designs(
    base: Simulation | str,
    designs: Any,
    *,
    inputs: Sequence[str] = DEFAULT_INPUTS,
    curve: ThresholdCurve | None = None,
    progress: Progress | None = None,
    sensitivities: bool = False,
    outputs: Sequence[str] = (),
    **crew: Unpack[Crew],
) -> Batch:
    """Simulate designs (R, I), whose columns are ``inputs``, by their paths.

    By default these are delta_alpha (rad), epsilon, mass_bar, mu; all else is as in ``base``, a
    simulation or the name of an accuracy tier. An
    array has its columns in this order; those of a DataFrame are found by their names.
    ``threads`` (default: one a core) with ``lanes`` jumps in each; both default to what ``base``
    says if its backend is ``lanes``, and mean nothing with ``backend=cuda``.
    A curve spares a threshold for every epsilon in its range.
    With ``sensitivities`` the batch has derivatives of every apex by the inputs, of which there
    are at most four then; the jumps are the same.
    ``outputs``: names of outputs that cost time, and that the batch then has too: the largest
    loads, of all steps (``["max_strain", "peak_clamp_torque_N_m"]``, docs/outputs.md). The jumps
    are the same.
    A design that is refused is a row with the status ``bad_design`` or ``no_threshold``.

    Raises ParameterError for an array of another shape, a path that is no input, a scene that is no
    jump, a number of lanes or threads out of range, a curve of another robot or mesh, a module
    that sensitivities do not know, or outputs that there are not, or not with these.
    """
    base = with_tier(base) if isinstance(base, str) else base
    check_inputs(base, inputs)
    known = inputs_of(base)
    table = rows_of(designs, [known[path] for path in inputs], known.values())
    if base.sim.name != "jump":
        raise ParameterError("sim", base.sim.name, "jump, for batches")
    check_backend(base)
    width, count = crew_of(base, **crew)
    asked = check_outputs(base, outputs, sensitivities)
    if sensitivities:
        check_differentiable(base, inputs)
        if curve is None and "design.epsilon" in inputs:
            epsilons = table[:, list(inputs).index("design.epsilon")]
            curve = ThresholdCurve.over(base.robot, base.discretization, epsilons)
    ready = prepare_designs(base, table, curve, inputs)
    numbers = None
    if sensitivities:
        numbers = model_derivatives(base, table[ready.chosen], curve, inputs)
    marched = march_all(ready, width, count, MOST_ITERATIONS, progress, numbers, reads_of(asked))
    names = column_names([known[path] for path in inputs])
    batch = batch_of(base, ready, marched, dict(zip(names, table.T, strict=True)))
    return with_loads(batch, asked, marched.loads)
