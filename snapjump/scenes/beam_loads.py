"""Outputs of beams between clamps: strain, stress, and what the clamps must give."""

from typing import Any, NamedTuple

from snapjump.declare.outputs import output
from snapjump.scenes.bending import clamped_bar
from snapjump.scenes.march_outputs import MarchOutputs

MARCHED = ("ok", "no_jump", "no_snap")  # to the end


class Bending(NamedTuple):
    """The largest bending strain of a beam's outer fibres, its distance along the chain from its
    first node (L), and when (s, since the clamps began to turn)."""

    strain: Any
    along_bar: Any
    time_s: Any


class Clamping(NamedTuple):
    """Of both clamps: the larger one's largest torque (N m), work (J) and largest power (W)."""

    torque_N_m: Any
    work_J: Any
    power_W: Any


class BeamLoads(MarchOutputs):
    """Of marches whose ``bending`` and ``clamping`` have been recorded."""

    @property
    def bending(self) -> Bending:
        """How far the beams were bent."""
        raise NotImplementedError

    @property
    def clamping(self) -> Clamping:
        """What the clamps gave."""
        raise NotImplementedError

    @output("1", of=MARCHED, reads=("bending",), show="beam: strain {} at most")
    def max_strain(self) -> Any:
        """Largest bending strain of the beam's outer fibres, at any node and step."""
        return self.bending.strain

    @output("L", of=MARCHED, reads=("bending",), show="")
    def max_strain_at_bar(self) -> Any:
        """Where that is, along the beam from the left clamp."""
        return self.bending.along_bar + clamped_bar(self.simulation.discretization)

    @output("s", of=MARCHED, reads=("bending",), show="")
    def max_strain_time_s(self) -> Any:
        """When, since the clamps began to turn."""
        return self.bending.time_s

    @output("Pa", of=MARCHED, reads=("bending",), show="beam: {} of bending at most")
    def max_stress_Pa(self) -> Any:
        """Largest bending stress, Young's modulus times the strain."""
        return self.of_each(lambda one: one.robot.youngs_modulus_Pa) * self.max_strain

    @output("1", of=MARCHED, unknown=True, reads=("bending",), show="beam: yields at {} times that")
    def safety_factor(self) -> Any:
        """``robot.yield_stress_Pa`` over the largest bending stress; null if that is not given."""
        return self.of_each(yield_stress_Pa) / self.max_stress_Pa

    @output("N m", of=MARCHED, reads=("clamping",), show="clamps: torque {} at most")
    def peak_clamp_torque_N_m(self) -> Any:
        """Largest torque of a clamp on the beam, either way."""
        return self.clamping.torque_N_m

    @output("J", of=MARCHED, reads=("clamping",), show="clamps: work {}")
    def clamp_work_J(self) -> Any:
        """Work of both clamps since the motion began."""
        return self.clamping.work_J

    @output("W", of=MARCHED, reads=("clamping",), show="clamps: power {} at most")
    def peak_clamp_power_W(self) -> Any:
        """Largest power of both clamps together."""
        return self.clamping.power_W


def yield_stress_Pa(one: Any) -> Any:
    """The yield stress of a simulation's beam; NaN if it is not given."""
    given = one.robot.yield_stress_Pa
    return float("nan") if given is None else given
