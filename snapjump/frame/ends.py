"""Condensing a slave node: what fixed and moving frames share."""

from typing import Any

from snapjump.number.dispatch import kernel


@kernel
def release_first_node(residual: Any, band: Any) -> None:
    """Leave an identity in place of node 0 (``residual`` of the nodes alone)."""
    for k in range(1, 6):
        band[0, k] = 0.0
        band[1, k] = 0.0
    band[0, 0] = 1.0
    band[1, 0] = 1.0
    residual[0] = 0.0
    residual[1] = 0.0


@kernel
def release_last_node(residual: Any, band: Any, last: Any) -> None:
    """Leave an identity in place of the last node, ``last`` being its number."""
    row = 2 * last
    band[row - 4, 4] = 0.0
    band[row - 4, 5] = 0.0
    band[row - 3, 3] = 0.0
    band[row - 3, 4] = 0.0
    band[row - 2, 2] = 0.0
    band[row - 2, 3] = 0.0
    band[row - 1, 1] = 0.0
    band[row - 1, 2] = 0.0
    band[row, 0] = 1.0
    band[row, 1] = 0.0
    band[row + 1, 0] = 1.0
    residual[row] = 0.0
    residual[row + 1] = 0.0


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
    """Move an end node's own block, force and hinge onto coordinates k, k + 1, k + 2 of the border.

    (kxx, kxy, kyy): the node's block; (cx, cy): its coupling with the mount's direction through
    the hinge; ``sign``: d(hinge angle)/d(that direction); (arm_x, arm_y): from the mount's point
    to the node.
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
def move_first(hinge: Any, arm_x: Any, arm_y: Any, residual: Any, system: Any) -> None:
    """Move the first node onto the border's coordinates 0, 1, 2 (x, y, direction of a mount)."""
    nodes = system.residual
    band = system.band
    border = system.border
    # The left hinge's angle falls with the mount's direction; its edge leaves node 0.
    coupling = hinge.stiffness
    add_arm(
        band[0, 0],
        band[0, 1],
        band[1, 0],
        coupling * hinge.slope_x,
        coupling * hinge.slope_y,
        hinge,
        -1.0,
        nodes[0],
        nodes[1],
        arm_x,
        arm_y,
        residual,
        system.square,
        0,
    )
    for row in range(2, 6):
        bx = band[0, row]
        by = band[1, row - 1]
        border[row, 0] += bx
        border[row, 1] += by
        border[row, 2] += by * arm_x - bx * arm_y
    border[2, 2] -= coupling * hinge.slope_x
    border[3, 2] -= coupling * hinge.slope_y
    release_first_node(nodes, band)


@kernel
def move_last(
    last: Any, hinge: Any, arm_x: Any, arm_y: Any, residual: Any, system: Any, column: Any
) -> None:
    """Move node ``last``, the last one, onto three coordinates of the border."""
    nodes = system.residual
    band = system.band
    border = system.border
    row = 2 * last
    coupling = hinge.stiffness
    add_arm(
        band[row, 0],
        band[row, 1],
        band[row + 1, 0],
        -coupling * hinge.slope_x,
        -coupling * hinge.slope_y,
        hinge,
        1.0,
        nodes[row],
        nodes[row + 1],
        arm_x,
        arm_y,
        residual,
        system.square,
        column,
    )
    for k in range(1, 5):
        bx = band[row - k, k]
        by = band[row - k, k + 1]
        border[row - k, column] += bx
        border[row - k, column + 1] += by
        border[row - k, column + 2] += by * arm_x - bx * arm_y
    border[row - 2, column + 2] += coupling * hinge.slope_x
    border[row - 1, column + 2] += coupling * hinge.slope_y
    release_last_node(nodes, band, last)
