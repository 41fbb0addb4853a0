"""Compositions of the beam alone, at rest and in motion, as the comparisons need them."""

import math
from collections.abc import Mapping
from typing import Any

from ..arches.swings import BARE, SNAP
from ..compositions import Groups, changed, composed

# Shallow, so that the closed form is near, and so mismatched that the branch ends at a fold far
# from the pitchfork: clamps turned alike would meet that one first.
EPSILON = 0.01
MISMATCH = 1.0  # over sqrt(epsilon)
ELEMENTS = 56  # the fold is that of the same mesh
# Over momentum (1/T): far above any frequency of the arch close to its fold.
DRAG = 100.0
INERTIA, DAMPING = "inertia", "damping"
STEP_S = 4e-5  # of the undamped arch, a hundredth of T; of the damped one steps adapt
TOLERANCE = 1e-7
WITHOUT_DRAG = {"drag": {"name": "none"}}
AT_REST = {**BARE, **WITHOUT_DRAG, "damping": {"name": "none"}}


def static_groups(groups: Mapping[str, Any]) -> Groups:
    """The arch at rest, which neither frame nor ground know of."""
    return changed(groups, {**AT_REST, "sim": {"name": "static"}})


def snapping_groups(groups: Mapping[str, Any], regime: str) -> Groups:
    """A shallow mismatched arch that snaps alone, resisted by its inertia or by a drag on it."""
    made = changed(
        groups,
        {
            **AT_REST,
            **SNAP,
            "design": {"epsilon": EPSILON, "delta_alpha": MISMATCH * math.sqrt(EPSILON)},
            "discretization": {"elements": ELEMENTS},
        },
    )
    if regime == INERTIA:
        steps = {"name": "fixed", "step_s": STEP_S}
        return changed(made, {"integrator": {"name": "tr_bdf2"}, "stepping": steps})
    unit_s = composed(made).robot.scales.time_s
    drag = {"name": "mass_proportional", "rate_1_s": DRAG / unit_s}
    return changed(made, {"damping": drag, "stepping": {"tolerance": TOLERANCE}})
