"""The paper's baseline robot, its ranges, and the settings of the jumps and snaps about it."""

import math
from collections.abc import Mapping
from typing import Any

from experiments.compositions import Groups, changed, composed, described
from snapjump.composition import Simulation, with_tier
from snapjump.plan.parts.axes import default_axes
from snapjump.targets.simulator import at_tier

AXES = default_axes()
# delta_alpha (rad), epsilon, m_bar, mu
BASELINE = (0.1, 0.2, 0.768, 0.3)
NAMES = tuple(axis.column for axis in AXES)
SYMBOLS = {axis.column: axis.short for axis in AXES}
PLAIN = {name: symbol.removesuffix(" (rad)") for name, symbol in SYMBOLS.items()}
RANGES = {axis.column: axis.range for axis in AXES}
LABELS = {
    "mount_height_bar": "mount height h / L",
    "delta_alpha_rad": "mismatch Δα (rad)",
    "epsilon": "pre-compression ε",
    "mass_bar": "mass m̄",
    "mu": "friction coefficient μ",
}
TIERS = ("standard", "paper", "reference")


def groups_at(groups: Mapping[str, Any], tier: str) -> Groups:
    """The same physical model at ``standard``, ``draft`` or ``reference``; all of the paper's own
    settings at ``paper``, whose friction, damping and contact weighting are part of the tier."""
    return described(simulation_at(groups, tier))


def simulation_at(groups: Mapping[str, Any], tier: str) -> Simulation:
    """The simulation of :func:`groups_at`."""
    base = composed(groups)
    if tier == base.accuracy:
        return base
    if tier == "paper":
        kept = {part: getattr(base, part) for part in ("robot", "design", "environment")}
        return with_tier("paper", **kept)
    return at_tier(base, tier)


RATE_RAD_S = 20.0  # the paper's
SETTINGS = ("standard", "paper", "undamped", "reference", "undamped reference")
PAPER_ELEMENTS = 99  # the paper's snap study has 100 nodes
# Without damping the elements' own stretching makes adaptive steps ten times as small as they need
# to be for the midpoint; tests/physics compares these with the independent solution.
UNDAMPED_STEP_S = {"undamped": 1e-5, "undamped reference": 2.5e-6}
# The critical angle is 2.02 to 2.06 sqrt(epsilon), and a snap at 20 rad/s is 4 % late.
LAST_ANGLE = 2.2
AFTERWARDS_S = 3e-3
BARE = {
    "frame": {"name": "fixed"},
    "contact": {"name": "none"},
    "friction": {"name": "none"},
    "backend": {"name": "scalar"},
}


def snap_groups(groups: Mapping[str, Any], setting: str) -> Groups:
    """The snap of a composition of a jump at one of the SETTINGS."""
    tier = setting.removeprefix("undamped").strip() or "standard"
    bare = changed(groups_at(groups, tier), {**BARE, "sim": {"name": "snap"}})
    if setting == "paper":
        return changed(bare, {"discretization": {"elements": PAPER_ELEMENTS}})
    if setting in UNDAMPED_STEP_S:
        step = {"name": "fixed", "step_s": UNDAMPED_STEP_S[setting]}
        return changed(bare, {"damping": {"name": "none"}, "stepping": step})
    return bare


def snap_of(
    groups: Mapping[str, Any], epsilon: float, delta_alpha: float, rate_rad_s: float = RATE_RAD_S
) -> Simulation:
    """One snap, followed until a little after its end."""
    duration = LAST_ANGLE * math.sqrt(epsilon) / rate_rad_s + AFTERWARDS_S
    return composed(
        changed(
            groups,
            {
                "design": {"epsilon": epsilon, "delta_alpha": delta_alpha},
                "robot": {"rotation_rate_rad_s": rate_rad_s},
                "sim": {"duration_s": duration},
            },
        )
    )
