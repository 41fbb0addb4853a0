"""One mass on the ground at every tier, against closed forms, over many orders of magnitude."""

import math
from itertools import product

import numpy as np
import pytest
from families import FAMILIES
from scipy.optimize import brentq

from snapjump.composition import Simulation, with_tier
from snapjump.robot.environment import Environment
from snapjump.robot.robot import Robot
from snapjump.scenes.mass_units import depth_of, stick_speed, units_of_impact, units_of_sliding
from snapjump.simulation import simulate
from snapjump.tiers import TIERS

PROMISES = {name: 0.01 * tier.promise_percent for name, tier in TIERS.items() if name != "paper"}
CONTACT = {name: law for name, law in FAMILIES["contact"].items() if law.pushes}
FRICTION = FAMILIES["friction"]
SCALES = Robot().scales
G = 10.0
pytestmark = pytest.mark.compiles
tiers = pytest.mark.parametrize("tier", PROMISES)
impulsive = "velocities_at_step_ends"


def bounce(law, tier="standard", **numbers):
    """A bounce, by the integrator that its law asks for."""
    asked = [need.capability for need in law.needs]
    return Simulation(
        sim=FAMILIES["sim"]["bounce"](**{"sample_interval_s": 1.0, **numbers}),
        contact=law,
        integrator="implicit_euler" if impulsive in asked else None,
        accuracy=tier,
    )


def restitution(law, speed_m_s):
    """In closed form: of a law that stores what it takes, 1."""
    if not hasattr(law, "impact_speed_m_s"):
        return getattr(law, "restitution", 1.0)
    u = law.law(SCALES).damping * speed_m_s / SCALES.velocity_m_s
    if u < 1e-4:
        return 1.0 - 2.0 * u / 3.0
    # (1 + e) u = log((1 + u) / (1 - e u)), solved for log(1 - e u).
    known = math.log1p(u) - u
    return -math.expm1(brentq(lambda r: r + 1.0 - math.exp(r) - known, known - 2.0, -1e-12)) / u


@pytest.mark.parametrize("name", CONTACT)
def test_restitution_is_that_of_the_law(name):
    law = CONTACT[name]()
    for tier, mass, speed in product(PROMISES, (1e-8, 4e-3, 1.0, 10.0), (1e-4, 1.0, 100.0)):
        of = {"mass_kg": mass, "speed_m_s": speed, "duration_s": 10.0}
        result = simulate(bounce(law, tier, **of))
        if result.status == "step_underflow":
            # The barrier's gap would be less than the square root of the smallest number.
            assert 0.5 * mass * speed**2 > 200.0 * law.stiffness_N_m * law.distance_m**2
            assert math.isnan(result.restitution) and math.isnan(result.rebound_speed_m_s)
            continue
        assert result.status == "ok", (of, result.message)
        exact = restitution(law, speed)
        assert result.restitution == pytest.approx(exact, rel=PROMISES[tier]), (tier, of)


def test_a_duration_that_ends_in_the_contact_has_no_restitution():
    """Of penalty, a quarter of an oscillation at 0.76 mg and 1e5 N/m takes 4.3 us."""
    found = {
        duration: simulate(bounce(CONTACT["penalty"](), duration_s=duration))
        for duration in (4e-6, 8e-6, 9e-6)
    }
    assert [r.status for r in found.values()] == ["in_contact", "in_contact", "ok"]
    assert all(math.isnan(found[d].restitution) for d in (4e-6, 8e-6))
    assert math.isnan(found[8e-6].rebound_speed_m_s)
    assert "still in contact" in found[4e-6].message and not found[4e-6].succeeded
    assert found[9e-6].restitution == pytest.approx(1.0, abs=1e-3)


def slide(tier="standard", friction="implicit", mu=0.3, slope=0.0, eps=1e-4, **numbers):
    return simulate(
        Simulation(
            sim=FAMILIES["sim"]["slide"](**{"sample_interval_s": 1e-3, **numbers}),
            environment=Environment(mu=mu, slope_rad=slope),
            friction=FRICTION[friction](velocity_threshold_m_s=eps),
            accuracy=tier,
        )
    )


def flips(result):
    """How often friction above a hundredth of its largest changes its sign."""
    force = result.arrays["node_friction_N"][:, 0]
    signs = np.sign(force[np.abs(force) > 1e-2 * np.abs(force).max()])
    return int(np.count_nonzero(np.diff(signs)))


def ringing(tier):
    """Steps in which the tier's integrator brings the fastest oscillation down to a hundredth."""
    left = with_tier(tier).integrator.damping_at_infinity
    return math.log(1e-2) / math.log(left) if left > 0.0 else 0.0


def stopping_distance_m(mu, speed, eps):
    """Of smoothed Coulomb friction: v^2 / (2 mu g) down to eps, from there what is left."""
    outside = max(speed**2 - eps**2, 0.0) / (2.0 * mu * G)
    return outside + eps**2 / (mu * G) * math.log(2.0 / (2.0 - min(speed / eps, 1.0)))


def test_what_is_stiff_to_stop_stops():
    result = slide("draft", mu=3.0, duration_s=0.2, sample_interval_s=2e-6)
    assert result.distance_m == pytest.approx(1.0 / 6000.0, rel=PROMISES["draft"])
    assert abs(result.final_speed_m_s) < 1e-9 and flips(result) <= 2


