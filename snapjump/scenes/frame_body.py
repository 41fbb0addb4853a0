"""Frames as bodies: masses and dimensions of leg, top, leg and of what is clamped to them."""

from typing import Any

from snapjump.checks import ParameterError
from snapjump.composition import Simulation
from snapjump.engine.work import NO_MESH
from snapjump.frame.elastic import ElasticFrame
from snapjump.frame.rigid import RigidFrame
from snapjump.options.contact import PAPER_ELEMENTS, is_per_length
from snapjump.options.frame import ElasticFrameOptions, Mesh


def inset_bar(simulation: Simulation) -> float:
    """Distance of the beam's ends from the legs (in L)."""
    if isinstance(simulation.frame, ElasticFrameOptions):
        return simulation.frame.inset_m / simulation.robot.length_m
    return 0.0


def compression(simulation: Simulation) -> float:
    """End shortening of the beam over its length: epsilon, and what the inset adds to it.

    Raises ParameterError if that is more than a beam is computed for.
    """
    total = simulation.design.epsilon + 2.0 * inset_bar(simulation)
    if total > 0.4:
        half = 0.5 * (0.4 - simulation.design.epsilon) * simulation.robot.length_m
        raise ParameterError(
            "frame.inset_m",
            simulation.frame.inset_m,
            f"a number in [0, {half:g}] m with design.epsilon = {simulation.design.epsilon:g}",
        )
    return total


def frame_model(simulation: Simulation, mount_height_bar: float) -> Any:
    """The dimensionless frame whose clamps are ``mount_height_bar`` (in L) above its feet."""
    if isinstance(simulation.frame, ElasticFrameOptions):
        return elastic_frame(simulation, mount_height_bar)
    return rigid_frame(simulation, mount_height_bar)


def frame_mesh(simulation: Simulation, frame: Any) -> Mesh:
    """The mesh that goes with a frame."""
    if isinstance(simulation.frame, ElasticFrameOptions):
        return simulation.frame.mesh(frame.mount_y / frame.top_y)
    return NO_MESH


def rigid_frame(simulation: Simulation, mount_height_bar: float) -> RigidFrame:
    """A rigid frame whose clamps are ``mount_height_bar`` (in L) above its feet.

    The robot's mass less the beam's (in rho A L) lies evenly along leg, top, leg; the clamped end
    nodes of the beam move with the frame and belong to it.
    """
    robot, mount = simulation.robot, mount_height_bar
    scales = robot.scales
    width = 1.0 - simulation.design.epsilon
    height = robot.frame_height_m / scales.length_m
    mass = simulation.environment.mass_kg(robot) / scales.mass_kg - 1.0
    end = simulation.discretization.clamped_mass_bar
    leg = mass * height / (2.0 * height + width)
    top = mass * width / (2.0 * height + width)
    total = mass + 2.0 * end
    centre = (leg * height + top * height + 2.0 * end * mount) / total
    half = 0.5 * width
    to_leg, to_mount, to_top = 0.5 * height - centre, mount - centre, height - centre
    legs = 2.0 * leg * (height * height / 12.0 + to_leg * to_leg + half * half)
    beam_ends = 2.0 * end * (half * half + to_mount * to_mount)
    inertia = legs + top * (width * width / 12.0 + to_top * to_top) + beam_ends
    return RigidFrame(
        half_span=half,
        mount_y=mount - centre,
        foot_y=-centre,
        top_y=height - centre,
        mass=total,
        inertia=inertia,
    )


def elastic_frame(simulation: Simulation, mount_height_bar: float) -> ElasticFrame:
    """An elastic frame of the rigid one's mass and outline.

    What bounces with a foot is taken from the rigid frame: its legs are far stiffer than contact.
    """
    robot, options = simulation.robot, simulation.frame
    height = robot.frame_height_m / robot.length_m
    width = 1.0 - simulation.design.epsilon
    leg_edge = height / options.leg_elements
    below = options.elements_below(mount_height_bar / height)
    above = options.leg_elements - 1 - below
    mount = mount_height_bar
    if options.mount == "edge_middle":
        mount = (below + 0.5) * leg_edge
    low, high = mount - 0.5 * leg_edge, height - mount - 0.5 * leg_edge
    if low <= 0.0 or high <= 0.0:
        raise ParameterError(
            "robot.mount_height",
            simulation.robot.mount_height,
            f"between half an edge of frame=elastic, {0.5 * leg_edge * robot.length_m:.4g} m, "
            f"and robot.frame_height_m less that",
        )
    rigid = rigid_frame(simulation, mount)
    end = simulation.discretization.clamped_mass_bar
    mass = rigid.mass + float(options.beam_on_top)
    nodes = options.contact == "nodes"
    law = simulation.contact.member(simulation.robot.scales)
    per_node = not is_per_length(simulation.contact, law)
    return ElasticFrame(
        half_span=0.5 * width,
        mount_y=mount,
        foot_y=0.0,
        top_y=height,
        mass=mass,
        bouncing_mass=1.0 / (1.0 / rigid.mass + rigid.half_span * rigid.half_span / rigid.inertia),
        low_length=low / below,
        mount_length=leg_edge,
        high_length=high / above,
        top_length=width / options.top_elements,
        density=(mass - 2.0 * end) / (2.0 * height + width),
        clamped_mass=end,
        bending=options.bending_ratio,
        stretching=options.stretching_ratio * robot.stretching_stiffness_bar,
        inset=inset_bar(simulation),
        node_weight=float(nodes and per_node),
        length_weight=float(PAPER_ELEMENTS if nodes and not per_node else 0),
        right_follow=options.right_follow,
    )
