"""Quadratic drag: half the density of the air, times drag coefficient, area and speed squared.

The area is constant, whatever the robot's attitude: a tumbling one shows the air less than its top
plate on average, and more than that where its frame is higher than it is wide.
"""

from typing import Any, NamedTuple

import numpy as np

from snapjump.checks import ParameterError
from snapjump.declare.fields import number
from snapjump.drag.base import DragLaw, DragOptions
from snapjump.number.functions import sqrt
from snapjump.units import Scales

# Steps of a march foresee the drag of a stage, and a flight is integrated in steps of fixed number:
# a robot that stops within a few of its lengths is neither's.
MOST_PER_LENGTH = 0.1


class QuadraticDrag(DragOptions):
    """Drag against the velocity, growing with its square; on a constant area."""

    coefficient: float = number(
        1.2, least=0.0, most=10.0, doc="drag coefficient", symbol="C_d", plan=(0.5, 2.0),
        takes_arrays=True,
    )  # fmt: skip
    area_m2: float | None = number(
        None, above=0.0, unit="m^2", doc="area against the air; null: of the top plate, clear span "
        "times width", symbol="A_d", plan=(5e-5, 5e-4), takes_arrays=True,
    )  # fmt: skip
    air_density_kg_m3: float = number(
        1.2, least=0.0, unit="kg/m^3", doc="density of the air", symbol="ρ_air", plan=(0.9, 1.3),
        takes_arrays=True,
    )  # fmt: skip

    @DragLaw.member
    class Law(NamedTuple):
        """Deceleration over the speed squared (1/L)."""

        per_length: float

        def exists(self) -> bool:
            return True

        def acceleration(self, vx: Any, vy: Any) -> Any:
            # At rest the root must have a slope.
            share = -self.per_length * sqrt(vx * vx + vy * vy + 1e-200)
            return share * vx, share * vy

    def law(self, scales: Scales, mass_kg: Any, plate_m2: Any) -> Law:
        """The dimensionless law. Raises ParameterError where the air would stop a robot at once."""
        area_m2 = plate_m2 if self.area_m2 is None else self.area_m2
        # Of the deceleration: a coefficient of one.
        unit = 0.5 * self.air_density_kg_m3 * area_m2 * scales.length_m / mass_kg
        if np.any(self.coefficient * unit > MOST_PER_LENGTH):
            most = MOST_PER_LENGTH / np.max(unit)
            allowed = f"at most {most:.4g} for this robot, area and density: a drag that takes "
            allowed += "more than a fifth of the kinetic energy in a length of the beam"
            raise ParameterError("drag.coefficient", self.coefficient, allowed)
        return self.Law(self.coefficient * unit)
