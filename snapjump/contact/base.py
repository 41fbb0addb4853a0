"""Normal contact with the ground, y = 0: the contract that every contact law fulfils.

A law is a ``NamedTuple`` of dimensionless numbers. Lengths are in L, forces in EI/L^2.
"""

from typing import Any, ClassVar, NamedTuple

from numba.extending import overload

from snapjump.declare.fields import Part, choice
from snapjump.number.dispatch import INLINED, kernel
from snapjump.number.functions import minimum, where
from snapjump.number.methods import Contract, required
from snapjump.number.slope import derivative, slope_in, sloped
from snapjump.units import Scales

# Slower than this (in L/T) a contact rests: what an unresolved bounce could lose is then nothing.
RESTING_SPEED = 0.02


class ContactState(NamedTuple):
    """State of a point in contact, besides its gap.

    speed: of the gap (L/T); rate: d(speed)/d(gap), 0 in statics (1/T); start_gap, start_speed: gap
    and speed at the step's beginning; inertia: d(inertial force)/d(gap) (EI/L^3).
    """

    speed: Any
    rate: Any
    start_gap: Any
    start_speed: Any
    inertia: Any


class Extremes(NamedTuple):
    """Of an assembly: the largest force in play (EI/L^2), the smallest gap (L), and the square of
    the fastest contact frequency sqrt(k/m) (1/T^2)."""

    largest_force: Any
    smallest_gap: Any
    contact_rate_squared: Any


def derived_slope(law: Any, gap: Any, state: ContactState) -> Any:
    """The slope that follows from a law's force."""

    def force(moved: Any) -> Any:
        return law.force(moved, state._replace(speed=state.speed + state.rate * (moved - gap)))

    return -derivative(force, gap)


@overload(derived_slope, strict=False, jit_options=INLINED)
def _derived_slope(law: Any, gap: Any, state: Any) -> Any:
    def slope(law: Any, gap: Any, state: Any) -> Any:
        moving = ContactState(
            sloped(state.speed, state.rate),
            state.rate,
            state.start_gap,
            state.start_speed,
            state.inertia,
        )
        return -slope_in(law.force(sloped(gap, 1.0), moving))

    return slope


class Ground(NamedTuple):
    """Ground of a model: a law's share at a node of the beam and at a corner of the frame,
    and the gap (in L) beyond which a point counts as in the air."""

    node_share: Any
    corner_share: Any
    clearance: Any


class ContactLaw(Contract):
    """Normal contact with the ground, y = 0: what a contact law is asked, before its share."""

    def exists(self) -> Any:
        """Whether contact terms are compiled in."""
        return True

    def keeps_open(self) -> Any:
        """Whether the law needs positive gaps, which every correction must then leave."""
        return False

    def is_constraint(self) -> Any:
        """Whether the force is what holds a point of the active set, and no function of the gap."""
        return False

    def reach(self) -> Any:
        """The gap beyond which the law gives no force at rest."""
        return 0.0

    def active(self, gap: Any, state: Any) -> Any:
        """Mask: whether the law gives a force. Only then is it asked for it."""
        return gap < self.reach()

    @required
    def energy(self, gap: Any) -> Any:
        """Energy stored at a gap within reach."""

    @required
    def force(self, gap: Any, state: Any) -> Any:
        """Repulsive force."""

    def slope(self, gap: Any, state: Any) -> Any:
        """Negative total derivative of the force by the gap, with which the speed changes too."""
        return derived_slope(self, gap, state)

    def loss(self, gap: Any, state: Any) -> Any:
        """Power that the law takes out (EI/(L T))."""
        return 0.0 * gap

    def bounce_rate_squared(self, stiffness: Any, mass: Any, speed: Any) -> Any:
        """Square of the frequency (1/T^2) that steps must resolve where a mass is in contact: k/m,
        less where contact rests."""
        pace = speed * (1.0 / RESTING_SPEED)
        return stiffness * (1.0 / mass) * minimum(pace * pace, 1.0 + 0.0 * pace)


@kernel
def at_rest(gap: Any) -> ContactState:
    """The state of a point that does not move."""
    zero = 0.0 * gap
    return ContactState(zero, zero, gap, zero, zero)


@kernel
def force_if_active(contact: Any, gap: Any, state: Any) -> Any:
    """Mask, force and stiffness, the latter two zero where the law gives none."""
    active = contact.active(gap, state)
    # A barrier has no force beyond its reach, and no value below zero.
    gap = where(active, gap, contact.reach())
    force = contact.force(gap, state)
    stiffness = contact.slope(gap, state)
    return active, where(active, force, 0.0), where(active, stiffness, 0.0)


PAPER_ELEMENTS = 66  # of the mesh whose every node the paper gives the stiffness K_c
CLEARANCE = 1e-3  # L: where nothing pushes from afar, a robot this high is in the air
PER_LENGTH = "per_length"


def weighting() -> Any:
    """A field: whether refining the mesh shares a law's stiffness out, or adds to it."""
    return choice(PER_LENGTH, (PER_LENGTH, "per_node"), doc="per_length converges under refinement")


class ContactOptions(Part):
    """A contact law and its numbers."""

    group = "contact"
    absent: ClassVar[bool] = False  # whether there is no ground at all
    pushes: ClassVar[bool] = True
    force_is_of_position: ClassVar[bool] = True  # and not of what a constraint calls for

    @required
    def law(self, scales: Scales) -> Any:
        """The dimensionless law: a member of :class:`ContactLaw`."""

    @property
    def per_length(self) -> bool:
        """Whether the force belongs to a length of the beam, and not to a node."""
        return getattr(self, "weighting", PER_LENGTH) == PER_LENGTH

    def ground(self, scales: Scales, elements: int | None) -> Ground:
        """Shares of the law's force at nodes and corners, and where a robot is in the air.

        Per length, a node's share falls as the mesh is refined; a lone mass, without elements, has
        all of it.
        """
        law = self.law(scales)
        return Ground(
            node_share=PAPER_ELEMENTS / elements if elements and self.per_length else 1.0,
            corner_share=1.0,
            clearance=law.reach() if law.keeps_open() else CLEARANCE,
        )
