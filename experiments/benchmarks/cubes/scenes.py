"""A mass that strikes the ground, and one that slides on it, with the parameters of a cube."""

from collections.abc import Mapping
from typing import Any

from snapjump.contact.hunt_crossley import damping_number
from snapjump.run.studies.base import Row
from snapjump.simulation import simulate

from ...compositions import changed, composed


def scene_rows(inputs: Mapping[str, Any]) -> list[Row]:
    """One row with all outputs of the scene."""
    return [dict(simulate(composed(inputs["groups"])).summary)]


def restitution_of(dissipation_s_m: float, speed_m_s: float) -> float:
    """For which (1 + e) u = log((1 + u) / (1 - e u)), u dissipation times speed."""
    from scipy.optimize import brentq

    wanted = dissipation_s_m * speed_m_s
    return float(brentq(lambda e: damping_number(e) - wanted, 1e-3, 1.0 - 1e-9, xtol=1e-12))


def sliding_groups(groups: Mapping[str, Any], mass_kg: float, speed_m_s: float, mu: float) -> Any:
    """A mass that slides until it stops, and half as long again."""
    duration_s = 1.5 * speed_m_s / (mu * groups["robot"]["gravity_m_s2"])
    scene = {"name": "slide", "mass_kg": mass_kg, "speed_m_s": speed_m_s, "duration_s": duration_s,
             "sample_interval_s": duration_s / 500.0}  # fmt: skip
    return changed(groups, {"sim": scene, "environment": {"mu": mu}})
