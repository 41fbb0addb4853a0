"""Drag of the air on a robot: the contract that every law fulfils.

The force acts on the centre of mass and turns nothing: all masses are given the same acceleration,
which depends on the velocity of that centre. Velocities are in L/T, accelerations in L/T^2.
"""

from typing import Any, ClassVar

from snapjump.declare.fields import Part
from snapjump.number.methods import Contract, required
from snapjump.units import Scales


class DragLaw(Contract):
    """Drag of the air; by default there is none."""

    def exists(self) -> bool:
        """Whether there is any; a constant while compiling."""
        return False

    def acceleration(self, vx: Any, vy: Any) -> Any:
        """Acceleration (x, y) of a robot whose centre of mass has a velocity (x, y)."""
        return 0.0 * vx, 0.0 * vy


class DragOptions(Part):
    """A law of drag and its numbers."""

    group = "drag"
    absent: ClassVar[bool] = False

    def check_with(self, simulation: Any) -> None:
        if not self.absent:
            self.law_of(simulation)

    def law_of(self, simulation: Any) -> Any:
        """The law of a simulation's robot."""
        robot = simulation.robot
        plate_m2 = (1.0 - simulation.design.epsilon) * robot.length_m * robot.width_m
        return self.law(robot.scales, simulation.environment.mass_kg(robot), plate_m2)

    @required
    def law(self, scales: Scales, mass_kg: Any, plate_m2: Any) -> Any:
        """The dimensionless law, a member of :class:`DragLaw`, of a robot of so much mass whose top
        plate, clear span times width, has such an area; both may be arrays."""
