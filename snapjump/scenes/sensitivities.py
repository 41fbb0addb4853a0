"""Marches with derivatives of their flights by inputs, at most four at a time."""

import math
from collections.abc import Sequence
from itertools import count
from typing import Any

import numpy as np
from numpy.typing import NDArray

from snapjump.checks import ParameterError
from snapjump.composition import Simulation
from snapjump.declare.inputs import DEFAULT_INPUTS
from snapjump.declare.members import members_with
from snapjump.engine.differentiate_start import StartSlopes, differentiate_starts
from snapjump.engine.recorder.sensitivities import FAR, SensitivityRecorder
from snapjump.engine.tangent import make_tangent_state
from snapjump.engine.work import make_memory
from snapjump.number.dual_type import PARAMETERS
from snapjump.number.memory import aligned_zeros
from snapjump.number.once import load
from snapjump.scenes.crew import Worker, run_crew
from snapjump.scenes.runner import March

Array = NDArray[np.float64]
# Corrections of a stage's derivatives, where the matrix lacks something: each shrinks their error
# about a hundred times.
CORRECTIONS = 3
# Below it steps jump over the stick zone of friction: whether a point sticks is then decided within
# Newton's tolerance, and the derivative of what was computed tells nothing of what sticking does.
SMALLEST_STICK_ZONE = 1.095e-3  # L/T: 0.005 m/s of the default robot
ROBOTS_PER_SLICE = 16


def check_differentiable(
    simulation: Simulation, inputs: Sequence[str] = DEFAULT_INPUTS, key: str = "inputs"
) -> None:
    """Require modules that sensitivities know. Raises ParameterError naming the first other."""
    if len(inputs) > PARAMETERS:
        raise ParameterError(key, list(inputs), f"at most {PARAMETERS} inputs with sensitivities")
    for part in simulation.parts:
        if not part.differentiable:
            able = " or ".join(members_with(part.group, "differentiable"))
            raise ParameterError(part.group, part.name, f"{able} with sensitivities")


def unresolved(simulation: Simulation) -> list[str]:
    """A line that says so where the steps of a simulation jump over its friction's stick zone."""
    if stick_zone(simulation) >= SMALLEST_STICK_ZONE:
        return []
    smallest_m_s = SMALLEST_STICK_ZONE * simulation.robot.scales.velocity_m_s
    return [
        f"steps jump over a stick zone of friction.velocity_threshold_m_s below {smallest_m_s:.3g} "
        "m/s: slopes are then those of the steps' errors too, and no jump is marked as "
        "differentiable (0.01 instead of 0.001 moves x by 0.1 % in the median)"
    ]


def stick_zone(simulation: Simulation) -> Any:
    """Half width (L/T) of the stick zone of a simulation's friction, infinite without one."""
    width_m_s = getattr(simulation.friction, "velocity_threshold_m_s", math.inf)
    return width_m_s / simulation.robot.scales.velocity_m_s


def differentiated_starts(march: March, numbers: Array) -> Array:
    """Slopes (R, 3, D, 4) of the starts that a march has found: state, velocity, acceleration.

    numbers (R, P, 4): slopes of its models' numbers.
    """
    robots, size = march.queue.state.shape
    starts = aligned_zeros((robots, 3, size, PARAMETERS))
    blocks = count()

    def arguments(worker: Worker, first: int, last: int) -> tuple[object, ...]:
        memory, tangent = singles[id(worker)]
        slopes = StartSlopes(numbers, starts)
        fixed = (march.model, march.masses, memory, tangent, worker.queue, slopes)
        return (*fixed, first, last)

    def advance(worker: Worker) -> bool:
        first = ROBOTS_PER_SLICE * next(blocks)
        if first >= robots:
            return True
        differentiate_starts(*arguments(worker, first, min(first + ROBOTS_PER_SLICE, robots)))
        return False

    singles = {}
    for worker in march.crew:
        memory = make_memory(march.sizes(1), march.mesh)
        singles[id(worker)] = memory, make_tangent_state(memory)
    load(differentiate_starts, *arguments(march.crew[0], 0, 0))
    run_crew(march.crew, advance, lambda: None)
    return starts


def record_sensitivities(
    march: March, numbers: Array, corrections: int = CORRECTIONS
) -> tuple[Array, Array]:
    """Let a march whose starts are found record derivatives; to be called before it runs.

    numbers (R, P, I): slopes of the models' numbers by at most four inputs. Returns what the march
    will fill: the slopes (R, 4, 4) of x, y, vx, vy of the centre of mass at the end
    (L, L/T), and (R) the change of parameters that would make or break a contact.
    """
    robots, rows = march.numbers.shape
    given = aligned_zeros((robots, rows, PARAMETERS))
    given[:, :, : numbers.shape[2]] = numbers
    starts = differentiated_starts(march, given)
    flights = aligned_zeros((robots, 4, PARAMETERS))
    grazes = np.full(robots, FAR)
    for worker in march.crew:
        lanes, points = march.lanes, worker.memory.sliding_velocity.shape[0]
        worker.recorder = SensitivityRecorder(
            memory=worker.memory,
            lanes=(0,) * lanes,
            tangent=make_tangent_state(worker.memory),
            numbers=given,
            starts=starts,
            flights=flights,
            grazes=grazes,
            falling=aligned_zeros((points, lanes)),
            nearest=aligned_zeros((1, lanes)),
            most=corrections,
        )
    return flights, grazes
