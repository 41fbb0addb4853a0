"""Exponents of made-up data, heights against drag, restitutions, and a clamp that turns alone."""

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from experiments.benchmarks.cascade.jumps import AIR_KG_M3, COEFFICIENT, between, mass_bar, risen
from experiments.benchmarks.cubes.scenes import restitution_of
from experiments.benchmarks.scaling import scaling_of
from experiments.benchmarks.symmetries.angles import at_zero
from snapjump.composition import with_tier
from snapjump.contact.hunt_crossley import damping_number


def test_exponent_and_prefactor_of_a_law():
    rates = [0.1, 0.03, 0.01, 0.003, 0.001]
    rows = [{"rate": r, "delay": 2.0 * r**0.8} for r in rates]
    one = scaling_of(rows, "rate", "delay", 0.8, 1.6)
    assert one.fitted == pytest.approx(0.8) and one.off < 1e-12
    assert one.prefactor_percent == pytest.approx(25.0)
    assert one.ratios == pytest.approx([1.25] * 5)


def test_the_last_decade_counts():
    rows = [{"rate": 10.0**-k, "delay": 10.0 ** -(0.5 * k if k < 3 else k - 1.5)} for k in range(6)]
    assert scaling_of(rows, "rate", "delay", 1.0, 1.0).fitted == pytest.approx(1.0)


def test_a_march_that_failed_has_no_exponent():
    rows = [{"rate": 10.0**-k, "delay": None if k == 3 else 10.0**-k} for k in range(5)]
    one = scaling_of(rows, "rate", "delay", 1.0, 1.0)
    assert math.isnan(one.fitted) and math.isnan(one.off)


def test_a_polynomial_to_zero():
    places = [0.01, 0.02, 0.04, 0.08]
    assert at_zero(places, [3.0 - x + 5.0 * x**3 for x in places]) == pytest.approx(3.0)


def test_how_high_a_body_flies_against_drag():
    speed, gravity, mass, area = 4.0, 9.81, 1.6e-3, 1.6e-4
    k = 0.5 * AIR_KG_M3 * COEFFICIENT * area / mass

    def top(t: float, y: np.ndarray) -> float:
        return y[1]

    top.terminal = True
    found = solve_ivp(
        lambda t, y: [y[1], -gravity - k * y[1] * abs(y[1])], (0.0, 2.0), [0.0, speed], events=top,
        rtol=1e-10, atol=1e-12,
    )  # fmt: skip
    assert risen(speed, gravity, mass, area) == pytest.approx(float(found.y[0, -1]), rel=1e-6)
    assert risen(speed, gravity, mass, 1e-12) == pytest.approx(speed**2 / (2 * gravity), rel=1e-6)


def test_a_mass_and_what_is_not_known():
    simulation = with_tier("standard")
    own = mass_bar(simulation, simulation.environment.mass_kg(simulation.robot))
    assert own == pytest.approx(simulation.environment.mass_bar)
    assert between("design.epsilon", 0.5) == pytest.approx(0.2)
    assert between("damping.relaxation_time_s", 0.5) == pytest.approx(1e-6)


@pytest.mark.parametrize("restitution", [0.125, 0.7])
def test_a_restitution_by_its_dissipation(restitution):
    dissipation = damping_number(restitution) / 2.0
    assert restitution_of(dissipation, 2.0) == pytest.approx(restitution, abs=1e-9)
