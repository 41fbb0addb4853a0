"""Combinations that are refused, with what is random about them and the key that is to blame."""

from collections.abc import Callable
from typing import Any

import numpy as np

from snapjump.declare.members import member_names, members_with

Make = Callable[[np.random.Generator], dict[str, Any]]
WITHOUT_GROUND = ("snap", "static", "cantilever")
BARE: dict[str, Any] = {
    "frame": {"name": "fixed"},
    "contact": {"name": "none"},
    "friction": {"name": "none"},
    "damping": {"name": "none"},
}


def one_of(random: np.random.Generator, words: Any) -> str:
    """One of some words."""
    return str(random.choice(list(words)))


def ground_where_there_is_none(random: np.random.Generator) -> dict[str, Any]:
    """A contact law in a scene without ground."""
    scene = {"name": one_of(random, WITHOUT_GROUND)}
    return {
        **BARE,
        "sim": scene,
        "contact": {"name": one_of(random, members_with("contact", "pushes"))},
    }


def friction_where_there_is_none(random: np.random.Generator) -> dict[str, Any]:
    """Friction in a scene without ground."""
    scene = {"name": one_of(random, WITHOUT_GROUND)}
    return {**BARE, "sim": scene, "friction": {"name": one_of(random, ("implicit", "lagged"))}}


def frame_where_there_is_none(random: np.random.Generator) -> dict[str, Any]:
    """A frame that moves in a scene without one."""
    scene = {"name": one_of(random, WITHOUT_GROUND)}
    return {**BARE, "sim": scene, "frame": {"name": "rigid"}}


def many_at_once(random: np.random.Generator) -> dict[str, Any]:
    """Lanes outside a jump."""
    scene = {"name": one_of(random, WITHOUT_GROUND)}
    return {**BARE, "sim": scene, "backend": {"name": "lanes"}}


def impact_law(random: np.random.Generator) -> dict[str, Any]:
    """Signorini's law with a method of more than one velocity a step."""
    others = set(member_names("integrator")) - set(
        members_with("integrator", "velocities_at_step_ends")
    )
    return {"contact": {"name": "signorini"}, "integrator": {"name": one_of(random, others)}}


def impact_law_with_lag(random: np.random.Generator) -> dict[str, Any]:
    """Signorini's law with lagged friction."""
    return {
        "contact": {"name": "signorini", "restitution": float(random.uniform())},
        "integrator": {"name": "implicit_euler"},
        "friction": {"name": "lagged"},
    }


def explicit_damping(random: np.random.Generator) -> dict[str, Any]:
    """Explicit steps with material damping."""
    return {
        "integrator": {"name": "central_difference"},
        "damping": {"name": "kelvin_voigt", "relaxation_time_s": float(random.uniform(5e-6, 1e-3))},
    }


def value(group: str, key: str, low: float, high: float, **others: Any) -> Make:
    """A number that does not go with the others of its group."""
    return lambda random: {group: {**others, key: float(random.uniform(low, high))}}


def member(**names: str) -> Make:
    """Members that do not go together, nothing random about them."""
    groups = {family: {"name": name} for family, name in names.items()}
    return lambda random: dict(groups)


def mass_without_ground(random: np.random.Generator) -> dict[str, Any]:
    """A lone mass that nothing stops."""
    return {**BARE, "sim": {"name": one_of(random, ("bounce", "slide"))}}


def flat_arch(random: np.random.Generator) -> dict[str, Any]:
    """A pre-compression that the beam takes without buckling."""
    return {"design": {"epsilon": float(10.0 ** random.uniform(-12.0, -4.8))}}


def endless_record(random: np.random.Generator) -> dict[str, Any]:
    """More samples than memory holds."""
    return {"sim": {"name": "jump", "time_limit_s": float(10.0 ** random.uniform(1.0, 300.0))}}


COMBINATIONS: tuple[tuple[str, Make], ...] = (
    ("contact", member(sim="jump", contact="none")),
    ("frame", member(sim="jump", frame="fixed")),
    ("contact", mass_without_ground),
    ("contact", ground_where_there_is_none),
    ("friction", friction_where_there_is_none),
    ("frame", frame_where_there_is_none),
    ("backend", many_at_once),
    ("integrator", impact_law),
    ("contact", impact_law_with_lag),
    ("damping", explicit_damping),
    ("environment.mass_bar", value("environment", "mass_bar", 1e-9, 9.6e-3)),
    ("robot.gravity_m_s2", value("robot", "gravity_m_s2", 0.0, 1e-16)),
    ("robot.thickness_m", value("robot", "thickness_m", 2.1e-3, 1.0)),
    ("robot.thickness_m", value("robot", "length_m", 1e-9, 4e-4)),
    ("robot.mount_height", value("robot", "mount_height", 0.0101, 1.0)),
    ("robot.mount_height", value("robot", "mount_height", 1e-9, 1e-5)),
    ("robot.rotation_end_rad", value("robot", "rotation_end_rad", 0.0, 0.7)),
    ("design.epsilon", flat_arch),
    ("integrator.beta", value("integrator", "beta", 0.0, 0.44, name="newmark", gamma=0.9)),
    ("sim.sample_interval_s", endless_record),
    ("accuracy.name", member(accuracy="best")),
)
