"""No contact: every contact term is left out of the compiled program."""

from typing import Any, NamedTuple

from snapjump.contact.base import ContactLaw, ContactOptions
from snapjump.units import Scales


class NoContact(ContactOptions):
    """No ground: every contact term is left out of the compiled program."""

    absent = True
    pushes = False

    @ContactLaw.member
    class Law(NamedTuple):
        """A world without ground."""

        def exists(self) -> bool:
            return False

        def active(self, gap: Any, state: Any) -> Any:
            return gap < -1.0e300

        def energy(self, gap: Any) -> Any:
            return 0.0 * gap

        def force(self, gap: Any, state: Any) -> Any:
            return 0.0 * gap

        def slope(self, gap: Any, state: Any) -> Any:
            return 0.0 * gap

        def bounce_rate_squared(self, stiffness: Any, mass: Any, speed: Any) -> Any:
            return 0.0 * speed

    def law(self, scales: Scales) -> Law:
        """The empty law."""
        return self.Law()
