"""Every integrator: what its tableau declares, and D3, D5 of references/physics.json."""

import cmath
import math

import numpy as np
import pytest
from plain_python import plain_work
from scipy.integrate import solve_ivp

from snapjump.clamp.constant_rate import ConstantRate
from snapjump.contact.logbarrier import LogBarrier
from snapjump.damping.mass_proportional import MassProportional
from snapjump.discretization.none import LooseNodes
from snapjump.engine.assemble import Motion
from snapjump.engine.clock import STAGE, STEP, TIME
from snapjump.engine.model import Model
from snapjump.engine.newton import newton_iteration
from snapjump.engine.stage import begin_stage, commit_step, store_stage
from snapjump.families import FAMILIES
from snapjump.frame.none import NoFrame
from snapjump.friction.none import NoFriction
from snapjump.load.inclined import InclinedGravity

MEMBERS = FAMILIES["integrator"]
names = pytest.mark.parametrize("name", sorted(MEMBERS))


def full_matrix(tableau):
    matrix = tableau.matrix.copy()
    matrix[np.arange(1, len(matrix)), np.arange(1, len(matrix))] += tableau.gamma
    return matrix


def amplification(tableau, z):
    """R(z) of u' = lambda u with z = lambda h."""
    matrix = full_matrix(tableau)
    ones = np.ones(len(matrix))
    return 1.0 + z * tableau.weights @ np.linalg.solve(np.eye(len(matrix)) - z * matrix, ones)


@names
def test_tableau_is_consistent_and_stiffly_accurate(name):
    tableau = MEMBERS[name]().tableau()
    matrix = full_matrix(tableau)
    np.testing.assert_allclose(matrix.sum(axis=1), tableau.nodes, atol=1e-15)
    np.testing.assert_allclose(matrix[-1], tableau.weights, atol=1e-15)
    assert tableau.nodes[0] == 0.0
    assert tableau.nodes[-1] == pytest.approx(1.0, abs=1e-15)
    assert not matrix[0].any()
    assert np.allclose(np.diag(matrix)[1:], tableau.gamma)
    assert not np.triu(matrix, 1).any()


@names
def test_order_conditions_hold_up_to_the_declared_order_and_not_beyond(name):
    member = MEMBERS[name]()
    tableau = member.tableau()
    b, c, a = tableau.weights, tableau.nodes, full_matrix(tableau)
    conditions = {
        1: [b.sum() - 1.0],
        2: [b @ c - 1.0 / 2.0],
        3: [b @ c**2 - 1.0 / 3.0, b @ a @ c - 1.0 / 6.0],
        4: [
            b @ c**3 - 1 / 4,
            b @ (c * (a @ c)) - 1 / 8,
            b @ a @ c**2 - 1 / 12,
            b @ a @ a @ c - 1 / 24,
        ],
    }
    for order in range(1, member.order + 1):
        assert np.abs(conditions[order]).max() < 1e-14
    assert np.abs(conditions[member.order + 1]).max() > 1e-3


@names
def test_comparison_method_is_consistent_and_different(name):
    tableau = MEMBERS[name]().tableau()
    assert sum(tableau.error) == pytest.approx(0.0, abs=1e-14)
    assert np.abs(tableau.error).max() > 1e-2
    assert tableau.error_order == MEMBERS[name].order + 1
    # It integrates polynomials up to its number of stages exactly.
    comparison = tableau.weights - tableau.error
    for power in range(len(tableau.nodes)):
        assert comparison @ tableau.nodes**power == pytest.approx(1.0 / (power + 1.0))


@names
def test_damping_of_infinitely_fast_modes_is_as_declared(name):
    member = MEMBERS[name]()
    for z in (-1e8, 1e8j):
        assert abs(amplification(member.tableau(), z)) == pytest.approx(
            member.damping_at_infinity, abs=1e-6
        )
    # A-stable: no oscillation and no decay grows.
    for size in np.logspace(-2, 4, 100):
        for direction in (1j, -1.0, cmath.exp(0.6j * math.pi)):
            assert abs(amplification(member.tableau(), size * direction)) <= 1.0 + 1e-12


# D3_linear_amplification: omega h, spectral radius and relative error of the phase
AMPLIFICATION = {
    "implicit_euler": [
        (0.01, 0.9999500037, -3.333133348e-05),
        (0.0511, 0.9986969464, -0.0008690421881),
        (0.2, 0.9805806757, -0.01302220075),
    ],
    "tr_bdf2": [
        (0.01, 1.0, -4.043978442e-06),
        (0.0511, 0.9999999749, -0.0001055751311),
        (0.2, 0.9999941527, -0.001612345605),
    ],
    "sdirk2": [
        (0.01, 1.0, -4.043978444e-06),
        (0.0511, 0.9999999749, -0.0001055751311),
        (0.2, 0.9999941527, -0.001612345605),
    ],
}


@pytest.mark.parametrize("name", sorted(AMPLIFICATION))
def test_amplification_of_an_oscillation(name):
    tableau = MEMBERS[name]().tableau()
    for step, radius, phase in AMPLIFICATION[name]:
        factor = amplification(tableau, 1j * step)
        assert abs(factor) == pytest.approx(radius, abs=1e-9)
        assert cmath.phase(factor) / step - 1.0 == pytest.approx(phase, abs=1e-9)


