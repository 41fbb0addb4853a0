"""Snaps of the beam alone, at several settings: what they are composed of."""

import math
from collections.abc import Mapping
from typing import Any

from snapjump.composition import Simulation

from ..compositions import Groups, changed, composed, groups_at

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
# Clamps that turn at once would shake the arch.
SNAP = {"sim": {"name": "snap"}, "drive": {"name": "smooth_start"}}


def snap_groups(groups: Mapping[str, Any], setting: str) -> Groups:
    """The snap of a composition of a jump at one of the SETTINGS."""
    tier = setting.removeprefix("undamped").strip() or "standard"
    bare = changed(groups_at(groups, tier), {**BARE, **SNAP})
    if setting == "paper":
        return changed(bare, {"discretization": {"elements": PAPER_ELEMENTS}})
    if setting in UNDAMPED_STEP_S:
        step = {"name": "fixed", "step_s": UNDAMPED_STEP_S[setting]}
        undamped = {"damping": {"name": "none"}, "integrator": {"name": "tr_bdf2"}}
        return changed(bare, {**undamped, "stepping": step})
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
                "drive": {"rate_rad_s": rate_rad_s},
                "sim": {"duration_s": duration},
            },
        )
    )
