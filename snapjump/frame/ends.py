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
