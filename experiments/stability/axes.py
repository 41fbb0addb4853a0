"""The two-parameter maps: what is varied, over which values, and what the truth depends on."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from experiments.compositions import Groups, changed

Design = tuple[float, float, float, float]  # delta_alpha (rad), epsilon, m_bar, mu

INTEGRATORS = (
    "tr_bdf2", "sdirk2", "esdirk3", "bdf2", "newmark", "generalized_alpha", "implicit_euler",
    "implicit_midpoint",
)  # fmt: skip
LAWS = ("logbarrier", "penalty", "hunt_crossley")
# Eight that share an epsilon, so that a mesh's statics are solved once.
DESIGNS: tuple[Design, ...] = (
    (0.1, 0.2, 0.768, 0.3), (0.03, 0.2, 0.4, 0.15), (0.18, 0.2, 1.8, 0.5), (0.06, 0.2, 1.2, 0.6),
    (0.15, 0.2, 0.6, 0.2), (0.01, 0.2, 0.9, 0.4), (0.12, 0.2, 0.35, 0.55), (0.08, 0.2, 1.5, 0.1),
)  # fmt: skip
LONG_ENOUGH_S = 3.0  # for the slowest rotation
MASS_KG = 4.0e-3  # what the map of gravity keeps


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

    def changes(self, across: Any, up: Any) -> dict[str, Any]:
        """What a pair of values changes."""
        return dict(CHANGES[self.name](across, up))

    def groups(self, base: Groups, across: Any, up: Any) -> Groups:
        """The composition at a pair of values."""
        return changed(base, self.changes(across, up))


def _gravity(gravity: float, friction: float) -> Mapping[str, Any]:
    # The paper's baseline is m_bar = 0.768 at 4 g and 10 m/s^2.
    mass_bar = 0.768 * gravity / 10.0 * MASS_KG / 4.0e-3
    return {
        "robot": {"gravity_m_s2": gravity},
        "environment": {"mass_bar": mass_bar or 0.768, "mu": friction},
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
    "mass": lambda m, rate: {
        "environment": {"mass_bar": m},
        "robot": {"rotation_rate_rad_s": rate},
        "sim": {"time_limit_s": LONG_ENOUGH_S},
    },
    "mesh": lambda n, tol: {"discretization": {"elements": n}, "stepping": {"tolerance": tol}},
    "law": lambda k, law: {"contact": {"name": law, "stiffness_N_m": k}},
    "gravity": _gravity,
}


def maps(full: bool) -> list[Map]:
    """All of them; ``full``: on finer grids."""
    steps = (1e-8, 1e-7, 1e-6, 3e-6, 1e-5, 3e-5, 1e-4, 3e-4, 1e-3, 3e-3, 1e-2)
    stiffness = tuple(10.0**k for k in range(2, 9))
    distances = (1e-6, 1e-5, 3e-5, 1e-4, 3e-4, 1e-3, 2e-3)
    thresholds = tuple(10.0**k for k in range(-8, 0))
    friction = (0.0, 0.05, 0.1, 0.3, 0.6, 1.0, 2.0, 5.0)
    epsilon = (1e-3, 3e-3, 1e-2, 3e-2, 0.1, 0.2, 0.3, 0.4)
    lag = (0.0, 1e-4, 1e-3, 1e-2, 0.05, 0.1, 0.19, 0.3, 0.5)
    mass = (0.005, 0.01, 0.03, 0.1, 0.3, 1.0, 3.0, 10.0, 30.0, 100.0)
    rates = (0.1, 1.0, 10.0, 20.0, 100.0, 300.0, 1000.0)
    elements: tuple[int, ...] = (8, 16, 32, 56, 104, 224, 2000)
    tolerances = (1e-10, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2)
    if full:
        stiffness, distances, thresholds, friction, epsilon, lag, mass, rates, steps = (
            _finer(v) for v in (stiffness, distances, thresholds, friction, epsilon, lag, mass,
                                rates, steps)
        )  # fmt: skip
        elements = (8, 12, 16, 24, 32, 44, 56, 76, 104, 152, 224, 448, 1000, 2000)
    return [
        Map("steps", Axis("fixed step (s)", steps), Axis("integrator", INTEGRATORS), False, DESIGNS),
        Map("mesh", Axis("elements", elements), Axis("tolerance (L)", tolerances), False, DESIGNS),
        Map("barrier", Axis("K (N/m)", stiffness), Axis("d_hat (m)", distances), True),
        Map("friction", Axis("eps_v (m/s)", thresholds), Axis("mu", friction), True),
        Map("design", Axis("epsilon", epsilon), Axis("delta_alpha (rad)", lag), True),
        Map("mass", Axis("m_bar", mass), Axis("rotation rate (rad/s)", rates), True),
        Map("law", Axis("K (N/m)", stiffness), Axis("contact law", LAWS), True),
        Map("gravity", Axis("gravity (m/s^2)", (0.0, 1e-3, 0.1, 1.62, 9.81, 100.0)),
            Axis("mu", (0.1, 0.6)), True),
    ]  # fmt: skip


def _finer(values: tuple[float, ...]) -> tuple[float, ...]:
    """With the geometric mean between every two, the arithmetic one next to zero."""
    found = [values[0]]
    for low, high in zip(values, values[1:], strict=False):
        found += [(low * high) ** 0.5 if low > 0.0 else 0.5 * high, high]
    return tuple(float(f"{v:.4g}") for v in found)