@tiers
def test_slides_stop_where_they_should(tier):
    for mu, speed, mass, eps in product(
        (0.01, 0.3, 10.0), (1e-3, 0.1, 10.0), (1e-8, 10.0), (1e-5, 1e-4, 1e-2)
    ):
        duration = (3.0 * speed + 20.0 * eps) / (mu * G)
        times = {"duration_s": duration, "sample_interval_s": duration / 1e5}
        result = slide(tier, mu=mu, eps=eps, speed_m_s=speed, mass_kg=mass, **times)
        assert result.status == "ok" and flips(result) <= 2 + ringing(tier)
        exact = stopping_distance_m(mu, speed, eps)
        assert result.distance_m == pytest.approx(exact, rel=PROMISES[tier])
        assert abs(result.final_speed_m_s) < 1e-6 * eps


def test_lagged_friction_stops_too():
    """Its steps are held to what its stick zone allows; where those are too many, it says so."""
    for mu, speed in product((0.3, 3.0), (1e-3, 0.1)):
        result = slide("draft", "lagged", mu, speed_m_s=speed, duration_s=4.0 * speed / (mu * G))
        exact = stopping_distance_m(mu, speed, 1e-4)
        assert result.distance_m == pytest.approx(exact, rel=1e-3)
        assert abs(result.final_speed_m_s) < 1e-8 and flips(result) == 0
    hopeless = slide("draft", "lagged", 3.0, eps=1e-5, speed_m_s=10.0, duration_s=1.0)
    assert hopeless.status == "iteration_limit"


@tiers
def test_downhill_and_back(tier):
    """Up a slope that does not hold it, to a halt and down again; and from rest."""
    mu, slope, speed, duration = 0.1, 0.5, 0.1, 0.1
    up, down = (G * (math.sin(slope) + sign * mu * math.cos(slope)) for sign in (1.0, -1.0))
    halt = speed / up
    exact = 0.5 * speed * halt - 0.5 * down * (duration - halt) ** 2
    result = slide(tier, mu=mu, slope=slope, speed_m_s=speed, duration_s=duration)
    assert result.distance_m == pytest.approx(exact, rel=PROMISES[tier])
    result = slide(tier, mu=mu, slope=slope, speed_m_s=0.0, duration_s=duration)
    assert result.distance_m == pytest.approx(-0.5 * down * duration**2, rel=PROMISES[tier] + 1e-3)


def test_depths_are_those_of_the_energy():
    spring, barrier = CONTACT["penalty"]().law(SCALES), CONTACT["logbarrier"]().law(SCALES)
    assert depth_of(spring, 0.5 * spring.stiffness * 1e-6, 1.0) == pytest.approx(1e-3, rel=1e-9)
    assert depth_of(spring, 1e9, 1e-3) == 1e-3
    stored = float(barrier.energy(0.3 * barrier.distance))
    assert depth_of(barrier, stored, 1.0) == pytest.approx(0.7 * barrier.distance, rel=1e-9)
    assert depth_of(barrier, 1e3 * stored, 1.0) == pytest.approx(barrier.distance, rel=1e-6)
    assert depth_of(CONTACT["signorini"]().law(SCALES), 1.0, 0.4) == 0.4


def test_units_are_of_the_motion():
    units = units_of_impact(bounce(CONTACT["penalty"](1e4), mass_kg=1e-4, duration_s=1.0))
    assert units.time_s == pytest.approx(1e-4) and units.length_m == pytest.approx(1e-3)
    resting = bounce(CONTACT["penalty"](), speed_m_s=0.0)
    assert units_of_impact(resting) == resting.robot.scales
    law = FRICTION["implicit"](velocity_threshold_m_s=0.1).law(SCALES, 0.3)
    assert stick_speed(law) == pytest.approx(law.velocity_threshold * (1.0 - math.sqrt(0.5)))
    assert stick_speed(FRICTION["none"]().law(SCALES, 0.3)) == 0.0
    sliding = Simulation(sim=FAMILIES["sim"]["slide"](speed_m_s=0.3))
    assert units_of_sliding(sliding).time_s == pytest.approx(0.05)  # of the duration, 0.1 to stop
    still = Simulation(sim=FAMILIES["sim"]["slide"](speed_m_s=0.0), friction="none")
    assert units_of_sliding(still) == still.robot.scales


@pytest.mark.parametrize("rate", [0.1, 100.0, 1e4])
def test_drag_slows_a_mass_by_the_exponential(rate):
    result = simulate(
        Simulation(
            sim=FAMILIES["sim"]["slide"](mass_kg=1.0, speed_m_s=2.0, duration_s=3.0 / rate,
                                         sample_interval_s=3.0 / rate),
            friction="none",
            damping=FAMILIES["damping"]["mass_proportional"](rate_1_s=rate),
        )
    )  # fmt: skip
    left = math.exp(-3.0)
    assert result.final_speed_m_s == pytest.approx(2.0 * left, rel=5e-3)
    assert result.distance_m == pytest.approx(2.0 / rate * (1.0 - left), rel=5e-3)
