"""Options of the discretizations."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from snapjump.checks import check_choice, check_integer
from snapjump.discretization.der import DiscreteElasticRod
from snapjump.parameters.robot import Robot

CLAMPS = ("half_element", "two_nodes")


@dataclass(frozen=True)
class DiscreteElasticRodOptions:
    """Discrete elastic rods (the paper): second order with half-element clamps.

    ``elements`` of the whole beam; ``clamp``: half an element with a prescribed tangent, or the
    paper's two fixed nodes (first order), which leave two elements fewer to move.
    """

    elements: int = 104
    clamp: str = "half_element"

    def __post_init__(self) -> None:
        check_integer("discretization.elements", self.elements, 8, 100_000)
        check_choice("discretization.clamp", self.clamp, CLAMPS)

    @property
    def moving_elements(self) -> int:
        """Elements of the chain between the clamps."""
        return self.elements if self.clamp == "half_element" else self.elements - 2

    @property
    def clamped_mass_bar(self) -> float:
        """Mass of the nodes that move with one clamp (in rho A L)."""
        return (0.5 if self.clamp == "half_element" else 1.5) / self.elements

    def member(self, robot: Robot) -> DiscreteElasticRod:
        """The dimensionless rod."""
        length = 1.0 / self.elements
        half = self.clamp == "half_element"
        return DiscreteElasticRod(
            element_length=length,
            stretching_stiffness=robot.stretching_stiffness_bar,
            clamp_hinge_length=0.5 * length if half else length,
            clamp_offset=0.0 if half else length,
        )

    def masses(self) -> NDArray[np.float64]:
        """Lumped masses of the chain's nodes, zero where clamped at both ends (in rho A L)."""
        masses = np.full(self.moving_elements + 1, 1.0 / self.elements)
        masses[[0, -1]] = 0.0
        return masses
