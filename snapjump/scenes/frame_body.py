"""The rigid frame as a body: mass, centre and inertia of leg, top, leg and the clamped nodes."""

from snapjump.composition import Simulation
from snapjump.frame.rigid import RigidFrame


def rigid_frame(simulation: Simulation, mount_height_bar: float) -> RigidFrame:
    """The dimensionless frame whose clamps are ``mount_height_bar`` (in L) above its feet.

    The robot's mass less the beam's lies evenly along leg, top, leg; the clamped end nodes of
    the beam move with it and belong to it.
    """
    robot = simulation.robot
    scales = robot.scales
    width = 1.0 - simulation.design.epsilon
    height = robot.frame_height_m / scales.length_m
    mass = simulation.environment.mass_kg(robot) / scales.mass_kg - 1.0
    end = simulation.discretization.clamped_mass_bar
    leg = mass * height / (2.0 * height + width)
    top = mass * width / (2.0 * height + width)
    total = mass + 2.0 * end
    centre = (leg * height + top * height + 2.0 * end * mount_height_bar) / total
    half = 0.5 * width
    legs = 2.0 * leg * (height**2 / 12.0 + (0.5 * height - centre) ** 2 + half**2)
    beam_ends = 2.0 * end * (half**2 + (mount_height_bar - centre) ** 2)
    inertia = legs + top * (width**2 / 12.0 + (height - centre) ** 2) + beam_ends
    return RigidFrame(
        half_span=half,
        mount_y=mount_height_bar - centre,
        foot_y=-centre,
        top_y=height - centre,
        mass=total,
        inertia=inertia,
    )
