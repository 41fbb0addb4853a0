"""``sim=drop``: a mass falls on the ground under its weight, and bounces."""

from snapjump.composition import Simulation
from snapjump.declare.fields import Need, number
from snapjump.declare.outputs import output
from snapjump.results import Result
from snapjump.scenes.mass import MassOutputs, march_mass, mass_model
from snapjump.sim.base import HELD, ONE_AT_A_TIME, Progress, SceneOptions


class DropOutputs(MassOutputs):
    """Of a mass that is dropped."""

    @output("m")
    def highest_rebound_m(self) -> float:
        """Largest height above the ground after the first touch."""
        heights = self.arrays["node_y_m"][:, 0]
        return float(heights[int(heights.argmin()) :].max())


class Drop(SceneOptions):
    """A mass falls on the ground under its weight, and bounces."""

    outputs = DropOutputs
    chooses = {"frame": "fixed", "friction": "none", "damping": "none"}
    needs = (Need("contact", "pushes"), HELD, ONE_AT_A_TIME)

    mass_kg: float = number(4.0e-3, above=0.0, unit="kg")
    height_m: float = number(0.01, above=0.0, unit="m")
    duration_s: float = number(0.1, above=0.0, unit="s")
    sample_interval_s: float = number(1.0e-4, above=1e-6, unit="s")

    def simulate(self, simulation: Simulation, progress: Progress | None = None) -> Result:
        model = mass_model(simulation, simulation.robot.gravity_m_s2, 0.0)
        start = (0.0, self.height_m / simulation.robot.length_m)
        return march_mass(simulation, model, start, (0.0, 0.0), DropOutputs, progress)
