"""Options of the discretizations."""

import numpy as np
from numpy.typing import NDArray

from snapjump.declare.fields import Part, choice, integer, number
from snapjump.discretization.corotational import Corotational
from snapjump.discretization.der import DiscreteElasticRod
from snapjump.discretization.geometrically_exact import GeometricallyExact
from snapjump.parameters.robot import Robot

CLAMPS = ("half_element", "two_nodes")
SHEAR_FACTOR = 5.0 / 6.0  # of a rectangle


class MeshOptions(Part):
    """A discretization and its numbers."""

    group = "discretization"


class DiscreteElasticRodOptions(MeshOptions):
    """Discrete elastic rods (the paper): second order with half-element clamps.

    ``elements`` of the whole beam; ``clamp``: half an element with a prescribed tangent, or the
    paper's two fixed nodes (first order), which leave two elements fewer to move.
    """

    elements: int = integer(104, least=8, most=100_000)
    clamp: str = choice("half_element", CLAMPS)

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


class BeamElementOptions(MeshOptions):
    """What elements with a rotation at every node have in common: clamps hold it, to second
    order."""

    elements: int = integer(104, least=8, most=100_000)

    @property
    def moving_elements(self) -> int:
        """Elements of the chain between the clamps: all of them."""
        return self.elements

    @property
    def clamped_mass_bar(self) -> float:
        """Mass of the node that moves with one clamp (in rho A L)."""
        return 0.5 / self.elements

    def masses(self) -> NDArray[np.float64]:
        """Lumped masses of the chain's nodes, zero where clamped at both ends (in rho A L)."""
        masses = np.full(self.elements + 1, 1.0 / self.elements)
        masses[[0, -1]] = 0.0
        return masses


class CorotationalOptions(BeamElementOptions):
    """Co-rotational Euler-Bernoulli beam elements: second order, x, y and rotation at a node."""

    def member(self, robot: Robot) -> Corotational:
        """The dimensionless beam."""
        return Corotational(1.0 / self.elements, robot.stretching_stiffness_bar)


class GeometricallyExactOptions(BeamElementOptions):
    """Geometrically exact beam elements with shear: second order, x, y and rotation at a node.

    ``poisson_ratio`` gives the shear stiffness, 5/6 EA / (2 (1 + nu)).
    """

    poisson_ratio: float = number(0.3, least=-0.99, most=0.5)

    def member(self, robot: Robot) -> GeometricallyExact:
        """The dimensionless beam."""
        stretching = robot.stretching_stiffness_bar
        shearing = SHEAR_FACTOR * stretching / (2.0 * (1.0 + self.poisson_ratio))
        return GeometricallyExact(1.0 / self.elements, stretching, shearing)


DiscretizationOptions = DiscreteElasticRodOptions | CorotationalOptions | GeometricallyExactOptions
