"""Gap at which a weight rests on the ground."""

from typing import Any

from snapjump.contact.base import at_rest, force_if_active
from snapjump.number.dispatch import compiled

HALVINGS = 60


@compiled
def resting_gap(contact: Any, weight: float, points: float) -> float:
    """Gap (in L) at which a law carries a weight (in EI/L^2) at so many points.

    By bisection: the force falls with the gap, and vanishes at the law's reach.
    """
    high = 1.0 * contact.reach()
    if weight == 0.0:
        return high
    low = 1e-12 * high
    if not contact.keeps_open():
        depth = 1e-9
        low = high - depth
        while points * force_if_active(contact, low, at_rest(low))[1] < weight:
            depth *= 2.0
            low = high - depth
    for _ in range(HALVINGS):
        gap = 0.5 * (low + high)
        if points * force_if_active(contact, gap, at_rest(gap))[1] > weight:
            low = gap
        else:
            high = gap
    return 0.5 * (low + high)
