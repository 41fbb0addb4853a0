"""Geometrically exact beam elements with shear (Simo and Reissner), two nodes, one point.

With axes that turn by the mean rotation theta_m: a = e along them, b = e across them, strains
Gamma_1 = a/l - 1 and Gamma_2 = b/l, energy l (EA Gamma_1^2 + GA_s Gamma_2^2) / 2, and bending as
in all elements. One point of integration (reduced) keeps shear from locking.
"""

from typing import Any, NamedTuple

from snapjump.declare.fields import number
from snapjump.discretization.base import DiscretizationOptions
from snapjump.discretization.parts.beam_chain import BeamElements
from snapjump.discretization.parts.beam_elements import Span, Straining
from snapjump.number.functions import fma
from snapjump.number.trigonometry import cos, sin
from snapjump.robot.robot import Robot

SHEAR_FACTOR = 5.0 / 6.0  # of a rectangle


class GeometricallyExact(DiscretizationOptions):
    """Geometrically exact beam elements with shear: second order, x, y and rotation at a node.

    ``poisson_ratio`` gives the shear stiffness, 5/6 EA / (2 (1 + nu)).
    """

    poisson_ratio: float = number(0.3, least=-0.99, most=0.5)

    @BeamElements.member
    class Beam(NamedTuple):
        """Element length l, EA and GA_s (with EI = L = 1)."""

        element_length: float
        stretching_stiffness: float
        shear_stiffness: float

        def straining_energy(self, ex: Any, ey: Any, turn: Any) -> Any:
            c = cos(turn)
            s = sin(turn)
            stretch = c * ex + s * ey - self.element_length
            shear = c * ey - s * ex
            twice = (
                self.stretching_stiffness * stretch * stretch + self.shear_stiffness * shear * shear
            )
            return 0.5 * twice / self.element_length

        def strain_element(self, damping: Any, span: Span) -> Straining:
            c = cos(span.turn)
            s = sin(span.turn)
            a = fma(c, span.ex, s * span.ey)
            b = fma(c, span.ey, -s * span.ex)
            a_rate = c * span.vx + s * span.vy + b * span.turn_rate
            b_rate = c * span.vy - s * span.vx - a * span.turn_rate

            density = 1.0 / self.element_length
            stretching = self.stretching_stiffness * density
            shearing = self.shear_stiffness * density
            force = stretching * damping.viscous_strain(a - self.element_length, a_rate)
            shear = shearing * damping.viscous_strain(b, b_rate)
            stiffening = damping.stiffening(span.rate_factor)
            stretching = stretching * stiffening
            shearing = shearing * stiffening

            # da/dtheta_m = b and db/dtheta_m = -a; their derivatives by e are (-s, c) and -(c, s).
            force_x = c * force - s * shear
            force_y = s * force + c * shear
            along = stretching * b - shear
            across = shearing * a - force
            return Straining(
                force_x,
                force_y,
                b * force - a * shear,
                fma(stretching * c, c, shearing * s * s),
                (stretching - shearing) * c * s,
                fma(stretching * s, s, shearing * c * c),
                c * along + s * across,
                s * along - c * across,
                fma(stretching * b, b, shearing * a * a) - (a * force + b * shear),
            )

    def beam(self, robot: Robot) -> Beam:
        """The dimensionless beam."""
        stretching = robot.stretching_stiffness_bar
        shearing = SHEAR_FACTOR * stretching / (2.0 * (1.0 + self.poisson_ratio))
        return self.Beam(1.0 / self.elements, stretching, shearing)
