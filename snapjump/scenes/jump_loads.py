"""Outputs of recorded jumps: force and impulse of the ground, and what of the energy is height."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from snapjump.declare.outputs import output
from snapjump.scenes.beam_outputs import MARCHED, BeamOutputs

FLOWN = ("ok",)


@dataclass(frozen=True)
class JumpLoads(BeamOutputs):
    """Of one jump with its trajectory, beside those of all jumps."""

    @output("N", of=MARCHED, unknown=True, show="ground: force {} at most")
    def peak_ground_force_N(self) -> float:
        """Largest normal force of the ground on the robot, of all samples; null where contact is a
        constraint, whose forces are none of a state's."""
        if "node_normal_N" not in self.arrays:
            return np.nan
        sums = (self.arrays[f"{of}_normal_N"].sum(axis=1) for of in ("node", "corner"))
        return float(sum(sums).max())

    @output("N s", of=MARCHED, show="ground: impulse {}")
    def ground_impulse_N_s(self) -> float:
        """Impulse of the ground on the robot, across the ground, since the motion began."""
        return float(self.arrays["ground_impulse_y_N_s"][-1])

    @output("1", of=FLOWN, show="energy: {} of what clamps and arch gave is height at the apex")
    def efficiency(self: Any) -> float:
        """Potential energy that the robot gains up to its apex, over the clamps' work and the
        elastic energy that the beam lost until lift-off."""
        kept, environment = self.arrays, self.simulation.environment
        robot, start = self.simulation.robot, self.arrays["com_y_m"][0]
        weight_N = environment.mass_kg(robot) * robot.gravity_m_s2
        elastic = kept["elastic_J"]
        off = int(np.searchsorted(kept["time_s"], float(self.liftoff_time_s[0])))
        given_J = kept["clamp_work_J"][-1] + elastic[0] - elastic[min(off, len(elastic) - 1)]
        return float(weight_N * (self.y_world_bar[0] * robot.length_m - start) / given_J)
