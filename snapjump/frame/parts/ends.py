"""Condensing a slave node: its rows and columns move onto the frame, an identity stays behind."""

from typing import Any, NamedTuple

from snapjump.discretization.base import HALF_BANDWIDTH, RIGHT, SKEW, EndHinge
from snapjump.number.dispatch import kernel
from snapjump.number.nowhere import keeps


class Arm(NamedTuple):
    """From a mount's point to an end node (L)."""

    x: Any
    y: Any


class EndNode(NamedTuple):
    """An end node's force (x, y) and own block (xx, xy, yy), and what couples it with the frame's
    direction (cx, cy)."""

    x: Any
    y: Any
    xx: Any
    xy: Any
    yy: Any
    cx: Any
    cy: Any


@kernel
def release_first_node(dofs: Any, work: Any) -> None:
    """Leave an identity in place of node 0 of ``dofs`` coordinates."""
    band = work.band
    for i in range(dofs):
        for k in range(SKEW):
            work.skew[i, k] = 0.0
        for k in range(1, 6):
            band[i, k] = 0.0
        band[i, 0] = 1.0
        work.residual[i] = 0.0


@kernel
def release_last_node(dofs: Any, work: Any) -> None:
    """Leave an identity in place of the last node."""
    band = work.band
    row = work.residual.shape[0] - dofs
    # Columns of the nodes before: two of two coordinates, or one of three, reach the last one.
    before = 4 if dofs == 2 else 3
    for k in range(1, before + 1):
        for i in range(dofs):
            if k + i <= 5:
                band[row - k, k + i] = 0.0
                work.skew[row - k, k + i] = 0.0
                work.skew[row - k, RIGHT - 1 + k + i] = 0.0
    for i in range(dofs):
        for k in range(1, dofs - i):
            band[row + i, k] = 0.0
        for k in range(SKEW):
            work.skew[row + i, k] = 0.0
        band[row + i, 0] = 1.0
        work.residual[row + i] = 0.0


@kernel
def end_node(discretization: Any, row: Any, hinge: Any, sign: Any, work: Any) -> Any:
    """The end node whose x is at ``row``, and the hinge by which it acts on the frame's direction.

    A node that turns does so with the frame: what acts on its rotation is the moment of the clamp.
    ``sign``: d(hinge angle)/d(frame's direction), of a node that does not turn.
    """
    band = work.band
    residual = work.residual
    coupling = -sign * hinge.stiffness
    cx = coupling * hinge.slope_x
    cy = coupling * hinge.slope_y
    if discretization.node_dofs() == 3:
        length = discretization.rotation_length()
        zero = 0.0 * hinge.stiffness  # where no matrix is wanted, too, of the type of all numbers
        moment = zero + length * residual[row + 2]
        stiffness = zero + length * length * band[row + 2, 0]
        hinge = EndHinge(moment, stiffness, zero, zero, zero, zero, zero)
        cx = zero + length * band[row, 2]
        cy = zero + length * band[row + 1, 1]
    node = EndNode(
        residual[row], residual[row + 1], band[row, 0], band[row, 1], band[row + 1, 0], cx, cy
    )
    return node, hinge


@kernel
def add_end(
    node: EndNode, hinge: Any, sign: Any, arm: Arm, residual: Any, block: Any, k: Any
) -> None:
    """Add an end node's force, block and hinge to those of a mount: coordinates k, k + 1, k + 2."""
    sx = -arm.y
    sy = arm.x
    residual[k] += node.x
    residual[k + 1] += node.y
    residual[k + 2] += sx * node.x + sy * node.y + sign * hinge.moment
    tx = node.xx * sx + node.xy * sy + node.cx
    ty = node.xy * sx + node.yy * sy + node.cy
    block[k, k] += node.xx
    block[k, k + 1] += node.xy
    block[k + 1, k] += node.xy
    block[k + 1, k + 1] += node.yy
    block[k, k + 2] += tx
    block[k + 2, k] += tx
    block[k + 1, k + 2] += ty
    block[k + 2, k + 1] += ty
    rotational = sx * tx + sy * ty + sx * node.cx + sy * node.cy + hinge.stiffness
    block[k + 2, k + 2] += rotational - arm.x * node.x - arm.y * node.y


@kernel
def add_border(bx: Any, by: Any, arm: Arm, border: Any, row: Any, column: Any) -> None:
    """Add the coupling (bx, by) of an end node with a row to the frame's columns."""
    border[row, column] += bx
    border[row, column + 1] += by
    border[row, column + 2] += by * arm.x - bx * arm.y


