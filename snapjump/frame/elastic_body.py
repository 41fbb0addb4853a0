"""The elastic frame as a body: its numbers, mass, place, outline and points of contact."""

from typing import Any, NamedTuple

from snapjump.discretization.edge import make_edge
from snapjump.frame.base import (
    FrameBox,
    contact_point,
    contact_points,
    corner_point,
    frame_box,
    frame_mass,
    frame_moments,
    point_mass,
    point_weight,
    rest_frame,
    slide_frame,
)
from snapjump.frame.elastic_mesh import (
    LEFT_CORNER,
    RIGHT_CORNER,
    corner_node,
    edge_length,
    node_count,
    node_mass,
    weight_at,
)


class ElasticFrame(NamedTuple):
    """Half the width; heights of mounts, feet and top above the feet (in L); mass of the frame
    (rho A L) and what of it bounces with a foot; lengths of an edge below, at and above a mount,
    and of the top (L); mass per length (rho A) and clamped at either mount; bending stiffness
    (EI) and stretching stiffness (EI/L^2); distance of the beam's ends from the legs (L); weights
    of contact at a node and, per length, at what belongs to it (1/L); share of its
    leg's bending that the right clamp turns with."""

    half_span: float
    mount_y: float
    foot_y: float
    top_y: float
    mass: float
    bouncing_mass: float
    low_length: float
    mount_length: float
    high_length: float
    top_length: float
    density: float
    clamped_mass: float
    bending: float
    stretching: float
    inset: float
    node_weight: float
    length_weight: float
    right_follow: float


@contact_points.member(ElasticFrame)
def _contact_points(frame: ElasticFrame, mesh: Any) -> Any:
    return node_count(mesh)


@contact_point.member(ElasticFrame)
def _contact_point(frame: ElasticFrame, mesh: Any, point: Any, state: Any, velocity: Any) -> Any:
    i = 2 * point
    return state[i], state[i + 1], velocity[i], velocity[i + 1]


@point_mass.member(ElasticFrame)
def _point_mass(frame: ElasticFrame, mesh: Any, point: Any, state: Any) -> Any:
    return frame.bouncing_mass


@point_weight.member(ElasticFrame)
def _point_weight(frame: ElasticFrame, mesh: Any, point: Any, contact: Any) -> Any:
    return weight_at(frame, mesh, point, contact)


@corner_point.member(ElasticFrame)
def _corner_point(frame: ElasticFrame, mesh: Any, corner: Any, state: Any, velocity: Any) -> Any:
    i = 2 * corner_node(mesh, corner)
    return state[i], state[i + 1], velocity[i], velocity[i + 1]


@frame_box.member(ElasticFrame)
def _frame_box(frame: ElasticFrame, mesh: Any, state: Any, velocity: Any) -> FrameBox:
    i = 2 * mesh[LEFT_CORNER]
    k = 2 * mesh[RIGHT_CORNER]
    top = make_edge(
        state[k] - state[i],
        state[k + 1] - state[i + 1],
        velocity[k] - velocity[i],
        velocity[k + 1] - velocity[i + 1],
    )
    return FrameBox(
        0.5 * (state[i] + state[k]),
        0.5 * (state[i + 1] + state[k + 1]),
        top.cx,
        top.cy,
        top.turn_rate,
        frame.half_span,
        frame.mount_y - frame.top_y,
        frame.foot_y - frame.top_y,
        0.0 * frame.top_y,
    )


@rest_frame.member(ElasticFrame)
def _rest_frame(frame: ElasticFrame, mesh: Any, state: Any, gap: Any) -> None:
    x = -frame.half_span
    y = gap
    for node in range(node_count(mesh)):
        state[2 * node] = x
        state[2 * node + 1] = y
        if node < node_count(mesh) - 1:
            length = edge_length(frame, mesh, node)
            if node < mesh[LEFT_CORNER]:
                y = y + length
            elif node < mesh[RIGHT_CORNER]:
                x = x + length
            else:
                y = y - length


@frame_mass.member(ElasticFrame)
def _frame_mass(frame: ElasticFrame, mesh: Any, coordinate: Any) -> Any:
    return node_mass(frame, mesh, coordinate // 2)


@frame_moments.member(ElasticFrame)
def _frame_moments(frame: ElasticFrame, mesh: Any, vector: Any) -> Any:
    x = 0.0 * vector[0]
    y = 0.0 * vector[0]
    for node in range(node_count(mesh)):
        mass = node_mass(frame, mesh, node)
        x = x + mass * vector[2 * node]
        y = y + mass * vector[2 * node + 1]
    return x, y


@slide_frame.member(ElasticFrame)
def _slide_frame(frame: ElasticFrame, mesh: Any, vector: Any, along_x: Any) -> None:
    for node in range(node_count(mesh)):
        vector[2 * node] = vector[2 * node] + along_x
