"""The march of one robot that jumps: what is the same whatever is recorded of it."""

from collections.abc import Callable
from typing import Any

from snapjump.composition import Simulation
from snapjump.ending.flight import FlightEnding
from snapjump.engine import clock as c
from snapjump.engine.model import Model
from snapjump.recorder.none import NoRecorder
from snapjump.scenes.card_march import march_on
from snapjump.scenes.flight_check import checked_status
from snapjump.scenes.march_outputs import side_by_side
from snapjump.scenes.resting import resting_guess
from snapjump.scenes.runner import Array, March, Progress


def no_recorder(coordinates: int) -> NoRecorder:
    """Nothing is recorded."""
    return NoRecorder()


def jump_march(
    simulation: Simulation,
    model: Model,
    recorder: Callable[[int], Any] = no_recorder,
    lanes: int = 1,
) -> March:
    """A robot at the start of its motion, which is found, on the simulation's backend.

    ``recorder`` makes a recorder for so many coordinates.
    """
    state = resting_guess(simulation, model)
    march = march_on(simulation)(
        models=[model],
        masses=simulation.discretization.masses(),
        states=state[None, :],
        simulation=simulation,
        ending=FlightEnding(),
        recorder=recorder(len(state)),
        lanes=lanes,
        mesh=simulation.frame.mesh(model.frame),
    )
    march.find_starts()
    return march


def jumped(march: March, progress: Progress | None = None) -> tuple[Model, Array]:
    """What becomes of a march's robots: their models side by side, and their outcomes (R, ROWS),
    in which a flight that cannot be true is no success."""
    outcome = march.run(progress)
    side = side_by_side(march.models, range(len(march.models)), len(march.models))
    outcome[:, c.STATUS] = checked_status(side, float(march.masses.sum()), outcome)
    return side, outcome
