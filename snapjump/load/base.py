"""Dead loads: the contract that every load fulfils. Forces in EI/L^2, moments in EI/L."""

from typing import Any

from snapjump.number.dispatch import family_function


@family_function
def gravity(load: Any) -> Any:
    """Downward acceleration (in L/T^2)."""


@family_function
def pull(load: Any) -> Any:
    """Acceleration along +x (in L/T^2), of masses on a slope."""


@family_function
def tip_load(load: Any) -> Any:
    """Force (x, y) on the last node and moment on the last tangent."""
