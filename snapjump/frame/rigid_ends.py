"""Condensing the beam's end nodes onto the three coordinates of a rigid frame."""

from typing import Any

from snapjump.discretization.base import EndHinge
from snapjump.number.dispatch import kernel


@kernel
def add_arm(
    kxx: Any,
    kxy: Any,
    kyy: Any,
    cx: Any,
    cy: Any,
    hinge: Any,
    sign: Any,
    fx: Any,
    fy: Any,
    arm_x: Any,
    arm_y: Any,
    residual: Any,
    square: Any,
) -> None:
    """Move an end node's own block, force and hinge onto the frame.

    (kxx, kxy, kyy): the node's block; (cx, cy): its coupling with the frame's direction through
    the hinge; ``sign``: d(hinge angle)/d(frame's direction).
    """
    sx = -arm_y
    sy = arm_x
    residual[0] += fx
    residual[1] += fy
    residual[2] += sx * fx + sy * fy + sign * hinge.moment
    tx = kxx * sx + kxy * sy + cx
    ty = kxy * sx + kyy * sy + cy
    square[0, 0] += kxx
    square[0, 1] += kxy
    square[1, 0] += kxy
    square[1, 1] += kyy
    square[0, 2] += tx
    square[2, 0] += tx
    square[1, 2] += ty
    square[2, 1] += ty
    square[2, 2] += (
        sx * tx + sy * ty + sx * cx + sy * cy + hinge.stiffness - arm_x * fx - arm_y * fy
    )


@kernel
def condense_hinged_node(
    row: Any, hinge: Any, sign: Any, arm_x: Any, arm_y: Any, system: Any
) -> None:
    """Move an end node that does not turn, with the hinge of its edge, onto the frame.

    ``sign``: d(hinge angle)/d(frame's direction); the edge leaves the first node and ends at
    the last one.
    """
    band = system.band
    nodes = system.residual
    coupling = -sign * hinge.stiffness
    add_arm(
        band[row, 0],
        band[row, 1],
        band[row + 1, 0],
        coupling * hinge.slope_x,
        coupling * hinge.slope_y,
        hinge,
        sign,
        nodes[row],
        nodes[row + 1],
        arm_x,
        arm_y,
        system.frame_residual,
        system.square,
    )


@kernel
def condense_turning_node(row: Any, length: Any, arm_x: Any, arm_y: Any, system: Any) -> None:
    """Move an end node with a third coordinate, ``length`` times its rotation, onto the frame.

    It turns with the frame: what acts on its rotation is the moment of the clamp.
    """
    band = system.band
    nodes = system.residual
    zero = 0.0 * arm_x
    moment = length * nodes[row + 2]
    stiffness = length * length * band[row + 2, 0]
    add_arm(
        band[row, 0],
        band[row, 1],
        band[row + 1, 0],
        length * band[row, 2],
        length * band[row + 1, 1],
        EndHinge(moment, stiffness, zero, zero),
        1.0,
        nodes[row],
        nodes[row + 1],
        arm_x,
        arm_y,
        system.frame_residual,
        system.square,
    )


@kernel
def add_border(bx: Any, by: Any, arm_x: Any, arm_y: Any, border: Any, row: Any) -> None:
    """Move the coupling (bx, by) of an end node with a row onto the frame's columns."""
    border[row, 0] += bx
    border[row, 1] += by
    border[row, 2] += by * arm_x - bx * arm_y
