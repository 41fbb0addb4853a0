"""Accuracy tiers: which members and numbers go together, and what error they are known to make.

The physical model (damping, K_c, d_hat) is the same in draft, standard and reference; ``paper``
is the paper's own choice, for comparison. The figures in ``known_error`` are those of
``python run.py task=tradeoff``.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True)
class Tier:
    """An accuracy tier: members, numbers and its promise.

    ``members``: by family. ``numbers``: by the path of a field; one whose member has no such field
    is of none. ``promise_percent``: error of x and y that 95 % of the designs keep; a result whose
    own estimate is larger is marked.
    """

    members: Mapping[str, str]
    numbers: Mapping[str, Any]
    promise_percent: float
    known_error: str

    def numbers_of(self, family: str) -> dict[str, Any]:
        """The numbers of a family, by field."""
        paths = {path: path.partition(".") for path in self.numbers}
        return {key: self.numbers[p] for p, (group, _, key) in paths.items() if group == family}

    def departures(self, config: Mapping[str, Any]) -> list[str]:
        """Paths of what a configuration's members have otherwise than the tier."""
        chosen = {
            **{f"{family}.name": name for family, name in self.members.items()},
            **self.numbers,
        }
        return [
            path
            for path, value in chosen.items()
            if config.get(path.partition(".")[0], {}).get(path.partition(".")[2], value) != value
        ]


MEMBERS = {
    "integrator": "tr_bdf2",
    "stepping": "adaptive",
    "friction": "implicit",
    "damping": "kelvin_voigt",
}
NUMBERS = {
    "discretization.clamp": "half_element",
    "contact.weighting": "per_length",
    "stepping.contact_steps": 2.0,
    "stepping.step_s": 1e-5,
    "sim.start_fraction": 0.85,
}

TIERS: dict[str, Tier] = {
    "paper": Tier(
        members={
            "integrator": "implicit_euler",
            "stepping": "fixed",
            "friction": "lagged",
            "damping": "none",
        },
        numbers=NUMBERS
        | {
            "discretization.elements": 66,
            "discretization.clamp": "two_nodes",
            "contact.weighting": "per_node",
            "stepping.tolerance": 1e-6,
            "sim.start_fraction": 0.0,
        },
        promise_percent=20.0,
        known_error="x within 20 %, y within 7 % of the converged limit (95 % of designs)",
    ),
    "draft": Tier(
        members=MEMBERS,
        numbers=NUMBERS | {"discretization.elements": 56, "stepping.tolerance": 1e-6},
        promise_percent=3.0,
        known_error="x within 2.6 %, y within 0.4 % of the converged limit (95 % of designs)",
    ),
    "standard": Tier(
        members=MEMBERS,
        numbers=NUMBERS | {"discretization.elements": 104, "stepping.tolerance": 4.5e-8},
        promise_percent=0.5,
        known_error="x within 0.45 %, y within 0.12 % of the converged limit (95 % of designs)",
    ),
    "reference": Tier(
        members=MEMBERS,
        numbers=NUMBERS
        | {
            "discretization.elements": 224,
            "stepping.tolerance": 2e-9,
            "stepping.contact_steps": 1.0,
            "sim.start_fraction": 0.8,
        },
        promise_percent=0.05,
        known_error="x within 0.04 %, y within 0.02 % of the converged limit (95 % of designs)",
    ),
}
