"""Dead loads: the contract that every load fulfils. Forces in EI/L^2, moments in EI/L."""

from typing import Any

from snapjump.number.methods import Contract


class Load(Contract):
    """Weight and dead forces; by default there are none."""

    def gravity(self) -> Any:
        """Downward acceleration (in L/T^2)."""
        return 0.0

    def pull(self) -> Any:
        """Acceleration along +x (in L/T^2), of masses on a slope."""
        return 0.0

    def tip_load(self) -> Any:
        """Force (x, y) on the last node and moment on the last tangent."""
        return 0.0, 0.0, 0.0
