"""Mass, centre and moment of inertia of a frame: as they are measured, or evenly along its outline.

Lengths are in L, masses in rho A L; numbers may be arrays.
"""

from typing import Any, NamedTuple


class Lump(NamedTuple):
    """A body by its mass, the place (x, y) of its centre, and the moment of inertia about that."""

    mass: Any
    x: Any
    y: Any
    inertia: Any


def evenly(mass: Any, width: Any, height: Any, centre: Any) -> tuple[Any, Any]:
    """Of a mass that lies evenly along leg, top, leg: its first moment about the feet's height, and
    its moment of inertia about the point at ``centre`` above the middle between the feet."""
    leg = mass * height / (2.0 * height + width)
    top = mass * width / (2.0 * height + width)
    half = 0.5 * width
    to_leg, to_top = 0.5 * height - centre, height - centre
    legs = 2.0 * leg * (height * height / 12.0 + to_leg * to_leg + half * half)
    return leg * height + top * height, legs + top * (width * width / 12.0 + to_top * to_top)


def measured(
    mass: Any, width: Any, height: Any, place: tuple[Any, Any | None], inertia: Any | None
) -> Lump:
    """A frame whose centre is ``place`` (right of the middle, above the feet), with an inertia
    about it; what is None is as of a mass evenly along leg, top, leg."""
    x, y = place
    moment, _ = evenly(mass, width, height, 0.0)
    even = moment / mass
    if inertia is None:
        _, inertia = evenly(mass, width, height, even)
    return Lump(mass, x, even if y is None else y, inertia)


def evenly_with_ends(mass: Any, width: Any, height: Any, end: Any, mount: Any) -> Lump:
    """A mass evenly along leg, top, leg, with another at either clamp, at ``mount`` above the
    feet."""
    total, half = mass + 2.0 * end, 0.5 * width
    moment, _ = evenly(mass, width, height, 0.0)
    y = (moment + 2.0 * end * mount) / total
    _, inertia = evenly(mass, width, height, y)
    ends = 2.0 * end * (half * half + (mount - y) * (mount - y))
    return Lump(total, 0.0, y, inertia + ends)


def with_ends(frame: Lump, end: Any, half: Any, mount: Any) -> Lump:
    """The frame with a mass at either clamp, at ``mount`` above the feet and ``half`` either side
    of the middle."""
    total = frame.mass + 2.0 * end
    x = frame.mass * frame.x / total
    y = (frame.mass * frame.y + 2.0 * end * mount) / total
    own = frame.inertia + frame.mass * ((frame.x - x) ** 2 + (frame.y - y) ** 2)
    ends = 2.0 * end * (half * half + x * x + (mount - y) ** 2)
    return Lump(total, x, y, own + ends)
