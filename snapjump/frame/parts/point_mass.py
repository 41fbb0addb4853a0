"""Points with mass."""

from typing import Any

from snapjump.number.dispatch import kernel


@kernel
def rotation_of(mass: Any, state: Any, velocity: Any, i: Any, about: Any) -> Any:
    """Angular momentum and moment of inertia of a point, whose coordinates begin at i, about a
    moving point (x, y, vx, vy)."""
    x, y, vx, vy = about
    rx = state[i] - x
    ry = state[i + 1] - y
    momentum = mass * (rx * (velocity[i + 1] - vy) - ry * (velocity[i] - vx))
    return momentum, mass * (rx * rx + ry * ry)
