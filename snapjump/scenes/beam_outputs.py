"""Outputs of recorded beams between clamps: strain, stress, and what the clamps must give."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from snapjump.declare.outputs import output
from snapjump.scenes.bending import place_bar
from snapjump.scenes.frame_body import compression
from snapjump.scenes.march_outputs import RecordedOutputs
from snapjump.statics.modes import flat_arch_damping

MARCHED = ("ok", "no_jump", "no_snap")  # to the end


@dataclass(frozen=True)
class BeamOutputs(RecordedOutputs):
    """Of one march with its trajectory: largest values are those of its samples."""

    @cached_property
    def most_bent(self) -> tuple[int, int]:
        """Sample and node of the largest bending strain."""
        strain = np.abs(self.arrays["node_strain"])
        return divmod(int(strain.argmax()), strain.shape[1])

    def _largest(self, read: str) -> float:
        return float(np.abs(self.arrays[read]).max())

    @output("1", of=MARCHED, show="beam: strain {} at most")
    def max_strain(self) -> float:
        """Largest bending strain of the beam's outer fibres, at any node and sample."""
        return self._largest("node_strain")

    @output("L", of=MARCHED, show="")
    def max_strain_at_bar(self) -> float:
        """Where that is, along the beam from the left clamp."""
        return place_bar(self.simulation.discretization, self.most_bent[1])

    @output("s", of=MARCHED, show="")
    def max_strain_time_s(self) -> float:
        """When, since the clamps began to turn."""
        return float(self.arrays["time_s"][self.most_bent[0]])

    @output("Pa", of=MARCHED, show="beam: {} of bending at most")
    def max_stress_Pa(self) -> float:
        """Largest bending stress, Young's modulus times the strain."""
        return self.simulation.robot.youngs_modulus_Pa * self.max_strain

    @output("1", of=MARCHED, unknown=True, show="beam: yields at {} times that")
    def safety_factor(self) -> float:
        """``robot.yield_stress_Pa`` over the largest bending stress; null if that is not given."""
        given = self.simulation.robot.yield_stress_Pa
        return np.nan if given is None else given / self.max_stress_Pa

    @output("N m", of=MARCHED, show="clamps: torque {} at most")
    def peak_clamp_torque_N_m(self) -> float:
        """Largest torque of a clamp on the beam, either way."""
        sides = ("clamp_left_torque_N_m", "clamp_right_torque_N_m")
        return max(self._largest(side) for side in sides)

    @output("J", of=MARCHED, show="clamps: work {}")
    def clamp_work_J(self) -> float:
        """Work of both clamps since the motion began."""
        return float(self.arrays["clamp_work_J"][-1])

    @output("W", of=MARCHED, show="clamps: power {} at most")
    def peak_clamp_power_W(self) -> float:
        """Largest power of both clamps together."""
        time_s, power = self.arrays["time_s"], 0.0
        for side in ("left", "right"):
            rate = np.gradient(self.arrays[f"clamp_{side}_rad"], time_s)
            power = power + rate * self.arrays[f"clamp_{side}_torque_N_m"]
        return float(np.max(power))

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
