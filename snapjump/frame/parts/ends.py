"""Condensing a slave node: what fixed and moving frames share."""

from typing import Any

from snapjump.discretization.base import EndHinge
from snapjump.number.dispatch import kernel


@kernel
def release_first_node(dofs: Any, residual: Any, band: Any) -> None:
    """Leave an identity in place of node 0 of ``dofs`` coordinates (``residual`` of the nodes)."""
    for i in range(dofs):
        for k in range(1, 6):
            band[i, k] = 0.0
        band[i, 0] = 1.0
        residual[i] = 0.0


@kernel
def release_last_node(dofs: Any, residual: Any, band: Any, last: Any) -> None:
    """Leave an identity in place of the last node, ``last`` being its number."""
    row = dofs * last
    # Columns of the nodes before: two of two coordinates, or one of three, reach the last one.
    before = 4 if dofs == 2 else 3
    for k in range(1, before + 1):
        for i in range(dofs):
            if k + i <= 5:
                band[row - k, k + i] = 0.0
    for i in range(dofs):
        for k in range(1, dofs - i):
            band[row + i, k] = 0.0
        band[row + i, 0] = 1.0
        residual[row + i] = 0.0


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
    k: Any,
) -> None:
    """Move an end node's own block, force and hinge onto a mount: coordinates k, k + 1, k + 2.

    (kxx, kxy, kyy): the node's block; (cx, cy): its coupling with the frame's direction through
    the hinge; ``sign``: d(hinge angle)/d(frame's direction); (arm_x, arm_y): from the mount's
    point to the node.
    """
    sx = -arm_y
    sy = arm_x
    residual[k] += fx
    residual[k + 1] += fy
    residual[k + 2] += sx * fx + sy * fy + sign * hinge.moment
    tx = kxx * sx + kxy * sy + cx
    ty = kxy * sx + kyy * sy + cy
    square[k, k] += kxx
    square[k, k + 1] += kxy
    square[k + 1, k] += kxy
    square[k + 1, k + 1] += kyy
    square[k, k + 2] += tx
    square[k + 2, k] += tx
    square[k + 1, k + 2] += ty
    square[k + 2, k + 1] += ty
    square[k + 2, k + 2] += (
        sx * tx + sy * ty + sx * cx + sy * cy + hinge.stiffness - arm_x * fx - arm_y * fy
    )


@kernel
def condense_hinged_node(
    row: Any,
    hinge: Any,
    sign: Any,
    arm_x: Any,
    arm_y: Any,
    residual: Any,
    system: Any,
    column: Any,
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
        residual,
        system.square,
        column,
    )


@kernel
def condense_turning_node(
    row: Any, length: Any, arm_x: Any, arm_y: Any, residual: Any, system: Any, column: Any
) -> None:
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
        residual,
        system.square,
        column,
    )


@kernel
def add_border(
    bx: Any, by: Any, arm_x: Any, arm_y: Any, border: Any, row: Any, column: Any
) -> None:
    """Move the coupling (bx, by) of an end node with a row onto the frame's columns."""
    border[row, column] += bx
    border[row, column + 1] += by
    border[row, column + 2] += by * arm_x - bx * arm_y


@kernel
def move_first(
    discretization: Any, hinge: Any, arm_x: Any, arm_y: Any, residual: Any, system: Any
) -> None:
    """Move the first node onto columns 0, 1, 2 of the border: x, y and direction of a mount."""
    band = system.band
    border = system.border
    if discretization.node_dofs() == 3:
        length = discretization.turn_length()
        condense_turning_node(0, length, arm_x, arm_y, residual, system, 0)
        for row in range(3, 6):
            add_border(band[0, row], band[1, row - 1], arm_x, arm_y, border, row, 0)
            border[row, 2] += length * band[2, row - 2]
        release_first_node(3, system.residual, band)
    else:
        condense_hinged_node(0, hinge, -1.0, arm_x, arm_y, residual, system, 0)
        for row in range(2, 6):
            add_border(band[0, row], band[1, row - 1], arm_x, arm_y, border, row, 0)
        border[2, 2] -= hinge.stiffness * hinge.slope_x
        border[3, 2] -= hinge.stiffness * hinge.slope_y
        release_first_node(2, system.residual, band)


@kernel
def move_last(
    discretization: Any,
    last: Any,
    hinge: Any,
    arm_x: Any,
    arm_y: Any,
    residual: Any,
    system: Any,
    column: Any,
) -> None:
    """Move node ``last``, the last one, onto three columns of the border."""
    band = system.band
    border = system.border
    dofs = discretization.node_dofs()
    row = dofs * last
    if dofs == 3:
        length = discretization.turn_length()
        condense_turning_node(row, length, arm_x, arm_y, residual, system, column)
        for k in range(1, 4):
            j = row - k
            add_border(band[j, k], band[j, k + 1], arm_x, arm_y, border, j, column)
            border[j, column + 2] += length * band[j, k + 2]
    else:
        condense_hinged_node(row, hinge, 1.0, arm_x, arm_y, residual, system, column)
        for k in range(1, 5):
            j = row - k
            add_border(band[j, k], band[j, k + 1], arm_x, arm_y, border, j, column)
        border[row - 2, column + 2] += hinge.stiffness * hinge.slope_x
        border[row - 1, column + 2] += hinge.stiffness * hinge.slope_y
    release_last_node(dofs, system.residual, band, last)
