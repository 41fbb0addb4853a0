"""The march of robots that jump: what is the same whatever is recorded of them."""

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from snapjump.composition import Simulation
from snapjump.engine import outcome as c
from snapjump.engine.model import Model
from snapjump.engine.recorder.none import NoRecorder
from snapjump.engine.termination.flight import FlightTermination
from snapjump.scenes.card_march import march_on
from snapjump.scenes.flight_check import checked_status
from snapjump.scenes.frame_body import compression
from snapjump.scenes.march_outputs import side_by_side
from snapjump.scenes.resting import resting_guesses
from snapjump.scenes.runner import Array, March, Progress

UNTIL_FLIGHT = FlightTermination()


def no_recorder(coordinates: int) -> NoRecorder:
    """Nothing is recorded."""
    return NoRecorder()


def jump_march(
    simulations: Sequence[Simulation], models: Sequence[Model], **settings: Any
) -> March:
    """Robots of one composition and mesh, about to be put at the start of their motion.

    ``settings``: those of :func:`march_from_rest`.
    """
    compressions = np.array([compression(simulation) for simulation in simulations])
    return march_from_rest(simulations[0], models, compressions, **settings)


def march_from_rest(
    base: Simulation,
    models: Sequence[Model],
    compressions: Array,
    *,
    termination: Any = UNTIL_FLIGHT,
    recorder: Callable[[int], Any] = no_recorder,
    **settings: Any,
) -> March:
    """The same of models (R) and the end shortenings (R) of their beams; ``base``: any of the
    robots, or what they have in common.

    ``recorder`` makes a recorder for so many coordinates; ``settings``: lanes, threads and most
    iterations of the march, which is on the backend of ``base``.
    """
    states = resting_guesses(base, models, compressions)
    return march_on(base)(
        models=models,
        masses=base.discretization.masses(),
        states=states,
        simulation=base,
        termination=termination,
        recorder=recorder(states.shape[1]),
        mesh=base.frame.mesh(models[0].frame),
        **settings,
    )


def jumped(march: March, progress: Progress | None = None) -> tuple[Model, Array]:
    """Run a march and read it: its robots' models side by side, and their outcomes (R, COLUMNS),
    in which a flight that cannot be true is no success."""
    outcome = march.run(progress)
    side = side_by_side(march.models, range(len(march.models)), len(march.models))
    outcome[:, c.STATUS] = checked_status(side, float(march.masses.sum()), outcome)
    return side, outcome