@kernel
def move_skew(arm: Arm, row: Any, work: Any) -> None:
    """Add what an end node's own symmetric block lacks to a rigid frame's."""
    skew = work.skew
    block = work.corner_block
    sx = -arm.y
    sy = arm.x
    xx = skew[row, 0]
    xy = skew[row, RIGHT]
    yx = skew[row, 1]
    yy = skew[row + 1, 0]
    xt = xx * sx + xy * sy
    yt = yx * sx + yy * sy
    block[0, 0] += xx
    block[0, 1] += xy
    block[0, 2] += xt
    block[1, 0] += yx
    block[1, 1] += yy
    block[1, 2] += yt
    block[2, 0] += sx * xx + sy * yx
    block[2, 1] += sx * xy + sy * yy
    block[2, 2] += sx * xt + sy * yt


@kernel
def add_border_skew(of_columns: Any, of_rows: Any, arm: Arm, border: Any, row: Any) -> None:
    """Add what the border lacks of the coupling of an end node with a row, in the frame's columns
    and in its rows."""
    add_border(of_columns[0], of_columns[1], arm, border, row, 0)
    add_border(of_rows[0], of_rows[1], arm, border, row, 3)


@kernel
def turn_skew(hinge: Any, sign: Any, row: Any, arm: Arm, work: Any) -> None:
    """Add what the coupling of the frame's direction with the end edge lacks; ``row``: the x of the
    edge's other node."""
    block = work.corner_block
    border = work.border_skew
    block[2, 0] += hinge.rate_x
    block[2, 1] += hinge.rate_y
    block[2, 2] += hinge.rate_y * arm.x - hinge.rate_x * arm.y
    border[row, 5] -= hinge.rate_x
    border[row + 1, 5] -= hinge.rate_y
    x = sign * hinge.turned * hinge.slope_x
    y = sign * hinge.turned * hinge.slope_y
    block[0, 2] -= x
    block[1, 2] -= y
    block[2, 2] += hinge.turned - (y * arm.x - x * arm.y)
    border[row, 2] += x
    border[row + 1, 2] += y


@kernel
def move_first(discretization: Any, hinge: Any, arm: Arm, residual: Any, work: Any) -> None:
    """Move the first node onto columns 0, 1, 2 of the border: x, y and direction of a mount.

    residual: of the mount's coordinates.
    """
    band = work.band
    border = work.border
    dofs = discretization.node_dofs()
    sign = 1.0 if dofs == 3 else -1.0
    node, end_hinge = end_node(discretization, 0, hinge, sign, work)
    add_end(node, end_hinge, sign, arm, residual, work.corner_block, 0)
    for row in range(dofs, 6):
        add_border(band[0, row], band[1, row - 1], arm, border, row, 0)
        if dofs == 3:
            border[row, 2] += discretization.rotation_length() * band[2, row - 2]
    if dofs == 2:
        border[2, 2] -= hinge.stiffness * hinge.slope_x
        border[3, 2] -= hinge.stiffness * hinge.slope_y
        if keeps(work.skew):
            move_skew(arm, 0, work)
            for k in range(2, 6):
                of_columns = (work.skew[0, k], work.skew[1, k - 1])
                of_rows = (work.skew[0, HALF_BANDWIDTH + k], work.skew[1, HALF_BANDWIDTH + k - 1])
                add_border_skew(of_columns, of_rows, arm, work.border_skew, k)
            turn_skew(hinge, sign, 2, arm, work)
    release_first_node(dofs, work)


@kernel
def move_last(
    discretization: Any, hinge: Any, arm: Arm, residual: Any, work: Any, column: Any
) -> None:
    """Move the last node onto three columns of the border, from ``column`` on."""
    band = work.band
    border = work.border
    dofs = discretization.node_dofs()
    row = work.residual.shape[0] - dofs
    node, end_hinge = end_node(discretization, row, hinge, 1.0, work)
    add_end(node, end_hinge, 1.0, arm, residual, work.corner_block, column)
    # Columns of the nodes before: two of two coordinates, or one of three, reach the last one.
    for k in range(1, 5 if dofs == 2 else 4):
        j = row - k
        add_border(band[j, k], band[j, k + 1], arm, border, j, column)
        if dofs == 3:
            border[j, column + 2] += discretization.rotation_length() * band[j, k + 2]
    if dofs == 2:
        border[row - 2, column + 2] += hinge.stiffness * hinge.slope_x
        border[row - 1, column + 2] += hinge.stiffness * hinge.slope_y
        if keeps(work.skew):
            move_skew(arm, row, work)
            for k in range(1, 5):
                j = row - k
                right = HALF_BANDWIDTH + k
                of_columns = (work.skew[j, right], work.skew[j, right + 1])
                of_rows = (work.skew[j, k], work.skew[j, k + 1])
                add_border_skew(of_columns, of_rows, arm, work.border_skew, j)
            turn_skew(hinge, 1.0, row - 2, arm, work)
    release_last_node(dofs, work)
