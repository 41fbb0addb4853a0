"""Where the error estimate of a jump is known to hold: members, and ranges of dimensionless groups.

Both are those of the robots that it was calibrated with (``python -m experiments.claims``). Beyond
them a jump does not know its error, and says so.
"""

from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

import numpy as np

from snapjump.arrays import Flags, distinct_rows
from snapjump.composition import Simulation

# By family and member: the factor by which errors are larger than with the default one.
MEMBERS: Mapping[str, Mapping[str, float]] = {
    "discretization": {"der": 1.0, "corotational": 1.0, "geometrically_exact": 1.2},
    "frame": {"rigid": 1.0},
    "contact": {"logbarrier": 1.0, "penalty": 5.0, "hunt_crossley": 3.0},
    "friction": {"implicit": 1.0, "none": 1.0},
    "damping": {"kelvin_voigt": 1.0},
    "drive": {"constant_rate": 1.0},
    "drag": {"none": 1.0, "quadratic": 1.0},
    "stepping": {"fixed": 1.0, "adaptive": 1.0},
}


class Group(NamedTuple):
    """A dimensionless group of a robot: what it is, its range, and how a model tells it."""

    meaning: str
    low: float
    high: float
    read: Callable[[Any], Any]


def beam_over_frame(model: Any) -> Any:
    """Mass of the beam over that of the frame."""
    return 1.0 / model.frame.mass


def relaxation(model: Any) -> Any:
    """Relaxation time of the material (T), 0 without."""
    return getattr(model.damping, "relaxation_time", 0.0)


def rate(model: Any) -> Any:
    """Rate of the clamps (rad/T)."""
    return model.clamp.rate


def friction(model: Any) -> Any:
    """Coefficient of friction."""
    return model.friction.largest_ratio()


def stick_zone(model: Any) -> Any:
    """Half width of the stick zone (L/T) that steps resolve; without friction of no account."""
    law = model.friction
    if not law:
        return 1e-3
    numbers = np.array(np.broadcast_arrays(*law), dtype=float)
    # A law of anybody's own is read one by one; many robots have the same.
    laws, places = distinct_rows(numbers.reshape(len(law), -1).T)
    zones = np.array([law._make(each).stick_speed() for each in laws.tolist()], dtype=float)
    return np.where(friction(model) > 0.0, zones[places].reshape(numbers.shape[1:]), 1e-3)


def mount_height(model: Any) -> Any:
    """Height of the clamps over about the depth to which the critical arch hangs."""
    compression = 1.0 - 2.0 * model.frame.half_span
    return (model.frame.mount_y - model.frame.foot_y) / (0.1646 * np.sqrt(compression))


def frame_height(model: Any) -> Any:
    """Height of the frame (L)."""
    return model.frame.top_y - model.frame.foot_y


def mass_height(model: Any) -> Any:
    """Height of the frame's centre of mass over the frame's; of one without, a half."""
    frame = model.frame
    return -frame.foot_y / frame_height(model) if hasattr(frame, "inertia") else 0.5


def mass_offset(model: Any) -> Any:
    """Distance of the frame's centre of mass from the middle, over half the clear span."""
    return np.abs(getattr(model.frame, "offset", 0.0)) / model.frame.half_span


def gyration(model: Any) -> Any:
    """Radius of gyration of the frame over its diagonal; of a frame without, a third."""
    frame = model.frame
    diagonal = np.hypot(2.0 * frame.half_span, frame_height(model))
    return (
        np.sqrt(frame.inertia / frame.mass) / diagonal if hasattr(frame, "inertia") else 1.0 / 3.0
    )


def drag(model: Any) -> Any:
    """Deceleration by the air over the speed squared (1/L), 0 without."""
    return getattr(model.drag, "per_length", 0.0)


def reach(model: Any) -> Any:
    """Reach of the ground (L); of a law that begins at its surface it is of no account."""
    found = np.asarray(model.contact.reach())
    return np.where(found > 0.0, found, 0.025)


def mismatch(model: Any) -> Any:
    """Mismatch of the clamps over about the angle at which a flat arch snaps."""
    compression = 1.0 - 2.0 * model.frame.half_span
    return np.abs(model.clamp.delta_alpha) / (2.0 * np.sqrt(compression))


def against_throw(model: Any) -> Any:
    """Offset of the frame's centre of mass over half the clear span, where it is to the side that
    the mismatch does not throw to, and in proportion where that is slight; 0 elsewhere."""
    throws = np.sign(model.clamp.delta_alpha) * np.minimum(1.0, mismatch(model) / 0.05)
    offset = getattr(model.frame, "offset", 0.0) / model.frame.half_span
    return np.maximum(0.0, -offset * throws)


def unlike_rates(model: Any) -> Any:
    """By how much the clamps' rates differ, over the left one's."""
    return np.abs(model.clamp.right_over_left() - 1.0)


GROUPS = (
    Group("mass of the beam over that of the frame", 0.0, 4.0, beam_over_frame),
    Group("relaxation time of the material over T", 2e-5, 0.2, relaxation),
    Group("rate of the clamps times T (rad)", 1e-3, 4.0, rate),
    Group("friction coefficient", 0.0, 1.2, friction),
    Group("height of the clamps over the depth of the critical arch", 0.25, 4.0, mount_height),
    Group("mismatch over the angle at which the arch snaps", 0.0, 0.6, mismatch),
    Group("stick zone that steps resolve, over L/T", 1e-6, 0.03, stick_zone),
    Group("stiffness of the ground over EI/L^3", 30.0, 1e7, lambda m: m.contact.stiffness),
    Group("reach of the ground over L", 2e-3, 0.15, reach),
    Group("height of the frame over L", 0.0, 5.0, frame_height),
    Group("height of the frame's centre of mass over the frame's", 0.1, 1.5, mass_height),
    Group("offset of that centre over half the clear span", 0.0, 0.35, mass_offset),
    Group("radius of gyration of the frame over its diagonal", 0.12, 0.9, gyration),
    Group("deceleration by drag over the speed squared, times L", 0.0, 0.1, drag),
    Group("difference of the clamps' rates over the left one's", 0.0, 0.0, unlike_rates),
    Group("tangent of the slope", 0.0, 0.2, lambda m: abs(m.load.downhill / m.load.cosine)),
)


def members_factor(simulation: Simulation) -> float:
    """Factor of the chosen members; NaN with one that has not been calibrated."""
    factors = [known.get(getattr(simulation, family).name, np.nan)
               for family, known in MEMBERS.items()]  # fmt: skip
    return float(np.prod(factors))


def unknown_because(simulation: Simulation, model: Any) -> Any:
    """Why errors are not known here, a word for each of the models side by side; empty if they are.

    ``model``: numbers of R robots, or of one.
    """
    for family, known in MEMBERS.items():
        name = getattr(simulation, family).name
        if name not in known:
            return f"{family}={name} has not been calibrated"
    if getattr(simulation.sim, "start_fraction", 0.0) > 0.0:
        return "sim.start_fraction leaves out a part of the loading"
    words = [f"{group.meaning} outside [{group.low:g}, {group.high:g}]" for group in GROUPS]
    first: Any = -1  # the first group that is outside; the last word, if none is
    for place, group in reversed([*enumerate(GROUPS)]):
        value = np.asarray(group.read(model), dtype=float)
        outside: Flags = ~((value >= group.low) & (value <= group.high))
        first = np.where(outside, place, first)
    return np.array([*words, ""], dtype=object)[first]