def pendulum(tableau, steps):
    """u'' = -sin u from u = 2 at rest to t = 5, by the tableau alone."""
    h = 5.0 / steps
    stages = len(tableau.nodes)
    u, v = 2.0, 0.0
    for _ in range(steps):
        velocity, acceleration = np.zeros(stages), np.zeros(stages)
        velocity[0], acceleration[0] = v, -math.sin(u)
        for k in range(1, stages):
            u_known = u + h * tableau.matrix[k] @ velocity
            v_known = v + h * tableau.matrix[k] @ acceleration
            share = tableau.gamma * h
            w = u_known + share * v_known
            for _ in range(20):
                excess = w - u_known - share * v_known + share**2 * math.sin(w)
                w -= excess / (1.0 + share**2 * math.cos(w))
            acceleration[k] = -math.sin(w)
            velocity[k] = v_known + share * acceleration[k]
        u = u + h * tableau.weights @ velocity
        v = v + h * tableau.weights @ acceleration
    return u, v


# D5_pendulum and D5b_pendulum_errors: u and v at the end, error of u in 50, 200, 800 steps
PENDULUM = (-1.684124437, 0.7785385729)
PENDULUM_ERRORS = {
    "implicit_euler": (0.5293387137, 0.1444076033, 0.0367190603),
    "tr_bdf2": (0.000534656908, 3.500744427e-05, 2.21273057e-06),
    "sdirk2": (0.0002464024371, 1.616140573e-05, 1.022008142e-06),
}


@pytest.mark.parametrize("name", sorted(PENDULUM_ERRORS))
def test_errors_of_a_pendulum(name):
    tableau = MEMBERS[name]().tableau()
    for steps, error in zip((50, 200, 800), PENDULUM_ERRORS[name], strict=True):
        u, _ = pendulum(tableau, steps)
        assert abs(u - PENDULUM[0]) == pytest.approx(error, rel=0.01)


# A mass that oscillates in the barrier under a slope's gravity: smooth, nonlinear, damped.
MODEL = Model(
    LooseNodes(),
    NoFrame(),
    ConstantRate(0.0, 1.0, 1.0, 0.0),
    LogBarrier(40.0, 1.0, 1.0, 1.0),
    NoFriction(),
    MassProportional(0.3),
    InclinedGravity(10.0, 1.0),
)
MASSES = np.array([0.7])
DURATION = 0.3
BEGIN = np.array([0.0, 0.75, 0.2, 0.3])


def motion(t, q):
    _, y, vx, vy = q
    depth = y - 1.0
    push = 40.0 * depth * (2.0 * math.log(y) + depth / y)
    assert y < 1.0  # it stays in the barrier, where all is smooth
    return [vx, vy, 1.0 - 0.3 * vx, push / 0.7 - 10.0 - 0.3 * vy]


@pytest.fixture(scope="module")
def exact():
    return solve_ivp(motion, (0.0, DURATION), BEGIN, rtol=1e-12, atol=1e-13).y[:, -1]


def march_in_plain_python(tableau, steps):
    """Positions, velocities and largest error estimate, by the engine's own stages."""
    work = plain_work(1, 0, stages=len(tableau.nodes))
    clock = work.clock
    work.start[:] = work.state[:] = BEGIN[:2]
    work.velocity[0] = BEGIN[2:]
    work.acceleration[0] = motion(0.0, BEGIN)[2:]
    clock[STEP], clock[STAGE] = DURATION / steps, 1.0
    largest = 0.0
    for _ in range(steps):
        for stage in range(1, len(tableau.nodes)):
            clock[STAGE] = 1.0 * stage
            begin_stage(MODEL, tableau, MASSES, work, True)
            for _ in range(30):
                time = clock[TIME] + tableau.nodes[stage] * clock[STEP]
                now = Motion(time, 1.0 / (tableau.gamma * clock[STEP]), 0.0)
                step = newton_iteration(MODEL, now, MASSES, work, True, 1e-13, 30.0, 4.0)
                if step.converged:
                    break
            assert step.converged
            error = store_stage(tableau, work, True)
        largest = max(largest, error)
        commit_step(tableau, work, True)
    assert clock[TIME] == pytest.approx(DURATION)
    return np.concatenate([work.start, work.velocity[0]]), largest


@names
def test_measured_order_of_the_engine_s_stages(name, exact):
    member = MEMBERS[name]()
    counts = (80, 160) if member.order == 1 else (20, 40)
    results = [march_in_plain_python(member.tableau(), n) for n in counts]
    errors = [np.abs(state - exact).max() for state, _ in results]
    assert math.log2(errors[0] / errors[1]) == pytest.approx(member.order, abs=0.15)
    # The estimate of a single step shrinks one order faster than the error of all of them.
    estimates = [estimate for _, estimate in results]
    order = math.log2(estimates[0] / estimates[1])
    assert order == pytest.approx(member.tableau().error_order, abs=0.3)
