"""Units in which the motion of one mass on the ground is of order one.

Steps and Newton's method are judged by tolerances that are shares of the unit of length: here of
how deep a mass gets into the ground, or of how far it slides.
"""

import math
from typing import Any

from snapjump.composition import Simulation
from snapjump.number.trigonometry import cos, sin
from snapjump.units import Scales

HALVINGS = 60
SHALLOWEST = 1e-20  # of the deepest that is looked for
NEARLY_CLOSED = 1.0 - 1e-9
SLOWEST, FASTEST = 1e-20, 1e10  # L/T


def depth_of(law: Any, energy: float, deepest: float) -> float:
    """Depth (L) below a law's reach, at most ``deepest``, at which it has stored an energy (EI/L).

    By bisection of the depth's logarithm.
    """
    reach = float(law.reach())
    high = min(deepest, NEARLY_CLOSED * reach) if law.keeps_open() else deepest
    low = SHALLOWEST * high
    if law.energy(reach - high) <= energy:
        return high
    for _ in range(HALVINGS):
        depth = math.sqrt(low * high)
        if law.energy(reach - depth) > energy:
            high = depth
        else:
            low = depth
    return high


def units_of_impact(simulation: Simulation) -> Scales:
    """Of a mass that bounces: itself, its speed, and how deep it gets, or falls in the duration."""
    scene, robot = simulation.sim, simulation.robot.scales
    if scene.speed_m_s == 0.0:
        return robot
    energy = 0.5 * scene.mass_kg * scene.speed_m_s * scene.speed_m_s / robot.energy_J
    deepest = scene.speed_m_s * scene.duration_s / robot.length_m
    depth_m = depth_of(simulation.contact.law(robot), energy, deepest) * robot.length_m
    return Scales(depth_m, depth_m / scene.speed_m_s, scene.mass_kg)


def stick_speed(law: Any) -> float:
    """Speed (L/T) at which a friction law reaches half of its largest ratio, 0 without friction.

    By bisection of its logarithm.
    """
    low, high = SLOWEST, FASTEST
    full = float(law.ratio(high))
    if full == 0.0:
        return 0.0
    for _ in range(HALVINGS):
        speed = math.sqrt(low * high)
        if law.ratio(speed) > 0.5 * full:
            high = speed
        else:
            low = speed
    return high


def units_of_sliding(simulation: Simulation) -> Scales:
    """Of a mass that slides: itself, its fastest speed or that of sticking, and the time in which
    friction, drag and weight change it by as much."""
    scene, robot, environment = simulation.sim, simulation.robot, simulation.environment
    slope, gravity_m_s2 = environment.slope_rad, robot.gravity_m_s2
    brake = gravity_m_s2 * environment.mu * cos(slope)
    pull = gravity_m_s2 * abs(sin(slope))
    stick = stick_speed(simulation.friction.law(robot.scales, environment.mu))
    if stick == 0.0:
        brake = 0.0
    gained = max(pull - brake, 0.0) * scene.duration_s
    speed = max(scene.speed_m_s, gained, stick * robot.scales.velocity_m_s)
    if speed == 0.0:
        return robot.scales
    drag = float(simulation.damping.law(robot.scales).drag()) / robot.scales.time_s * speed
    time = speed / max(pull + brake + drag, speed / scene.duration_s)
    return Scales(speed * time, time, scene.mass_kg)
