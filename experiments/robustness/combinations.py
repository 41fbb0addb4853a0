"""Combinations that are refused, with what is random about them and the key that is to blame."""

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from snapjump.declare.members import member_class, member_names, members_with
from snapjump.sim.base import NO_GROUND, WITHOUT_GROUND

from .fields import one_of

Make = Callable[[np.random.Generator], dict[str, Any]]


def others(family: str, capability: str) -> list[str]:
    """The members without a capability."""
    return [name for name in member_names(family) if name not in members_with(family, capability)]


def bare(scenes: Sequence[str], **families: Sequence[str]) -> Make:
    """A scene with nothing about it but members that do not go with it, each one of some."""

    def make(random: np.random.Generator) -> dict[str, Any]:
        members = {"damping": "none", **WITHOUT_GROUND, "sim": one_of(random, scenes)}
        members |= {family: one_of(random, names) for family, names in families.items()}
        return {family: {"name": name} for family, name in members.items()}

    return make


def member(**names: str) -> Make:
    """Members that do not go together, nothing random about them."""
    return lambda random: {family: {"name": name} for family, name in names.items()}


def value(group: str, key: str, low: float, high: float, **fixed: Any) -> Make:
    """A number that does not go with the others of its group."""
    return lambda random: {group: {**fixed, key: float(random.uniform(low, high))}}


def power(group: str, key: str, low: float, high: float, **fixed: Any) -> Make:
    """A number of any magnitude, between powers of ten, that does not go with the others."""
    return lambda random: {group: {**fixed, key: float(10.0 ** random.uniform(low, high))}}


def together(*makes: Make) -> Make:
    """The groups of several makers together."""
    return lambda random: {group: one for make in makes for group, one in make(random).items()}


def impact_law(random: np.random.Generator) -> dict[str, Any]:
    """Signorini's law with a method of more than one velocity a step."""
    integrator = one_of(random, others("integrator", "velocities_at_step_ends"))
    return {"contact": {"name": "signorini"}, "integrator": {"name": integrator}}


SCENES = {name: member_class("sim", name)() for name in member_names("sim")}
AIRBORNE = [name for name, scene in SCENES.items() if set(NO_GROUND) <= set(scene.needs)]
OF_A_MASS = [n for n, scene in SCENES.items() if n not in AIRBORNE and not scene.moves_a_beam]
COMBINATIONS: tuple[tuple[str, Make], ...] = (
    ("contact", member(sim="jump", contact="none")),
    ("frame", member(sim="jump", frame="fixed")),
    ("contact", bare(OF_A_MASS)),
    ("contact", bare(AIRBORNE, contact=members_with("contact", "pushes"))),
    ("friction", bare(AIRBORNE, friction=others("friction", "absent"))),
    ("frame", bare(AIRBORNE, frame=["rigid"])),
    ("backend", bare(AIRBORNE, backend=["lanes"])),
    ("integrator", impact_law),
    ("contact", together(
        value("contact", "restitution", 0.0, 1.0, name="signorini"),
        member(integrator="implicit_euler", friction="lagged"),
    )),
    ("damping", together(
        member(integrator="central_difference"),
        value("damping", "relaxation_time_s", 5e-6, 1e-3, name="kelvin_voigt"),
    )),
    ("environment.mass_bar", value("environment", "mass_bar", 1e-9, 9.6e-3)),
    ("robot.gravity_m_s2", value("robot", "gravity_m_s2", 0.0, 1e-16)),
    ("robot.thickness_m", value("robot", "thickness_m", 2.1e-3, 1.0)),
    ("robot.thickness_m", value("robot", "length_m", 1e-9, 4e-4)),
    ("robot.mount_height", value("robot", "mount_height", 0.0101, 1.0)),
    ("drive.end_rad", value("drive", "end_rad", 0.0, 0.7)),
    ("design.epsilon", power("design", "epsilon", -12.0, -4.8)),  # taken without buckling
    ("integrator.beta", value("integrator", "beta", 0.0, 0.44, name="newmark", gamma=0.9)),
    # More samples than memory holds.
    ("sim.sample_interval_s", power("sim", "time_limit_s", 1.0, 300.0, name="jump")),
    ("accuracy.name", member(accuracy="best")),
)  # fmt: skip
