"""The shallow arch in closed form, and its amplitude equation against our arch's eigenvalue."""

import math

import numpy as np
import pytest
from scipy.integrate import quad, solve_ivp

from experiments.benchmarks import amplitude
from experiments.benchmarks.arches import DAMPING, DRAG, EPSILON, INERTIA, MISMATCH
from experiments.benchmarks.shallow import ALIKE, ONE_END, SECOND, fold, lagging, pitchfork
from snapjump.composition import with_tier
from snapjump.statics.arch import StaticArch
from snapjump.statics.branch import Branch
from snapjump.statics.critical import find_snap


def test_critical_angles():
    assert fold(ONE_END).mu == pytest.approx(1.781776, abs=5e-7)
    assert fold(ALIKE).mu == pytest.approx(2.011905, abs=5e-7)
    assert pitchfork().mu == pytest.approx(2.0, abs=1e-6)
    half = 0.5 * math.sqrt(SECOND)
    assert math.tan(half) == pytest.approx(half, rel=1e-4), "the odd shape between flat clamps"
    assert fold(ONE_END).mu < fold(lagging(1.0)).mu < fold(lagging(0.1)).mu < 2.0


def test_the_product_by_the_eigenvalue_of_our_arch():
    """Close below the fold the lowest frequency is omega^4 = 4 c1 c2 (mu_fold - mu)."""
    simulation = with_tier("standard")
    robot, mesh = simulation.robot, simulation.discretization
    root, below = math.sqrt(EPSILON), 1e-4
    arch = StaticArch(robot, mesh, EPSILON)
    critical = find_snap(robot, mesh, EPSILON, MISMATCH * root).alpha_rad
    left = critical - below * root
    branch = Branch(arch, MISMATCH * root)
    right = left - MISMATCH * root
    state = arch.turn(arch.flat(MISMATCH * root), (0.0, -MISMATCH * root), (left, right))
    # Masses are all alike, and the mode is smooth: the tangent's eigenvalue over a node's mass.
    square = branch.point(state, left).eigenvalue * mesh.elements
    assert square**2 / (4.0 * below) == pytest.approx(fold(lagging(MISMATCH)).product, rel=0.05)


def test_the_product_of_an_opening_span():
    """The same at the fold's angle, the pre-compression a little larger than the fold's."""
    simulation = with_tier("standard")
    robot, mesh = simulation.robot, simulation.discretization
    lag, above = MISMATCH * math.sqrt(EPSILON), 1e-4
    left = find_snap(robot, mesh, EPSILON, lag).alpha_rad
    arch = StaticArch(robot, mesh, EPSILON * (1.0 + above))
    state = arch.turn(arch.flat(lag), (0.0, -lag), (left, left - lag))
    square = Branch(arch, lag).point(state, left).eigenvalue * mesh.elements
    assert square**2 / (4.0 * above) == pytest.approx(fold(lagging(MISMATCH)).opening, rel=0.05)


def test_when_the_amplitude_blows_up(monkeypatch):
    whole, _ = quad(lambda a: 2.0 / math.sqrt(2.0 + 2.0 * a**4 / 3.0), 0.0, math.inf)
    assert amplitude.time_prefactor(INERTIA, 1.0) == pytest.approx(whole, rel=1e-10)
    assert amplitude.time_prefactor(INERTIA, 16.0) == pytest.approx(0.5 * whole, rel=1e-10)
    assert amplitude.time_prefactor(DAMPING, DRAG**2) == pytest.approx(0.5 * math.pi)
    assert amplitude.delay_prefactor(DAMPING, DRAG**2) == pytest.approx(2.338107410, abs=1e-9)
    found = amplitude.blow_up()
    amplitude.blow_up.cache_clear()
    monkeypatch.setattr(amplitude, "LONG_AGO", -20.0)
    assert amplitude.blow_up() == pytest.approx(found, abs=1e-5), "wherever one begins"
    amplitude.blow_up.cache_clear()
    assert amplitude.delay_prefactor(INERTIA, 32.0) == pytest.approx(0.5 * found, abs=1e-5)


def test_the_overdamped_delay_by_integration():
    """A' = t + A^2 from far below blows up at the first zero of Airy's function."""
    begun = [math.atan(-math.sqrt(30.0))]

    def slope(t: float, angle: np.ndarray) -> np.ndarray:  # of arctan A
        return np.cos(angle) ** 2 * t + np.sin(angle) ** 2

    def blows_up(t: float, angle: np.ndarray) -> float:
        return angle[0] - 0.5 * math.pi

    found = solve_ivp(slope, (-30.0, 3.0), begun, rtol=1e-10, atol=1e-12, events=blows_up)
    blown = float(found.t_events[0][0])
    assert amplitude.delay_prefactor(DAMPING, DRAG**2) == pytest.approx(blown, abs=1e-4)
