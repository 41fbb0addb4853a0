"""The two-parameter maps: what is varied, over which values, and what the truth depends on."""

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

from snapjump.declare.members import members_with

from ..compositions import Groups, changed
from ..designs import BASELINE, Design

INTEGRATORS = (
    "tr_bdf2", "sdirk2", "esdirk3", "bdf2", "newmark", "generalized_alpha", "implicit_euler",
    "implicit_midpoint",
)  # fmt: skip
SPLIT = ("steps", "law")  # maps with a cell for every value going up: one compilation each
# The laws that have a stiffness.
LAWS = tuple(
    law
    for law in members_with("contact", "pushes")
    if law in members_with("contact", "force_is_of_position")
)
# Eight that share an epsilon, so that a mesh's statics are solved once.
DESIGNS: tuple[Design, ...] = (
    BASELINE, (0.03, 0.2, 0.4, 0.15), (0.18, 0.2, 1.8, 0.5), (0.06, 0.2, 1.2, 0.6),
    (0.15, 0.2, 0.6, 0.2), (0.01, 0.2, 0.9, 0.4), (0.12, 0.2, 0.35, 0.55), (0.08, 0.2, 1.5, 0.1),
)  # fmt: skip


@dataclass(frozen=True)
class Axis:
    """A parameter: its label and its values, numbers or names of members."""

    label: str
    values: tuple[Any, ...]


@dataclass(frozen=True)
class Map:
    """Two parameters and the groups that a pair of their values changes.

    ``own_truth``: whether every pair is another physical problem, which has an answer of its own;
    else only numerics vary. ``designs``: simulated at every pair, none for the configured one.
    """

    name: str
    across: Axis
    up: Axis
    own_truth: bool
    designs: tuple[Design, ...] = ()

    @property
    def parts(self) -> dict[str, tuple[Any, ...]]:
        """Cells by their names, each with its values going up."""
        if self.name in SPLIT:
            return {f"{self.name}, {up}": (up,) for up in self.up.values}
        return {self.name: self.up.values}

    def groups(self, base: Groups, across: Any, up: Any) -> Groups:
        return changed(base, CHANGES[self.name](across, up))


def _gravity(gravity: float, friction: float) -> Mapping[str, Any]:
    # Of the paper's 4 g, whose mass_bar is 0.768 at 10 m/s^2.
    mass_bar = 0.768 * gravity / 10.0
    return {
        "robot": {"gravity_m_s2": gravity},
        "environment": {"mass_bar": mass_bar or 0.768, "mu": friction},
    }


def _mass(mass_bar: float, rate: float) -> Mapping[str, Any]:
    # Slow clamps need their time; the interval matters to no outcome, only to what is allowed.
    return {
        "environment": {"mass_bar": mass_bar},
        "drive": {"rate_rad_s": rate},
        "sim": {"time_limit_s": 0.08 + 1.0 / rate, "sample_interval_s": 1e-3},
    }


CHANGES: Mapping[str, Any] = {
    "steps": lambda dt, name: {
        "integrator": {"name": name},
        "stepping": {"name": "fixed", "step_s": dt},
    },
    "barrier": lambda k, d: {"contact": {"stiffness_N_m": k, "distance_m": d}},
    "friction": lambda v, mu: {
        "friction": {"velocity_threshold_m_s": v},
        "environment": {"mu": mu},
    },
    "design": lambda e, lag: {"design": {"epsilon": e, "delta_alpha": lag}},
    "mass": _mass,
    "mesh": lambda n, tol: {"discretization": {"elements": n}, "stepping": {"tolerance": tol}},
    "law": lambda k, law: {"contact": {"name": law, "stiffness_N_m": k}},
    "gravity": _gravity,
}


def maps(full: bool) -> list[Map]:
    """All maps; ``full``: on finer grids."""
    grid = _finer if full else lambda *values: values
    steps = grid(1e-8, 1e-7, 1e-6, 3e-6, 1e-5, 3e-5, 1e-4, 3e-4, 1e-3, 3e-3, 1e-2)
    stiffness = grid(1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8)
    distances = grid(1e-6, 1e-5, 3e-5, 1e-4, 3e-4, 1e-3, 2e-3)
    thresholds = grid(1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1)
    friction = grid(0.0, 0.05, 0.1, 0.3, 0.6, 1.0, 2.0, 5.0)
    epsilon = grid(1e-3, 3e-3, 1e-2, 3e-2, 0.1, 0.2, 0.3, 0.4)
    lag = grid(0.0, 1e-4, 1e-3, 1e-2, 0.05, 0.1, 0.19, 0.3, 0.5)
    mass = grid(0.005, 0.01, 0.03, 0.1, 0.3, 1.0, 3.0, 10.0, 30.0, 100.0)
    rates = grid(0.1, 1.0, 10.0, 20.0, 100.0, 300.0, 1000.0)
    gravity = (0.0, 1e-3, 0.1, 1.62, 9.81, 100.0)
    tolerances = (1e-10, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2)
    elements: tuple[int, ...] = (8, 16, 32, 56, 104, 224, 2000)
    if full:
        elements = (8, 12, 16, 24, 32, 44, 56, 76, 104, 152, 224, 448, 1000, 2000)
    step, stiff = Axis("fixed step (s)", steps), Axis("K (N/m)", stiffness)
    return [
        Map("steps", step, Axis("integrator", INTEGRATORS), False, DESIGNS),
        Map("mesh", Axis("elements", elements), Axis("tolerance (L)", tolerances), False, DESIGNS),
        Map("barrier", stiff, Axis("d_hat (m)", distances), True),
        Map("friction", Axis("eps_v (m/s)", thresholds), Axis("mu", friction), True),
        Map("design", Axis("epsilon", epsilon), Axis("delta_alpha (rad)", lag), True),
        Map("mass", Axis("mass_bar", mass), Axis("rotation rate (rad/s)", rates), True),
        Map("law", stiff, Axis("contact law", LAWS), True),
        Map("gravity", Axis("gravity (m/s^2)", gravity), Axis("mu", (0.1, 0.6)), True),
    ]


def _finer(*values: float) -> tuple[float, ...]:
    """A finer grid: with the geometric mean between every two, the arithmetic one next to zero."""
    found = [values[0]]
    for low, high in pairwise(values):
        found += [(low * high) ** 0.5 if low > 0.0 else 0.5 * high, high]
    return tuple(float(f"{v:.4g}") for v in found)
