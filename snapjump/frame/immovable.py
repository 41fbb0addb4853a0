"""What all frames without coordinates of their own have in common."""

from typing import Any

from snapjump.frame.base import (
    FrameBox,
    FrameForces,
    Turning,
    add_frame_forces,
    border_width,
    contact_point,
    contact_points,
    corner_point,
    frame_box,
    frame_dissipation,
    frame_dofs,
    frame_energy,
    frame_mass,
    frame_moments,
    limit_frame_step,
    mount_turning,
    point_mass,
    point_weight,
    rest_frame,
    slide_frame,
    solve_frame,
)


def _no_coordinates(frame: Any, mesh: Any) -> int:
    return 0


def _no_border(frame: Any) -> int:
    return 0


def _no_turning(frame: Any, mesh: Any, state: Any, vector: Any) -> Turning:
    zero = 0.0 * state[0]
    return Turning(zero, zero)


def _no_forces(frame: Any, model: Any, motion: Any, work: Any) -> FrameForces:
    zero = 0.0 * motion.rate_factor
    return FrameForces(zero, zero + 1.0e30, zero)


def _nothing_to_solve(frame: Any, mesh: Any, state: Any, system: Any, done: Any) -> Any:
    return 0.0 * done.negative


def _no_limit(frame: Any, mesh: Any, state: Any, drop: Any, fraction: Any) -> Any:
    return 1.0 + 0.0 * state[0]


def _no_point(frame: Any, mesh: Any, point: Any, state: Any, velocity: Any) -> Any:
    zero = 0.0 * state[0]
    return zero, zero, zero, zero


def _no_point_mass(frame: Any, mesh: Any, point: Any, state: Any) -> float:
    return 0.0


def _no_weight(frame: Any, mesh: Any, point: Any, contact: Any) -> float:
    return 0.0


def _no_box(frame: Any, mesh: Any, state: Any, velocity: Any) -> FrameBox:
    zero = 0.0 * state[0]
    return FrameBox(zero, zero, zero, zero, zero, zero, zero, zero, zero)


def _unchanged(frame: Any, mesh: Any, vector: Any, value: Any) -> None:
    pass


def _no_mass(frame: Any, mesh: Any, coordinate: Any) -> float:
    return 0.0


def _no_moments(frame: Any, mesh: Any, vector: Any) -> Any:
    zero = 0.0 * vector[0]
    return zero, zero


def _no_energy(frame: Any, mesh: Any, state: Any) -> Any:
    return 0.0 * state[0]


def _no_dissipation(frame: Any, damping: Any, mesh: Any, state: Any, velocity: Any) -> Any:
    return 0.0 * state[0]


def immovable(cls: type) -> type:
    """Register a frame that has no coordinates of its own."""
    for function, version in (
        (frame_dofs, _no_coordinates),
        (border_width, _no_border),
        (mount_turning, _no_turning),
        (add_frame_forces, _no_forces),
        (solve_frame, _nothing_to_solve),
        (limit_frame_step, _no_limit),
        (contact_points, _no_coordinates),
        (contact_point, _no_point),
        (point_mass, _no_point_mass),
        (point_weight, _no_weight),
        (corner_point, _no_point),
        (frame_box, _no_box),
        (rest_frame, _unchanged),
        (frame_mass, _no_mass),
        (frame_moments, _no_moments),
        (slide_frame, _unchanged),
        (frame_energy, _no_energy),
        (frame_dissipation, _no_dissipation),
    ):
        function.member(cls)(version)
    return cls
