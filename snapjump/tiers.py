"""Accuracy tiers: which members and numbers go together, and what error they are known to make.

The physical model (damping, K_c, d_hat) is the same in draft, standard and reference; ``paper``
is the paper's own choice, for comparison. The errors that are known are those of
``python run.py task=tradeoff``.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from snapjump.checks import ParameterError, check_group


@dataclass(frozen=True)
class Tier:
    """An accuracy tier: members, numbers and its promise.

    ``members``: by family. ``numbers``: by the path of a field; one whose member has no such field
    is of none. ``promise_percent``: error of x and y that 95 % of the designs keep; a result whose
    own estimate is larger is marked. ``known_percent``: the errors of x and y that they make.
    """

    members: Mapping[str, str]
    numbers: Mapping[str, Any]
    promise_percent: float
    known_percent: tuple[float, float]

    @property
    def known_error(self) -> str:
        """The errors that are known, in words."""
        x, y = self.known_percent
        return f"x within {x:g} %, y within {y:g} % of the converged limit (95 % of designs)"

    def numbers_of(self, family: str) -> dict[str, Any]:
        """The numbers of a family, by field."""
        paths = {path: path.partition(".") for path in self.numbers}
        return {key: self.numbers[p] for p, (group, _, key) in paths.items() if group == family}

    def departures(self, config: Mapping[str, Any]) -> list[str]:
        """Paths of what a configuration's members have otherwise than the tier."""
        chosen = {f"{family}.name": name for family, name in self.members.items()}
        return [
            path
            for path, value in {**chosen, **self.numbers}.items()
            if config.get(path.partition(".")[0], {}).get(path.partition(".")[2], value) != value
        ]


FAMILIES = ("integrator", "stepping", "friction", "damping")
MEMBERS = dict(
    zip(FAMILIES, ("generalized_alpha", "adaptive", "implicit", "kelvin_voigt"), strict=True)
)
PAPER = dict(zip(FAMILIES, ("implicit_euler", "fixed", "lagged", "none"), strict=True))
NUMBERS = {
    "discretization.clamp": "half_element",
    "contact.weighting": "per_length",
    "friction.velocity_threshold_m_s": 1e-3,
    "integrator.spectral_radius": 0.5,
    "stepping.contact_steps": 2.0,
    "stepping.step_s": 1e-5,
}


def resolved(elements: int, tolerance: float, stick_share: float, **others: Any) -> dict[str, Any]:
    """Numbers of a tier with this mesh, tolerance and error over eps_v in a step."""
    mesh = {"discretization.elements": elements, "stepping.tolerance": tolerance}
    return {**NUMBERS, **mesh, "stepping.stick_share": stick_share, **others}


LIKE_THE_PAPER = {
    "discretization.clamp": "two_nodes",
    "contact.weighting": "per_node",
    "friction.velocity_threshold_m_s": 1e-4,
}
FINE = {"stepping.contact_steps": 1.0}
COARSE = {"stepping.contact_steps": 4.0, "integrator.spectral_radius": 0.3}
TIERS = {
    "paper": Tier(PAPER, resolved(66, 1e-6, 4.0, **LIKE_THE_PAPER), 20.0, (21, 5.8)),
    "draft": Tier(MEMBERS, resolved(56, 6e-6, 24.0, **COARSE), 3.0, (0.89, 0.38)),
    "standard": Tier(MEMBERS, resolved(120, 9e-7, 8.0), 0.5, (0.17, 0.1)),
    "reference": Tier(MEMBERS, resolved(320, 4e-8, 2.0, **FINE), 0.05, (0.022, 0.012)),
}

# Of the group ``accuracy``, whose numbers members of other groups refer to.
KEYS = ("name", "known_error", *dict.fromkeys(
    path.rpartition(".")[2] for tier in TIERS.values() for path in tier.numbers
))  # fmt: skip


def check_tier_keys(group: Any) -> None:
    """Raise ParameterError for a group ``accuracy`` with a key that is none of a tier's."""
    check_group("accuracy", group)
    for key, value in group.items():
        if key not in KEYS:
            raise ParameterError(f"accuracy.{key}", value, f"accuracy has {', '.join(KEYS)}")
