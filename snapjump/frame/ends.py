"""Condensing a slave node: what fixed and moving frames share."""

from typing import Any

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
