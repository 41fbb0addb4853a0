"""Outputs of recorded beams between clamps: what they bore, at their samples, and their damping."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from snapjump.declare.outputs import output
from snapjump.scenes.beam_loads import MARCHED, BeamLoads, Bending, Clamping
from snapjump.scenes.frame_body import compression
from snapjump.scenes.march_outputs import RecordedOutputs
from snapjump.statics.modes import flat_arch_damping


class DampingOutputs(RecordedOutputs):
    """Of one march of a beam: what its damping law makes of the arch's vibrations."""

    @cached_property
    def damping_ratios(self) -> tuple[float, float]:
        """Of the first two modes."""
        one = self.simulation
        law, shortening = one.damping.law(one.robot.scales), float(compression(one))
        try:
            first, second = flat_arch_damping(one.robot, one.discretization, law, shortening)
        except ArithmeticError:  # no stable arch stands between flat clamps
            return np.nan, np.nan
        return float(first), float(second)

    @output("1", of=MARCHED, unknown=True, show="damping: {} of critical in the first mode")
    def damping_ratio_1(self) -> float:
        """Share of critical damping that the damping law gives the first mode of the arch between
        flat clamps; null where none stands."""
        return self.damping_ratios[0]

    @output("1", of=MARCHED, unknown=True, show="damping: {} in the second")
    def damping_ratio_2(self) -> float:
        """The same of the second mode."""
        return self.damping_ratios[1]


@dataclass(frozen=True)
class BeamOutputs(BeamLoads, DampingOutputs):
    """Of one march with its trajectory: largest values are those of its samples."""

    def _largest(self, read: str) -> float:
        return float(np.abs(self.arrays[read]).max())

    @property
    def bending(self) -> Bending:
        """Of all samples and nodes."""
        strain = np.abs(self.arrays["node_strain"])
        sample, node = divmod(int(strain.argmax()), strain.shape[1])
        along_bar = node / self.simulation.discretization.elements
        return Bending(float(strain.max()), along_bar, float(self.arrays["time_s"][sample]))

    @property
    def clamping(self) -> Clamping:
        """Torque and power of all samples; the work of all stages."""
        sides = ("clamp_left_torque_N_m", "clamp_right_torque_N_m")
        torque = max(self._largest(side) for side in sides)
        time_s, power = self.arrays["time_s"], 0.0
        for side in ("left", "right"):
            rate = np.gradient(self.arrays[f"clamp_{side}_rad"], time_s)
            power = power + rate * self.arrays[f"clamp_{side}_torque_N_m"]
        if not self.simulation.drive.turns:  # clamps that move apart work too
            power = np.gradient(self.arrays["clamp_work_J"], time_s)
        return Clamping(torque, float(self.arrays["clamp_work_J"][-1]), float(np.max(power)))
