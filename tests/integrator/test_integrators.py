"""Every integrator by the engine's own stages: what it declares, and D3, D5 of physics.json."""

import cmath
import math

import numpy as np
import pytest
from bare_models import loose_nodes
from integration import MASSES, VARIANTS, Integration, Pull, amplification
from references import outputs_of
from scipy.integrate import solve_ivp

from snapjump.contact.logbarrier import LogBarrier
from snapjump.damping.mass_proportional import MassProportional
from snapjump.engine.clock import TIME
from snapjump.engine.load.gravity import Gravity

names = pytest.mark.parametrize("name", sorted(VARIANTS))
# omega h, spectral radius, relative error of the phase
AMPLIFICATION = outputs_of("D3_integrators")
# u(5) from u = 2 at rest; its error with 50 and 200 steps
PENDULUM = outputs_of("D5_pendulum")


@names
def test_what_is_declared_fits_the_scheme(name):
    member = VARIANTS[name]
    scheme = member.scheme()
    assert member.stages == scheme.stage_count() < scheme.slots()
    weights = [scheme.quadrature_weight(k) for k in range(scheme.stage_count() + 1)]
    assert sum(weights) == pytest.approx(1.0, abs=1e-14)
    assert member.order >= 1 and scheme.error_power() >= 2.0


# A mass that oscillates in the barrier under a slope's gravity: smooth, nonlinear, damped.
DAMPED = {"damping": MassProportional.Law(0.3), "load": Gravity(1.0, 10, 1)}
MODEL = loose_nodes(contact=LogBarrier.Law(40.0, 1.0, 0.0), **DAMPED)
DURATION = 0.3
BEGIN = np.array([0.0, 0.75, 0.2, 0.3])


def motion_of_the_mass(t, q):
    _, y, vx, vy = q
    depth = y - 1.0
    push = 40.0 * depth * (2.0 * math.log(y) + depth / y)
    assert y < 1.0  # it stays in the barrier, where all is smooth
    return [vx, vy, 1.0 - 0.3 * vx, push / 0.7 - 10.0 - 0.3 * vy]


@pytest.fixture(scope="module")
def exact():
    """Place and velocity of the mass at the end."""
    solution = solve_ivp(motion_of_the_mass, (0.0, DURATION), BEGIN, rtol=1e-12, atol=1e-13)
    return solution.y[:, -1]


def integrate(name, sizes):
    """State and velocity at the end, and the largest estimate, of steps of these relative sizes."""
    run = Integration(name, MODEL, BEGIN[:2], BEGIN[2:], motion_of_the_mass(0.0, BEGIN)[2:])
    sizes = DURATION * np.asarray(sizes) / np.sum(sizes)
    largest = max(run.step(size) for size in sizes)
    assert run.work.clock[TIME] == pytest.approx(DURATION)
    return np.concatenate([run.work.start, run.work.velocity[0]]), largest


# Steps of one size, and steps that vary smoothly by a factor of three.
PATTERNS = {
    "even": lambda n: np.ones(n),
    "varying": lambda n: 2.0 + np.sin(2.0 * np.pi * np.arange(n) / n),
}


@pytest.mark.parametrize("pattern", PATTERNS)
@names
def test_orders_of_error_and_estimate_are_as_declared(name, pattern, exact):
    member = VARIANTS[name]
    # Far enough in, and not where rounding or Newton's tolerance shows.
    coarse = {1: 160, 2: 40, 3: 24, 4: 12}[member.order]
    results = [integrate(name, PATTERNS[pattern](n)) for n in (coarse, 2 * coarse)]
    errors = [np.abs(state - exact).max() for state, _ in results]
    measured = math.log2(errors[0] / errors[1])
    # Chung and Hulbert's accelerations belong to shifted moments, which varying steps disturb.
    loose = 0.6 if name.startswith("generalized") and pattern == "varying" else 0.25
    assert measured == pytest.approx(member.order, abs=loose)
    if pattern == "even":
        estimates = [estimate for _, estimate in results]
        assert math.log2(estimates[0] / estimates[1]) >= member.scheme().error_power() - 1.3
        assert estimates[1] > 0.0


@names
def test_infinitely_fast_oscillations_are_damped_as_declared(name):
    member = VARIANTS[name]
    roots, _ = amplification(name, 1e6)
    if member.damping_at_infinity is None:
        assert member.scheme().is_explicit()
    else:
        # Roots that come together at infinity are a little apart before it.
        assert np.abs(roots).max() == pytest.approx(member.damping_at_infinity, abs=2e-3)


@names
def test_a_stable_schemes_let_no_oscillation_grow(name):
    for omega_h in (0.03, 0.3, 1.0, 1.9, 2.1, 3.0, 10.0, 100.0):
        roots, stable_step = amplification(name, omega_h)
        radius = np.abs(roots).max()
        if VARIANTS[name].a_stable:
            assert radius <= 1.0 + 1e-6, omega_h
        else:
            # h omega = 2 is where it says that it stops being stable.
            assert stable_step == pytest.approx(2.0 / omega_h)
            assert (radius <= 1.0 + 1e-6) == (omega_h < 2.0)


@pytest.mark.parametrize("name", AMPLIFICATION)
def test_amplification_of_an_oscillation(name):
    for omega_h, radius, phase in AMPLIFICATION[name]:
        roots, _ = amplification(name, omega_h)
        root = roots[np.argmin(np.abs(roots - cmath.exp(1j * omega_h)))]
        assert abs(root) == pytest.approx(radius, abs=1e-8)
        assert abs(cmath.phase(root)) / omega_h - 1.0 == pytest.approx(phase, abs=1e-7)


@pytest.mark.parametrize("name", PENDULUM["errors"])
def test_errors_of_a_pendulum(name):
    model = loose_nodes(contact=Pull(lambda y: MASSES[0] * np.sin(y)))
    for steps, error in zip((50, 200), PENDULUM["errors"][name], strict=True):
        run = Integration(name, model, (0.0, 2.0), (0.0, 0.0), (0.0, -math.sin(2.0)))
        for _ in range(steps):
            run.step(5.0 / steps)
        assert abs(run.work.start[1] - PENDULUM["exact"]) == pytest.approx(error, rel=0.01)


def test_no_contact_is_free_flight():
    """Every scheme moves a free mass exactly."""
    model = loose_nodes(load=Gravity(1.0, 10.0, 0.0))
    expected = (0.7, 2.0 + 2.1 - 0.5 * 10.0 * 0.49)
    for name in sorted(VARIANTS.keys() - {"bdf2"}):  # its first step is implicit Euler's
        run = Integration(name, model, (0.0, 2.0), (1.0, 3.0), (0.0, -10.0))
        for _ in range(7):
            run.step(0.1)
        tolerance = 1e-12 if VARIANTS[name].order > 1 else 0.4
        assert run.work.start == pytest.approx(expected, abs=tolerance), name
        assert run.work.velocity[0] == pytest.approx((1.0, -4.0), abs=1e-12), name
