"""Outputs of recorded beams between clamps: what they bore, and their damping."""

from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from snapjump.declare.outputs import output
from snapjump.scenes.beam_loads import MARCHED, BeamLoads, Bending, Clamping
from snapjump.scenes.bending import strain_per_turning
from snapjump.scenes.every_step import EveryStep
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
    """Of one march with its trajectory. ``every``: what was read off all of its steps."""

    every: EveryStep = field(kw_only=True)

    @property
    def bending(self) -> Bending:
        """Of all steps and nodes."""
        steps, begun = self.every, self.model.clamp.time_turned()
        return Bending(
            strain_per_turning(self.simulation) * steps.turning,
            steps.node / self.simulation.discretization.elements,
            (steps.when + begun) * self.scales.time_s,
        )

    @property
    def clamping(self) -> Clamping:
        """Torque of all steps, work of all stages; power of all samples, which hardly changes."""
        time_s, power = self.arrays["time_s"], 0.0
        for side in ("left", "right"):
            rate = np.gradient(self.arrays[f"clamp_{side}_rad"], time_s)
            power = power + rate * self.arrays[f"clamp_{side}_torque_N_m"]
        if not self.simulation.drive.turns:  # clamps that move apart work too
            power = np.gradient(self.arrays["clamp_work_J"], time_s)
        torque_N_m = self.every.torque * self.scales.energy_J
        return Clamping(torque_N_m, float(self.arrays["clamp_work_J"][-1]), float(np.max(power)))
