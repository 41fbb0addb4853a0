"""``sim=bounce``: one mass falls onto the ground and bounces off, without gravity."""

import math
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from snapjump.composition import Simulation
from snapjump.declare.fields import number
from snapjump.declare.outputs import output
from snapjump.engine.status import IN_CONTACT, OK
from snapjump.results import Result
from snapjump.scenes.mass import MassOutputs, march_mass, mass_model
from snapjump.scenes.mass_units import units_of_impact
from snapjump.sim.base import NEEDS_A_GROUND, Progress, SampledScene


class BounceOutputs(MassOutputs):
    """Outputs of a bounce."""

    @cached_property
    def codes(self) -> NDArray[np.int64]:
        """How it ended: a mass that is still within a law's reach may yet gain speed, unless
        the law's impact is instantaneous."""
        contact, gap = self.model.contact, self.arrays["node_gap_m"][-1, 0]
        inside = gap < contact.reach() * self.scales.length_m and not contact.is_constraint()
        return np.where(inside & (super().codes == OK), IN_CONTACT, super().codes)

    @output("m/s", of=("ok",))
    def rebound_speed_m_s(self) -> float:
        """Velocity of the mass at the end, upwards."""
        return self.arrays["node_vy_m_s"][-1, 0]

    @output("1", of=("ok",))
    def restitution(self) -> float:
        """Rebound speed over the speed of the fall."""
        speed = self.simulation.sim.speed_m_s
        return self.rebound_speed_m_s / speed if speed else math.nan


class Bounce(SampledScene):
    """Verification: one mass falls onto the barrier at a given speed and bounces off."""

    chooses = {"frame": "fixed", "friction": "none", "damping": "none"}
    outputs = BounceOutputs
    needs = NEEDS_A_GROUND

    mass_kg: float = number(7.6e-7, above=0.0, unit="kg")
    speed_m_s: float = number(10.0, least=0.0, unit="m/s")
    duration_s: float = number(1.0e-4, above=0.0, unit="s")
    sample_interval_s: float = number(1.0e-7, above=0.0, unit="s")

    def simulate(self, simulation: Simulation, progress: Progress | None = None) -> Result:
        """Drop a mass into the barrier without gravity: a conservative bounce has restitution 1."""
        units = units_of_impact(simulation)
        model = mass_model(simulation, 0.0, 0.0, units)
        start = (0.0, float(model.contact.reach()))
        fall = (0.0, -simulation.sim.speed_m_s / units.velocity_m_s)
        return march_mass(simulation, model, start, fall, BounceOutputs, progress, units)
