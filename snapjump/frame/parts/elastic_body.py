"""The elastic frame as a body: its numbers, mass, place, outline and points of contact."""

from typing import Any

from snapjump.discretization.parts.edge import make_edge
from snapjump.frame.base import Frame, FrameBox
from snapjump.frame.parts.elastic_mesh import (
    LEFT_CORNER,
    RIGHT_CORNER,
    corner_node,
    edge_length,
    node_count,
    node_mass,
    weight_at,
)
from snapjump.frame.parts.point_mass import rotation_of
from snapjump.linear_solver.contact_rows import NodeRows
from snapjump.number.nowhere import nowhere


class ElasticBody(Frame):
    """The elastic frame as a body."""

    bouncing_mass: Any
    mass: Any
    half_span: Any
    mount_y: Any
    foot_y: Any
    top_y: Any

    def contact_points(self, mesh: Any) -> Any:
        return node_count(mesh)

    def contact_point(self, mesh: Any, point: Any, state: Any, velocity: Any) -> Any:
        i = 2 * point
        return state[i], state[i + 1], velocity[i], velocity[i + 1]

    def stage_point(self, point: Any, work: Any, rate: Any) -> Any:
        i = 2 * point
        gap = work.state[i + 1]
        vx = (work.state[i] - work.position_predictor[i]) * rate
        return gap, vx, (gap - work.position_predictor[i + 1]) * rate

    def fall(self, mesh: Any, point: Any, state: Any, drop: Any) -> Any:
        return state[2 * point + 1], drop[2 * point + 1]

    def contact_rows(self, point: Any, work: Any, rate: Any) -> NodeRows:
        band = work.frame_band
        return NodeRows(work.frame_residual, band, nowhere(), 2 * point)

    def point_mass(self, mesh: Any, point: Any, state: Any) -> Any:
        return self.bouncing_mass

    def point_share(self, mesh: Any, point: Any, ground: Any) -> Any:
        return weight_at(self, mesh, point, ground)

    def corner_point(self, mesh: Any, corner: Any, state: Any, velocity: Any) -> Any:
        i = 2 * corner_node(mesh, corner)
        return state[i], state[i + 1], velocity[i], velocity[i + 1]

    def box(self, mesh: Any, state: Any, velocity: Any) -> FrameBox:
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
            self.half_span,
            self.mount_y - self.top_y,
            self.foot_y - self.top_y,
            0.0 * self.top_y,
        )

    def rest(self, mesh: Any, state: Any, gap: Any) -> None:
        x = -self.half_span
        y = gap
        for node in range(node_count(mesh)):
            state[2 * node] = x
            state[2 * node + 1] = y
            if node < node_count(mesh) - 1:
                length = edge_length(self, mesh, node)
                if node < mesh[LEFT_CORNER]:
                    y = y + length
                elif node < mesh[RIGHT_CORNER]:
                    x = x + length
                else:
                    y = y - length

    def mass_of(self, mesh: Any, coordinate: Any) -> Any:
        return node_mass(self, mesh, coordinate // 2)

    def whole_mass(self, mesh: Any) -> Any:
        return self.mass

    def moments(self, mesh: Any, vector: Any) -> Any:
        x = 0.0 * vector[0]
        y = 0.0 * vector[0]
        for node in range(node_count(mesh)):
            mass = node_mass(self, mesh, node)
            x = x + mass * vector[2 * node]
            y = y + mass * vector[2 * node + 1]
        return x, y

    def rotation(self, mesh: Any, state: Any, velocity: Any, about: Any) -> Any:
        momentum = 0.0 * state[0]
        square = 0.0 * state[0]
        for node in range(node_count(mesh)):
            mass = node_mass(self, mesh, node)
            gained, own = rotation_of(mass, state, velocity, 2 * node, about)
            momentum = momentum + gained
            square = square + own
        return momentum, square

    def slide(self, mesh: Any, vector: Any, along_x: Any) -> None:
        for node in range(node_count(mesh)):
            vector[2 * node] = vector[2 * node] + along_x
