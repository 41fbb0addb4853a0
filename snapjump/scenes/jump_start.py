"""A robot at the beginning of its jump: its model and the first guess of its equilibrium."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from snapjump.checks import ParameterError
from snapjump.clamp.constant_rate import ConstantRate
from snapjump.composition import Simulation
from snapjump.contact.base import (
    at_rest,
    contact_reach,
    contact_weights,
    force_if_acting,
    keeps_open,
)
from snapjump.discretization.base import clamp_offset
from snapjump.engine.model import Model
from snapjump.frame.base import frame_dofs, rest_frame
from snapjump.load.gravity import Gravity
from snapjump.scenes.frame_body import compression, frame_mesh, frame_model
from snapjump.statics.arch import StaticArch
from snapjump.statics.chain_state import chain_state
from snapjump.statics.elastica import buckled_arch, resampled
from snapjump.statics.threshold import Threshold, symmetric_threshold

Array = NDArray[np.float64]


def critical(simulation: Simulation) -> Threshold:
    """The symmetric arch's critical angle and depth. Raises ParameterError where it has none."""
    robot, mesh = simulation.robot, simulation.discretization
    shortening = compression(simulation)
    try:
        return symmetric_threshold(robot, mesh, shortening)
    except (ArithmeticError, ValueError) as error:  # numpy's LinAlgError is a ValueError
        raise ParameterError(
            "design.epsilon",
            simulation.design.epsilon,
            f"a pre-compression that buckles the beam of this robot and mesh "
            f"({mesh.elements} elements), and that snaps back when its clamps turn",
        ) from error


def fitted_mount_height_bar(epsilon: float) -> float:
    """The released program's height of the clamps (in L): a fit of its own h1(epsilon)."""
    return 1.01 * (0.02951 + 0.3156 * epsilon - 0.3707 * epsilon**2)


def mount_height_bar(simulation: Simulation) -> float:
    """Height of the clamps above the feet (in L): given, or h1(epsilon) of our static solution."""
    robot = simulation.robot
    if robot.mount_height == "fitted":
        return fitted_mount_height_bar(simulation.design.epsilon)
    if robot.mount_height != "optimal":
        return float(robot.mount_height) / robot.length_m
    return critical(simulation).h1_bar


def resting_gap(contact: Any, weight: float, points: float) -> float:
    """Gap (in L) at which a law carries a weight (in EI/L^2) at so many points."""
    if weight == 0.0:
        return float(contact_reach(contact))

    from scipy.optimize import brentq

    def surplus(gap: float) -> float:
        return points * float(force_if_acting(contact, gap, at_rest(gap))[1]) - weight

    reach = float(contact_reach(contact))
    low = 1e-12 * reach
    if not keeps_open(contact):
        low = reach - 1e-9
        while surplus(low) < 0.0:
            low -= reach - low
    return float(brentq(surplus, low, reach, xtol=1e-15 * (reach - low), rtol=1e-14))


def start_angle_rad(simulation: Simulation) -> float:
    """Left clamp angle at which the motion starts: the clamp that leads, left or right, is then at
    the same share of the critical angle."""
    if simulation.sim.start_fraction == 0.0:
        return 0.0
    ahead = max(0.0, -simulation.design.delta_alpha)
    return simulation.sim.start_fraction * critical(simulation).alpha_rad - ahead


def check_mount_height(simulation: Simulation, start: float) -> None:
    """Require a given mount height to keep the arch above the ground where the motion starts."""
    robot = simulation.robot
    if isinstance(robot.mount_height, str):
        return
    arch = StaticArch(robot, simulation.discretization, compression(simulation))
    state = arch.settle(arch.guess(), 0.0, 0.0)
    steps = max(8, int(np.ceil(start / 0.05)))
    right = start - simulation.design.delta_alpha
    for k in range(1, steps + 1):
        state = arch.settle(state, start * k / steps, right * k / steps)
    depth_m = -arch.equilibrium(state, start, right).lowest * robot.length_m
    if robot.mount_height <= depth_m:
        raise ParameterError(
            "robot.mount_height",
            robot.mount_height,
            f"above {depth_m:.4g} m, or the beam starts in the ground, up to "
            f"robot.frame_height_m = {robot.frame_height_m:g} m",
        )


def jump_model(simulation: Simulation) -> Model:
    """The dimensionless robot."""
    robot, scales = simulation.robot, simulation.robot.scales
    start = start_angle_rad(simulation)
    check_mount_height(simulation, start)
    if start >= robot.rotation_end_rad:
        raise ParameterError(
            "robot.rotation_end_rad",
            robot.rotation_end_rad,
            f"above {start:.4g} rad, where the motion starts (sim.start_fraction)",
        )
    return Model(
        discretization=simulation.discretization.member(robot),
        frame=frame_model(simulation, mount_height_bar(simulation)),
        clamp=ConstantRate(
            start=start,
            end=robot.rotation_end_rad,
            rate=robot.rotation_rate_rad_s * scales.time_s,
            delta_alpha=simulation.design.delta_alpha,
        ),
        contact=simulation.contact.member(scales, simulation.discretization),
        friction=simulation.friction.member(scales, simulation.environment.mu),
        damping=simulation.damping.member(scales),
        load=Gravity(robot.gravity_m_s2 / scales.acceleration_m_s2),
    )


def resting_guess(simulation: Simulation, model: Model) -> Array:
    """State of the robot at rest with flat clamps: frame, then nodes (2 or 3 each)."""
    discretization = simulation.discretization
    frame = model.frame
    weight = (frame.mass + float(np.sum(discretization.masses()))) * model.load.acceleration
    _, by_corner = contact_weights(model.contact)
    gap = resting_gap(model.contact, weight, 2.0 * by_corner)
    x, y = buckled_arch(compression(simulation), discretization.elements)
    chain = discretization.moving_elements
    skipped = clamp_offset(model.discretization)
    beam = chain_state(
        model.discretization,
        resampled(x, skipped, chain),
        resampled(y, skipped, chain) + (gap - frame.foot_y) + frame.mount_y,
    )
    mesh = frame_mesh(simulation, frame)
    state = np.concatenate([np.zeros(frame_dofs(frame, mesh)), beam])
    rest_frame(frame, mesh, state, gap)
    return state
