"""Outputs of jumps: force and impulse of the ground, and what of the energy is height."""

from typing import Any, NamedTuple

from snapjump.declare.outputs import output
from snapjump.scenes.beam_loads import MARCHED, BeamLoads

FLOWN = ("ok",)


class Release(NamedTuple):
    """Height of the centre of mass at the start (m), and the elastic energy that the robot has lost
    at its last contact (J)."""

    start_m: Any
    released_J: Any


class JumpLoads(BeamLoads):
    """Of jumps whose ``push``, ``impulse`` and ``release`` have been recorded, too."""

    @property
    def push(self) -> Any:
        """The largest normal force of the ground (N)."""
        raise NotImplementedError

    @property
    def impulse(self) -> Any:
        """The impulse of the ground (N s)."""
        raise NotImplementedError

    @property
    def release(self) -> Release:
        """What the energy of height comes from, beside the clamps' work."""
        raise NotImplementedError

    @output("N", of=MARCHED, unknown=True, reads=("push",), show="ground: force {} at most")
    def peak_ground_force_N(self) -> Any:
        """Largest normal force of the ground on the robot at any step; null where contact is a
        constraint, whose forces are none of a state's."""
        return self.push

    @output("N s", of=MARCHED, reads=("impulse",), show="ground: impulse {}")
    def ground_impulse_N_s(self) -> Any:
        """Impulse of the ground on the robot, across the ground, since the motion began."""
        return self.impulse

    @output(
        "1",
        of=FLOWN,
        reads=("clamping", "release"),
        show="energy: {} of what clamps and arch gave is height at the apex",
    )
    def efficiency(self: Any) -> Any:
        """Potential energy that the robot gains up to its apex, over the clamps' work and the
        elastic energy that the beam lost until lift-off."""
        weight_N = self.of_each(lambda one: mass_kg(one) * one.robot.gravity_m_s2)
        rise_m = self.y_world_bar * self.scales.length_m - self.release.start_m
        return weight_N * rise_m / (self.clamp_work_J + self.release.released_J)


def mass_kg(one: Any) -> Any:
    """Mass of a simulation's robot."""
    return one.environment.mass_kg(one.robot)
