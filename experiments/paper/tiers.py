"""The composition of the run at another accuracy tier."""

from collections.abc import Mapping
from typing import Any

from experiments.compositions import Groups, composed, described
from snapjump.composition import Simulation, with_tier
from snapjump.targets.simulator import at_tier


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
