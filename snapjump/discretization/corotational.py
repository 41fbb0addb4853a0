"""Co-rotational Euler-Bernoulli beam elements (Crisfield 1991, chapter 7).

In a frame that turns with the chord (length d, direction beta) the element is linear: stretching
EA (d - l)^2 / (2 l) and, with the ends' rotations theta_i - beta against the chord, bending
EI/l (2 a_1^2 + 2 a_1 a_2 + 2 a_2^2). With psi = theta_m - beta that is 6 EI psi^2 / l besides the
bending that all elements share. Hence N = EA (d - l) / l and M_1 + M_2 = 12 EI psi / l, and the
tangent is sum C B B^T + N z z^T / d + (M_1 + M_2) (r z^T + z r^T) / d^2, with r along the chord
and z across it.
"""

from typing import Any, NamedTuple

from snapjump.discretization.base import DiscretizationOptions
from snapjump.discretization.parts.beam_chain import BeamElements
from snapjump.discretization.parts.beam_elements import Span, Straining
from snapjump.number.dispatch import kernel
from snapjump.number.functions import fma, sqrt
from snapjump.number.trigonometry import arctan, cos, sin
from snapjump.robot.robot import Robot


@kernel
def angle_to_chord(ex: Any, ey: Any, length: Any, turn: Any) -> Any:
    """psi = turn - beta between -pi and pi, whatever whole turns both have made."""
    c = cos(turn)
    s = sin(turn)
    along = fma(c, ex, s * ey)
    return 2.0 * arctan(fma(s, ex, -c * ey) / (length + along))


class Corotational(DiscretizationOptions):
    """Co-rotational Euler-Bernoulli beam elements: second order, x, y and rotation at a node."""

    @BeamElements.member
    class Beam(NamedTuple):
        """Element length l and EA (with EI = L = 1)."""

        element_length: float
        stretching_stiffness: float

        def straining_energy(self, ex: Any, ey: Any, turn: Any) -> Any:
            length = sqrt(fma(ex, ex, ey * ey))
            stretch = length - self.element_length
            psi = angle_to_chord(ex, ey, length, turn)
            twice = self.stretching_stiffness * stretch * stretch + 12.0 * psi * psi
            return 0.5 * twice / self.element_length

        def strain_element(self, damping: Any, span: Span) -> Straining:
            length = sqrt(fma(span.ex, span.ex, span.ey * span.ey))
            over = 1.0 / length
            cx = span.ex * over
            cy = span.ey * over
            psi = angle_to_chord(span.ex, span.ey, length, span.turn)
            stretch_rate = cx * span.vx + cy * span.vy
            psi_rate = span.turn_rate - (cx * span.vy - cy * span.vx) * over

            density = 1.0 / self.element_length
            stretching = self.stretching_stiffness * density
            turning = 12.0 * density
            force = stretching * damping.viscous_strain(length - self.element_length, stretch_rate)
            torque = turning * damping.viscous_strain(psi, psi_rate)
            stiffening = damping.stiffening(span.rate_factor)
            stretching = stretching * stiffening
            turning = turning * stiffening

            # Gradient of psi, minus that of the chord's direction; Hess beta is as in der_elements.
            px = cy * over
            py = -cx * over
            lateral = force * over
            twist = torque * over * over
            along = stretching - lateral
            swing = 2.0 * twist * cx * cy
            return Straining(
                fma(force, cx, torque * px),
                fma(force, cy, torque * py),
                torque,
                fma(along * cx, cx, lateral - swing) + turning * px * px,
                fma(along * cx, cy, twist * (cx * cx - cy * cy)) + turning * px * py,
                fma(along * cy, cy, lateral + swing) + turning * py * py,
                turning * px,
                turning * py,
                turning,
            )

    def beam(self, robot: Robot) -> Beam:
        """The dimensionless beam."""
        return self.Beam(1.0 / self.elements, robot.stretching_stiffness_bar)
