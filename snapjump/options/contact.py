"""Options of the contact laws."""

import math
from typing import Any

from snapjump.contact.base import Ground
from snapjump.contact.hunt_crossley import HuntCrossley
from snapjump.contact.logbarrier import LogBarrier
from snapjump.contact.none import NoContact
from snapjump.contact.penalty import Penalty
from snapjump.contact.signorini import Signorini
from snapjump.declare.fields import Part, choice, number
from snapjump.number.portable import log1p
from snapjump.options.discretization import DiscretizationOptions
from snapjump.units import Scales

WEIGHTINGS = ("per_length", "per_node")
PAPER_ELEMENTS = 66  # of the mesh whose every node the paper gives the stiffness K_c
CLEARANCE_M = 2.0e-5  # where nothing pushes from afar, a robot this high is in the air


def is_per_length(options: Any, law: Any) -> bool:
    """Whether a law's force belongs to a length of the beam, and not to a node: a law that has no
    choice is, but for a constraint, whose force is what it takes."""
    return not law.is_impulsive() and getattr(options, "weighting", "per_length") == "per_length"


def ground(
    options: Any, law: Any, scales: Scales, discretization: DiscretizationOptions | None
) -> Ground:
    """Shares of the law's force at nodes and corners, and where a robot is in the air.

    Per length, a node's share falls as the mesh is refined; a lone mass, without a discretization,
    has all of it.
    """
    share = 1.0
    if discretization is not None and is_per_length(options, law):
        share = PAPER_ELEMENTS / discretization.elements
    return Ground(
        node_share=share,
        corner_share=1.0,
        clearance=law.reach() if law.keeps_open() else CLEARANCE_M / scales.length_m,
    )


class ContactOptions(Part):
    """A contact law and its numbers."""

    group = "contact"


class LogBarrierOptions(ContactOptions):
    """Logarithmic barrier (the paper, IPC): no gap ever closes.

    ``stiffness_N_m`` is K_c at a frame corner and at a node of the paper's mesh of 66 elements;
    per length it is spread so that refining the mesh does not stiffen the ground. ``damping_s``
    adds a force of so many seconds times the stiffness times the closing speed.
    """

    stiffness_N_m: float = number(1.0e4, above=0.0, unit="N/m")  # noqa: N815 (the unit is a capital)
    distance_m: float = number(5.0e-4, above=0.0, unit="m")
    damping_s: float = number(0.0, least=0.0, unit="s")
    weighting: str = choice("per_length", WEIGHTINGS)

    def member(self, scales: Scales) -> LogBarrier:
        """The dimensionless law."""
        return LogBarrier(
            stiffness=self.stiffness_N_m / scales.stiffness_N_m,
            distance=self.distance_m / scales.length_m,
            relaxation_time=self.damping_s / scales.time_s,
        )


class PenaltyOptions(ContactOptions):
    """Quadratic penalty: a spring below the ground; conservative, fast, and it lets points sink in.

    ``stiffness_N_m`` as for the barrier.
    """

    stiffness_N_m: float = number(1.0e5, above=0.0, unit="N/m")  # noqa: N815
    weighting: str = choice("per_length", WEIGHTINGS)

    def member(self, scales: Scales) -> Penalty:
        """The dimensionless law."""
        return Penalty(
            stiffness=self.stiffness_N_m / scales.stiffness_N_m,
        )


class HuntCrossleyOptions(ContactOptions):
    """Hunt-Crossley: a Hertzian spring with a damper that gives an impact its restitution.

    ``stiffness_N_m``: force over penetration at ``penetration_m``; ``restitution`` of an impact at
    ``impact_speed_m_s`` (slower ones lose less).
    """

    restitution: float = number(0.8, least=0.01, most=1.0)
    impact_speed_m_s: float = number(5.0, above=0.0, unit="m/s")
    stiffness_N_m: float = number(1.0e5, above=0.0, unit="N/m")  # noqa: N815
    penetration_m: float = number(2.0e-5, above=0.0, unit="m")
    weighting: str = choice("per_length", WEIGHTINGS)

    def member(self, scales: Scales) -> HuntCrossley:
        """The dimensionless law."""
        secant = self.stiffness_N_m / scales.stiffness_N_m
        speed = self.impact_speed_m_s / scales.velocity_m_s
        return HuntCrossley(
            stiffness=secant / math.sqrt(self.penetration_m / scales.length_m),
            damping=damping_number(self.restitution) / speed,
        )


def damping_number(restitution: float) -> float:
    """Damping times impact speed, u, for which (1 + e) u = log((1 + u) / (1 - e u))."""
    from scipy.optimize import brentq

    if restitution == 1.0:
        return 0.0

    def excess(u: float) -> float:
        return log1p(u) - log1p(-restitution * u) - (1.0 + restitution) * u

    # Towards u = 0 the excess is (e^2 - 1) u^2 / 2 < 0, towards 1/e it grows without bound.
    low, high = min(1e-3, 0.1 * (1.0 - restitution)), (1.0 - 1e-15) / restitution
    if excess(high) < 0.0 or excess(low) > 0.0:
        # Rounding hides the root: it is 1/e for small e, and nothing as e comes near 1.
        return high if excess(high) < 0.0 else 0.0
    return float(brentq(excess, low, high, xtol=1e-15))


class SignoriniOptions(ContactOptions):
    """The rigid ground: a complementarity of gap and force, and Newton's impact law.

    ``restitution``: of every impact of a node or a corner. An impact law of velocities, which
    needs integrator=implicit_euler.
    """

    restitution: float = number(1.0, least=0.0, most=1.0)

    def member(self, scales: Scales) -> Signorini:
        """The dimensionless law."""
        return Signorini(self.restitution)


class NoContactOptions(ContactOptions):
    """No ground: every contact term is left out of the compiled program."""

    def member(self, scales: Scales) -> NoContact:
        """The empty law."""
        return NoContact()
