"""Rows of the linear system that a contact force goes to: of a node, or of a rigid body."""

from typing import Any, NamedTuple

from snapjump.discretization.base import RIGHT
from snapjump.number.dispatch import kernel
from snapjump.number.methods import Contract, required


class ContactRows(Contract):
    """Rows that a contact force goes to: the transposed Jacobian of its point's place."""

    @required
    def push(self, force: Any, stiffness: Any) -> None:
        """Add a vertical force and its stiffness, the negative derivative by the gap."""

    @required
    def drag(self, force: Any) -> None:
        """Add a force against x."""

    @required
    def drag_slope(self, force: Any, by_velocity: Any, by_gap: Any, rate: Any) -> None:
        """Add the derivatives of a force against x: by the velocity along x, of which ``rate`` is
        the derivative by the place, and minus that by the gap."""


@ContactRows.member
class NodeRows(NamedTuple):
    """Rows of a node whose x is at ``row`` of residual, band, and what the band lacks."""

    residual: Any
    band: Any
    skew: Any
    row: Any

    def push(self, force: Any, stiffness: Any) -> None:
        self.residual[self.row + 1] -= force
        self.band[self.row + 1, 0] += stiffness

    def drag(self, force: Any) -> None:
        self.residual[self.row] += force

    def drag_slope(self, force: Any, by_velocity: Any, by_gap: Any, rate: Any) -> None:
        self.band[self.row, 0] += by_velocity * rate
        self.skew[self.row, RIGHT] -= by_gap


@kernel
def rows_of(work: Any, row: Any) -> NodeRows:
    """The rows of a node of the beam in memory."""
    return NodeRows(work.residual[row:], work.band[row:], work.skew[row:], 0)


@ContactRows.member
class CornerRows(NamedTuple):
    """Rows of a rigid body: residual (3) and block (3, 3) of its x, y and direction; the arm (x, y)
    from its centre of mass to the point, and how fast it turns (rad/T)."""

    residual: Any
    block: Any
    x: Any
    y: Any
    turn_rate: Any

    def push(self, force: Any, stiffness: Any) -> None:
        x = self.x
        self.residual[1] -= force
        self.residual[2] -= force * x
        self.block[1, 1] += stiffness
        self.block[1, 2] += stiffness * x
        self.block[2, 1] += stiffness * x
        self.block[2, 2] += stiffness * x * x + force * self.y

    def drag(self, force: Any) -> None:
        self.residual[0] += force
        self.residual[2] -= self.y * force

    def drag_slope(self, force: Any, by_velocity: Any, by_gap: Any, rate: Any) -> None:
        x = self.x
        y = self.y
        along_x = by_velocity * rate
        along_y = -by_gap
        turned = by_velocity * (-y * rate - x * self.turn_rate) + along_y * x
        self.block[0, 0] += along_x
        self.block[0, 1] += along_y
        self.block[0, 2] += turned
        self.block[2, 0] -= y * along_x
        self.block[2, 1] -= y * along_y
        self.block[2, 2] -= y * turned + x * force
