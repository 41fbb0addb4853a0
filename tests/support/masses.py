"""One mass above the ground."""

from snapjump import Result
from snapjump.composition import Simulation
from snapjump.scenes.mass import march_mass, mass_model
from snapjump.sim.bounce import BounceOutputs


def thrown(
    simulation: Simulation, height_m: float, speed_m_s: float, gravity_m_s2: float = 0.0
) -> Result:
    """What becomes of it downwards from a height."""
    scales = simulation.robot.scales
    model = mass_model(simulation, gravity_m_s2, 0.0)
    start = (0.0, height_m / scales.length_m)
    fall = (0.0, -speed_m_s / scales.velocity_m_s)
    return march_mass(simulation, model, start, fall, BounceOutputs, None)
