"""``sim=slide``: verification: one mass slides on the ground until friction stops it."""

from snapjump.composition import Simulation
from snapjump.declare.fields import number
from snapjump.declare.outputs import output
from snapjump.results import Result
from snapjump.scenes.mass import MassOutputs, march_mass, mass_model
from snapjump.scenes.mass_units import units_of_sliding
from snapjump.sim.base import NEEDS_A_GROUND, Progress, SampledScene
from snapjump.statics.resting_gap import resting_gap


class SlideOutputs(MassOutputs):
    """Outputs of a mass that slides."""

    @output("m")
    def distance_m(self) -> float:
        """How far the mass has slid."""
        return self.arrays["node_x_m"][-1, 0]

    @output("m/s")
    def final_speed_m_s(self) -> float:
        """Velocity of the mass at the end, along the ground."""
        return self.arrays["node_vx_m_s"][-1, 0]

    @output("m")
    def resting_gap_m(self) -> float:
        """Distance from the ground at which the mass rests."""
        return self.arrays["node_y_m"][0, 0]


class Slide(SampledScene):
    """Verification: one mass slides on the ground until friction stops it.
    On a slope of the environment, of any steepness, gravity pulls it downhill too."""

    chooses = {"frame": "fixed", "friction": "implicit", "damping": "none"}
    tells = ("environment.slope_rad", "sim.mass_kg", "sim.speed_m_s", "sim.duration_s")
    outputs = SlideOutputs
    needs = NEEDS_A_GROUND

    mass_kg: float = number(4.0e-3, above=0.0, unit="kg")
    speed_m_s: float = number(0.1, least=0.0, unit="m/s")
    duration_s: float = number(0.05, above=0.0, unit="s")
    sample_interval_s: float = number(1.0e-5, above=0.0, unit="s")

    def simulate(self, simulation: Simulation, progress: Progress | None = None) -> Result:
        """Let a mass slide from its resting gap; smoothed Coulomb friction brings it to a creep."""
        scene = simulation.sim
        units = units_of_sliding(simulation)
        gravity_m_s2 = simulation.robot.gravity_m_s2
        model = mass_model(simulation, gravity_m_s2, simulation.environment.slope_rad, units)
        weight = scene.mass_kg / units.mass_kg * model.load.gravity()
        start = (0.0, resting_gap(model.contact, weight, 1.0))
        velocity = (scene.speed_m_s / units.velocity_m_s, 0.0)
        return march_mass(simulation, model, start, velocity, SlideOutputs, progress, units)
