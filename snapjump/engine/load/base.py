"""Dead loads: the contract that every load fulfils. Forces in EI/L^2, moments in EI/L."""

from typing import Any

from snapjump.number.methods import Contract


class Load(Contract):
    """Weight and dead forces; by default there are none."""

    def gravity(self) -> Any:
        """Acceleration into the ground (in L/T^2)."""
        return 0.0

    def pull(self) -> Any:
        """Acceleration along +x (in L/T^2), of masses on a slope."""
        return 0.0

    def creep(self) -> Any:
        """Velocity along +x (in L/T) at which friction holds what rests on a slope."""
        return 0.0

    def rise(self, vx: Any, vy: Any) -> Any:
        """Velocity against gravity (in L/T) of velocities along and across the ground."""
        return vy

    def time_to_apex(self, vx: Any, vy: Any) -> Any:
        """When (in T) a free flight is highest against gravity."""
        return 0.0 * vy

    def tip_load(self) -> Any:
        """Force (x, y) on the last node and moment on the last tangent."""
        return 0.0, 0.0, 0.0
