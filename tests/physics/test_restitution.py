"""The restitution that each contact law promises, and the rigid ground as the limit of all."""

import numpy as np
import pytest
from families import FAMILIES
from physical import thrown
from scipy.optimize import brentq

from snapjump import Robot
from snapjump.composition import Simulation
from snapjump.sim.bounce import Bounce
from snapjump.stepping.fixed import FixedStep

pytestmark = pytest.mark.compiles
CONTACT = FAMILIES["contact"]
MASS_KG = 1e-3
SCALES = Robot().scales
HEIGHT_M = 2e-4  # above the reach of any law


def fall(law, speed_m_s, step_s, duration_s, integrator="tr_bdf2"):
    """A mass that falls without gravity: height (m) and velocity (m/s) at the end, least gap."""
    simulation = Simulation(
        sim=Bounce(mass_kg=MASS_KG, duration_s=duration_s, sample_interval_s=duration_s),
        contact=law,
        integrator=integrator,
        stepping=FixedStep(step_s),
    )
    result = thrown(simulation, getattr(law, "distance_m", 0.0) + HEIGHT_M, speed_m_s)
    assert result.status == "ok"
    return *(result.arrays[n][-1, 0] for n in ("node_y_m", "node_vy_m_s")), result.min_gap_m


def contact_time_s(stiffness_N_m):
    return np.pi * np.sqrt(MASS_KG / stiffness_N_m)


@pytest.mark.parametrize(
    "law", [CONTACT["logbarrier"](), CONTACT["penalty"](), CONTACT["hunt_crossley"](1.0)]
)
def test_conservative_laws_give_back_all(law):
    duration = HEIGHT_M / 1.0 + 4.0 * contact_time_s(law.stiffness_N_m)
    step = contact_time_s(law.stiffness_N_m) / 1000.0
    _, speed, _ = fall(law, 1.0, step, duration)
    assert speed == pytest.approx(1.0, abs=2e-5)


@pytest.mark.parametrize("restitution", [0.3, 0.8])
def test_hunt_crossley_rebounds_as_told(restitution):
    """The restitution holds at the speed it is given for, the exact relation at others."""
    law = CONTACT["hunt_crossley"](restitution=restitution, impact_speed_m_s=2.0)
    number = law.law(SCALES).damping * 2.0 / SCALES.velocity_m_s
    for speed in (2.0, 0.5, 4.0):
        u = number * speed / 2.0
        expected = brentq(
            lambda e, u=u: np.log((1.0 + u) / (1.0 - e * u)) - (1.0 + e) * u,
            1e-9,
            min(1.0, 1.0 / u) - 1e-12,
        )
        _, rebound, _ = fall(law, speed, 1e-6, 6e-3 / speed + 1e-3)
        assert rebound / speed == pytest.approx(expected, abs=2e-4)
        if speed == 2.0:
            assert expected == pytest.approx(restitution, abs=1e-9)


@pytest.mark.parametrize("restitution", [0.0, 0.4, 1.0])
@pytest.mark.parametrize("step_s", [1e-6, 1.7e-5])
def test_signorini_rebounds_as_told_at_any_step(restitution, step_s):
    law = CONTACT["signorini"](restitution)
    _, speed, lowest = fall(law, 1.0, step_s, 1e-3, "implicit_euler")
    assert speed == pytest.approx(restitution, abs=1e-5)
    assert lowest > 0.0


def test_all_laws_go_to_the_rigid_ground():
    """Height at the end against that of an instantaneous reflection, as the laws stiffen."""
    duration, speed = 1e-3, 1.0
    rigid = speed * duration - HEIGHT_M
    stiffer = {
        "penalty": [CONTACT["penalty"](stiffness_N_m=k) for k in (1e5, 1e7, 1e9)],
        "logbarrier": [
            CONTACT["logbarrier"](stiffness_N_m=k, distance_m=d)
            for k, d in ((1e6, 1e-4), (1e8, 1e-5), (1e10, 1e-6))
        ],
    }
    for name, family in stiffer.items():
        delays = []
        for law in family:
            step = min(1e-6, contact_time_s(law.stiffness_N_m) / 40.0)
            height, _, _ = fall(law, speed, step, duration)
            # The barrier reflects from near its lowest point, its reach above the ground.
            delays.append(abs(height - getattr(law, "distance_m", 0.0) - rigid))
        assert delays[1] < 0.2 * delays[0] and delays[2] < 0.2 * delays[1], (name, delays)
        assert delays[2] < 0.02 * HEIGHT_M
    height, _, _ = fall(CONTACT["signorini"](1.0), speed, 1e-6, duration, "implicit_euler")
    assert height == pytest.approx(rigid, abs=2.5e-6 * speed)
