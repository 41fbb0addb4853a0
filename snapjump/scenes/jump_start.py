"""A robot at the beginning of its jump: its model, and what refuses to jump.

The formulas take one robot, or many as one simulation whose numbers are arrays (R).
"""

import math
from typing import Any

import numpy as np

from snapjump.checks import ParameterError
from snapjump.composition import Simulation
from snapjump.engine.load.gravity import Gravity
from snapjump.engine.model import Model, TimeLimit
from snapjump.number.trigonometry import cos, sin
from snapjump.scenes.frame_body import compression, frame_model
from snapjump.statics.arch import StaticArch
from snapjump.statics.rounding import LostToRoundingError
from snapjump.statics.threshold import Threshold, symmetric_threshold

COMPARED = (56, 112, 224)  # elements of meshes that show whether an arch snaps
BUCKLING_LOAD = 4.0 * math.pi * math.pi  # of a straight beam between clamps (EI/L^2)

# Of the critical angle: clamps that stop earlier make no arch snap, whatever their mismatch.
TURNED_FAR = 0.85


class NoThresholdError(ParameterError):
    """The arch of this design does not snap, or not on its mesh."""


def critical(simulation: Simulation) -> Threshold:
    """The symmetric arch's critical angle and depth. Raises NoThresholdError where it has none."""
    robot, mesh = simulation.robot, simulation.discretization
    shortening = compression(simulation)
    try:
        return symmetric_threshold(robot, mesh, shortening)
    except LostToRoundingError:
        raise
    except ArithmeticError as error:
        raise no_threshold(simulation, shortening) from error


def no_threshold(simulation: Simulation, shortening: float) -> NoThresholdError:
    """Why an arch of an end shortening (over its length) has no critical angle: it does not buckle,
    its mesh does not show it, or it does not snap on any mesh."""
    robot, mesh = simulation.robot, simulation.discretization
    for elements in COMPARED:
        try:
            symmetric_threshold(robot, mesh.changed(elements=elements), shortening)
        except ArithmeticError:
            continue
        allowed = f"another mesh: with {elements} elements the arch of this design snaps"
        return NoThresholdError("discretization.elements", mesh.elements, allowed)
    epsilon, buckling = simulation.design.epsilon, BUCKLING_LOAD / robot.stretching_stiffness_bar
    allowed = "a pre-compression whose arch snaps back when its clamps turn"
    if shortening <= buckling:
        least = buckling - (shortening - epsilon)
        allowed = f"above {least:.3g}, at which the beam of this robot buckles"
    return NoThresholdError("design.epsilon", epsilon, allowed)


def fitted_mount_height_bar(epsilon: Any) -> Any:
    """The released program's heights of the clamps (in L): a fit of its own h1(epsilon)."""
    return 1.01 * (0.02951 + 0.3156 * epsilon - 0.3707 * epsilon * epsilon)


def mount_height_bar(simulation: Simulation, threshold: Threshold | None = None) -> Any:
    """Height of the clamps above the feet (in L): given, or h1(epsilon) of our static solution."""
    robot = simulation.robot
    if robot.mount_height == "fitted":
        return fitted_mount_height_bar(simulation.design.epsilon)
    if robot.mount_height != "optimal":
        return float(robot.mount_height) / robot.length_m
    return (threshold or critical(simulation)).h1_bar


def start_angle_rad(simulation: Simulation, threshold: Threshold | None = None) -> Any:
    """Left clamp angle at which the motion starts: the clamp that leads, left or right, is then at
    the same share of the critical angle."""
    share = simulation.sim.start_fraction
    alpha = (threshold or critical(simulation)).alpha_rad if share > 0.0 else 0.0
    return simulation.drive.start_rad(share * alpha - ahead(simulation))


def positive_part(value: Any) -> Any:
    """What a number has above 0."""
    return 0.5 * (abs(value) + value)


def ahead(simulation: Simulation) -> Any:
    """How far the right clamp leads the left one (rad), 0 where it lags."""
    return positive_part(-simulation.design.delta_alpha)


def loading_time(simulation: Simulation, start: Any, threshold: Threshold) -> Any:
    """Time (T) from the start of the motion until the leading clamp is at the critical angle."""
    angle = threshold.alpha_rad - ahead(simulation) - start
    return angle / (simulation.drive.rate_rad_s * simulation.robot.scales.time_s)


