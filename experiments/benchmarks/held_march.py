"""The march of ``sim=snap`` with another beginning, and clamps that another programme turns."""

from dataclasses import replace
from typing import Any

from snapjump.arrays import Array
from snapjump.composition import Simulation
from snapjump.engine import outcome as c
from snapjump.engine.recorder.midpoint import make_midpoint_recorder
from snapjump.engine.recorder.trajectory import make_recorder
from snapjump.engine.status import NAMES
from snapjump.engine.termination.timed import TimedTermination
from snapjump.scenes.midpoint import Midpoint
from snapjump.scenes.snap_march import snap_march

SAMPLES = 20  # of the trajectory, which is not looked at


def crossing_of(
    simulation: Simulation, clamp: Any, state: Array, duration: float
) -> tuple[str, float]:
    """How it ended, and when (T) the midpoint crossed the line of the clamps, NaN if it did not.

    Of an arch at rest in a state, followed for a duration (T); ``clamp``: a member of
    :class:`snapjump.drive.base.Programme`.
    """

    def recorder(size: int, steps: int) -> Any:
        return make_midpoint_recorder(make_recorder(size, duration, duration / SAMPLES), steps)

    march = snap_march(simulation, recorder)
    march = replace(
        march,
        models=[march.models[0]._replace(clamp=clamp)],
        states=state[None, :],
        termination=TimedTermination(duration),
    )
    ended = march.run()[0]
    scales = simulation.robot.scales
    crossing = Midpoint.of(march.recorder, scales).crossing_s / scales.time_s
    return NAMES[int(ended[c.STATUS])], crossing
