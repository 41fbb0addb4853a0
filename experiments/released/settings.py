"""The released program's settings, and what they are when one of its quirks is left out."""

from pathlib import Path
from typing import Any

import yaml

from snapjump.composition import with_tier

from ..compositions import Groups, changed, described

FILE = Path(__file__).resolve().parents[2] / "conf" / "experiment" / "released.yaml"

# What each quirk is changed to, one at a time.
WITHOUT: dict[str, dict[str, dict[str, Any]]] = {
    "clear span shorter by 0.597 mm": {"frame": {"inset_m": 0.0}},
    "fitted mount height (now: just touching)": {"robot": {"mount_height": "optimal"}},
    "mount rounded to an edge's middle": {"frame": {"mount": "exact"}},
    "frame stretches like the beam (now: a thousandth)": {"frame": {"stretching_ratio": 1000.0}},
    "frame bends (now: a hundredth)": {"frame": {"bending_ratio": 1.0e5}},
    "right clamp follows half of its leg (now: all)": {"frame": {"right_follow": 1.0}},
    "mass_bar without the beam (now: with it)": {"frame": {"beam_on_top": False}},
    "contact at all frame nodes (now: corners)": {"frame": {"contact": "corners"}},
    "contact per node (now: per length)": {"contact": {"weighting": "per_length"}},
    "two fixed nodes a clamp (now: half elements)": {"discretization": {"clamp": "half_element"}},
    "start from flat clamps (now: 0.85 of the way)": {"sim": {"start_fraction": 0.85}},
    "time step 10 us (now: 2 us)": {"stepping": {"step_s": 2.0e-6}},
    "drag of 0.01 1/s (now: none)": {"damping": {"name": "mass_proportional", "rate_1_s": 0.0}},
    "lagged friction (now: implicit)": {
        "friction": {"name": "implicit", "velocity_threshold_m_s": 1.0e-4}
    },
}


def released() -> Groups:
    """All quirks together, as ``+experiment=released`` has them."""
    quirks = yaml.safe_load(FILE.read_text(encoding="utf-8"))
    chosen = {
        group.removeprefix("override /"): name
        for choice in quirks.pop("defaults")
        for group, name in choice.items()
    }
    base = described(with_tier(chosen.pop("accuracy")))
    members = changed(base, {family: {"name": name} for family, name in chosen.items()})
    return changed(members, quirks)


def converged() -> Groups:
    """Our reference tier: what the same designs come to without numerical error."""
    return described(with_tier("reference"))
