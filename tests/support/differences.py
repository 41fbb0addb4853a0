"""Limits and slopes by Richardson's extrapolation."""

from typing import Any


def richardson(coarse: Any, middle: Any, fine: Any, following: int = 4) -> Any:
    """Limit of values at h, h/2 and h/4 whose error has terms in h^2 and h^following."""
    first, second = (4.0 * middle - coarse) / 3.0, (4.0 * fine - middle) / 3.0
    share = 2.0**following
    return (share * second - first) / (share - 1.0)


def slope(function: Any, step: float) -> Any:
    """Derivative of a function of a change, at none: differences at three steps, extrapolated."""

    def difference(change: float) -> Any:
        return (function(change) - function(-change)) / (2.0 * change)

    return richardson(*(difference(step / share) for share in (1.0, 2.0, 4.0)))
