"""One jump as the handful of numbers that convergence is judged by."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from snapjump.composition import Simulation
from snapjump.declare.outputs import output
from snapjump.engine.recorder.observables import make_observables
from snapjump.scenes.between_steps import crossing, peak
from snapjump.scenes.jump_march import jump_march, jumped
from snapjump.scenes.jump_outputs import JumpOutputs
from snapjump.scenes.jump_start import jump_model

Array = NDArray[np.float64]
# 150 bytes for each of them at most; untouched memory costs nothing.
MOST_STEPS = 4_000_000


@dataclass(frozen=True)
class ObservedJump(JumpOutputs):
    """A jump whose steps have been watched. ``times``, ``heights``, ``forces``: of each step, its
    end (T), the beam's middle above the line of its mounts (L), the ground's normal force
    (EI/L^2)."""

    times: Array
    heights: Array
    forces: Array

    @output("s")
    def snap_time_s(self) -> Array:
        """When the beam's middle passes the line of its mounts, since the clamps began to turn."""
        begun = self.model.clamp.time_turned()
        return (crossing(self.times, self.heights) + begun) * self.simulation.robot.scales.time_s

    @output("N")
    def peak_force_N(self) -> float:
        """Largest normal force of the ground on the robot."""
        return peak(self.times, self.forces) * self.simulation.robot.scales.force_N

    @output("m/s")
    def liftoff_speed_m_s(self) -> Array:
        """Speed of the centre of mass at the last contact."""
        return np.hypot(self.liftoff_vx_m_s, self.liftoff_vy_m_s)


def observe_jump(simulation: Simulation) -> dict[str, Any]:
    """Simulate a jump; its figures by name, those of :class:`ObservedJump` among them, NaN where
    there is none."""
    model = jump_model(simulation)
    march = jump_march([simulation], [model], recorder=lambda size: make_observables(MOST_STEPS))
    march.find_starts()
    (side, outcome), recorder = jumped(march), march.recorder
    count = min(int(recorder.filled[0]), MOST_STEPS)
    watched = (recorder.times[:count], recorder.heights[:count], recorder.forces[:count])
    return ObservedJump(simulation, side, outcome, march.kernel_seconds, *watched).rows()[0]