def leading_start(simulation: Simulation, threshold: Threshold, loading: Any) -> Any:
    """Left clamp angle a time (T) before the leading clamp is at the critical angle."""
    turned = simulation.drive.rate_rad_s * simulation.robot.scales.time_s * loading
    return threshold.alpha_rad - ahead(simulation) - turned


def least_end_rad(simulation: Simulation, threshold: Threshold, start: Any) -> Any:
    """Angle beyond which the left clamp must turn: to make the arch snap, and to turn at all."""
    return np.maximum(start, TURNED_FAR * threshold.alpha_rad - ahead(simulation))


def check_mount_height(simulation: Simulation, start: float) -> None:
    """Require a given mount height to keep the arch above the ground where the motion starts."""
    robot = simulation.robot
    if isinstance(robot.mount_height, str):
        return
    arch = StaticArch(robot, simulation.discretization, compression(simulation))
    right = start - simulation.design.delta_alpha
    state = arch.turn(arch.flat(), (0.0, 0.0), (start, right))
    depth_m = -arch.equilibrium(state, start, right).lowest * robot.length_m
    if robot.mount_height <= depth_m:
        raise ParameterError(
            "robot.mount_height",
            robot.mount_height,
            f"above {depth_m:.4g} m, or the beam starts in the ground, up to "
            f"robot.frame_height_m = {robot.frame_height_m:g} m",
        )


def jump_model(simulation: Simulation, threshold: Threshold | None = None) -> Model:
    """The dimensionless robot; its threshold is computed where it is not given.

    Raises ParameterError for a robot that cannot begin a jump.
    """
    robot = simulation.robot
    threshold = threshold or critical(simulation)
    start = start_angle_rad(simulation, threshold)
    check_mount_height(simulation, start)
    least = least_end_rad(simulation, threshold, start)
    if np.any(least >= simulation.drive.end_rad):
        why = "to make the arch snap, and beyond the start of the motion (sim.start_fraction)"
        allowed = f"above {least:.4g} rad, {why}"
        raise ParameterError("drive.end_rad", simulation.drive.end_rad, allowed)
    loading_s = loading_time(simulation, start, threshold) * robot.scales.time_s
    limit_s = positive_part(loading_s) + simulation.drive.delay_s + simulation.sim.time_limit_s
    return composed_model(simulation, start, mount_height_bar(simulation, threshold), limit_s)


def composed_model(simulation: Simulation, start: Any, mount_height: Any, limit_s: Any) -> Model:
    """The dimensionless robot that starts at an angle (rad), its clamps at a height (in L); its
    march gives up after ``limit_s``."""
    robot, scales = simulation.robot, simulation.robot.scales
    friction = simulation.friction.law(scales, simulation.environment.mu)
    return Model(
        discretization=simulation.discretization.beam(robot),
        frame=frame_model(simulation, mount_height),
        clamp=simulation.drive.programme(simulation, start),
        contact=simulation.contact.law(scales),
        friction=friction,
        damping=simulation.damping.law(scales),
        drag=simulation.drag.law_of(simulation),
        load=weight(simulation, friction),
        ground=simulation.contact.ground(scales, simulation.discretization.elements),
        time_limit=TimeLimit(limit_s / scales.time_s),
    )


def weight(simulation: Simulation, friction: Any) -> Gravity:
    """Gravity on the environment's slope, where friction holds a robot that creeps."""
    slope = simulation.environment.slope_rad
    fall = simulation.robot.gravity_m_s2 / simulation.robot.scales.acceleration_m_s2
    cosine, downhill = cos(slope), 0.0 - sin(slope)
    creep = creep_velocity(friction, downhill / cosine) if slope != 0.0 else 0.0
    return Gravity(fall, cosine, downhill, creep)


def creep_velocity(friction: Any, ratio: float) -> float:
    """Sliding velocity (in L/T) at which a law gives a friction force of so many normal forces."""
    from scipy.optimize import brentq

    fast = 1e-9
    while friction.ratio(fast) < abs(ratio):
        fast *= 2.0
    found = brentq(lambda v: friction.ratio(v) - abs(ratio), 0.0, fast, xtol=1e-20)
    return math.copysign(found, ratio)
