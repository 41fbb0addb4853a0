"""Discrete elastic rods against strains written down independently and differentiated exactly."""

from typing import Any

import numpy as np
import pytest
from plain_python import assembled, complex_step, dense, residual_of

from snapjump.clamp.constant_rate import ConstantRate
from snapjump.contact.none import NoContact
from snapjump.damping.kelvin_voigt import KelvinVoigt
from snapjump.damping.none import NoDamping
from snapjump.discretization.base import EndTangents
from snapjump.discretization.der import DiscreteElasticRod
from snapjump.engine.assemble import Motion
from snapjump.engine.model import Model
from snapjump.frame.fixed import FixedFrame
from snapjump.frame.parts.cantilever import CantileverFrame
from snapjump.friction.none import NoFriction
from snapjump.load.none import NoLoad
from snapjump.load.tip import TipLoad
from snapjump.parameters.robot import Robot

ELEMENTS = 9
ANGLES = ConstantRate(0.3, 1.5, 0.7, 0.1)
RELAXATION = 2e-3
ELASTIC = NoDamping.Law()
STILL = Motion(0.0, 0.0, 0.0, 0.0)
MOVING = Motion(0.4, 30.0, 30.0, 0.0)


def make_rod(clamp: str) -> DiscreteElasticRod.Beam:
    return DiscreteElasticRod(ELEMENTS, clamp).beam(Robot())


def bent_state(rod: DiscreteElasticRod.Beam, seed: int) -> Any:
    """A random arch, 0.1 % stretched, with kinks."""
    rng = np.random.default_rng(seed)
    nodes = ELEMENTS + 1 if rod.clamp_offset == 0.0 else ELEMENTS - 1
    turns = np.linspace(0.9, -0.9, nodes - 1) + rng.uniform(-0.2, 0.2, nodes - 1)
    lengths = rod.element_length * (1.0 + rng.uniform(-1e-3, 1e-3, nodes - 1))
    state = np.zeros(2 * nodes)
    state[2::2] = np.cumsum(lengths * np.cos(turns))
    state[3::2] = np.cumsum(lengths * np.sin(turns))
    return state


def strains(rod: DiscreteElasticRod.Beam, q: Any, left: Any, right: Any, held: float = 1.0) -> Any:
    """Strains whose squares sum up to twice the energy, by complex-safe geometry."""
    ex, ey = np.diff(q[0::2]), np.diff(q[1::2])
    lengths = np.sqrt(ex * ex + ey * ey)
    cx = np.concatenate([[np.cos(left)], ex / lengths, [np.cos(right)]])
    cy = np.concatenate([[np.sin(left)], ey / lengths, [np.sin(right)]])
    sine = cx[:-1] * cy[1:] - cy[:-1] * cx[1:]
    cosine = cx[:-1] * cx[1:] + cy[:-1] * cy[1:]
    bending = 2.0 * sine / (1.0 + cosine)
    hinges = np.full(len(bending), rod.element_length)
    hinges[[0, -1]] = rod.clamp_hinge_length
    bending = bending / np.sqrt(hinges)
    bending[-1] = held * bending[-1]
    stretch = np.sqrt(rod.stretching_stiffness / rod.element_length)
    return np.concatenate([stretch * (lengths - rod.element_length), bending])


def clamp_directions(time: float) -> tuple[float, float]:
    turned = ANGLES.start + ANGLES.rate * time
    return -turned, turned - ANGLES.delta_alpha


def fixed_model(rod: DiscreteElasticRod.Beam, damping: Any = ELASTIC) -> Model:
    return Model(
        rod, FixedFrame.Body(0.4, 0.0), ANGLES, NoContact.Law(), NoFriction.Law(), damping, NoLoad()
    )


def massless(state: Any) -> Any:
    return np.zeros(len(state) // 2)


def tangents_of(left: float, right: float, left_rate: float, right_rate: float) -> EndTangents:
    return EndTangents(
        np.cos(left), np.sin(left), left_rate, np.cos(right), np.sin(right), right_rate, 0.0, 0.0
    )


clamps = pytest.mark.parametrize("clamp", ["half_element", "two_nodes"])
seeds = pytest.mark.parametrize("seed", range(3))


@clamps
def test_energy_is_that_of_turning_angles_and_lengths(clamp):
    rod = make_rod(clamp)
    q = bent_state(rod, 0)
    left, right = clamp_directions(0.0)
    ex, ey = np.diff(q[0::2]), np.diff(q[1::2])
    directions = np.concatenate([[left], np.arctan2(ey, ex), [right]])
    hinges = np.full(len(directions) - 1, rod.element_length)
    hinges[[0, -1]] = rod.clamp_hinge_length
    curvature = 2.0 * np.tan(0.5 * np.diff(directions)) / hinges
    xi = np.hypot(ex, ey) / rod.element_length - 1.0
    expected = 0.5 * np.sum(curvature**2 * hinges)
    expected += 0.5 * rod.stretching_stiffness * np.sum(xi**2) * rod.element_length
    energy = rod.internal_energy(q, tangents_of(left, right, 0.0, 0.0))
    assert energy == pytest.approx(expected, rel=1e-12)


@clamps
@seeds
def test_residual_is_the_gradient_of_the_energy(clamp, seed):
    rod = make_rod(clamp)
    q = bent_state(rod, seed)
    left, right = clamp_directions(0.0)
    tangents = tangents_of(left, right, 0.0, 0.0)
    gradient = complex_step(lambda y: rod.internal_energy(y, tangents), q)
    by_hand = complex_step(lambda y: 0.5 * np.sum(strains(rod, y, left, right) ** 2), q)
    _, work = assembled(fixed_model(rod), STILL, massless(q), q)
    scale = np.abs(gradient).max()
    assert np.abs(gradient - by_hand).max() <= 1e-10 * scale
    free = slice(2, -2)
    assert np.abs(residual_of(work, 0)[free] - gradient[free]).max() <= 1e-8 * scale


@clamps
@seeds
@pytest.mark.parametrize("damping", [NoDamping.Law(), KelvinVoigt.Law(RELAXATION)])
def test_band_is_the_derivative_of_the_residual(clamp, seed, damping):
    """Up to a term that damping would make unsymmetric: eta J^T dJ/dt, left out of the band."""
    rod = make_rod(clamp)
    q = bent_state(rod, seed)
    origin = q + np.random.default_rng(seed).normal(0.0, 1e-4, len(q))
    model = fixed_model(rod, damping)

    def residual(y):
        return residual_of(assembled(model, MOVING, massless(q), y, origin=origin)[1], 0)

    def jacobian(time):
        left, right = clamp_directions(MOVING.time + time)
        position = q + time * (q - origin) * MOVING.rate_factor
        return complex_step(lambda y: strains(rod, y, left, right), position)

    _, work = assembled(model, MOVING, massless(q), q, origin=origin)
    matrix, expected = dense(work, 0), complex_step(residual, q)
    change = (jacobian(1e-5) - jacobian(-1e-5)) / 2e-5
    if isinstance(damping, KelvinVoigt.Law):
        expected = expected - RELAXATION * jacobian(0.0).T @ change
    free = slice(2, -2)
    error = np.abs(matrix[free, free] - expected[free, free]).max()
    assert error <= 1e-8 * np.abs(expected).max()
    # Slave nodes are left as identities without a load.
    assert np.array_equal(matrix[:2, :], np.eye(2, len(q)))
    assert np.array_equal(matrix[-2:, :], np.eye(len(q))[-2:])
    assert not residual_of(work, 0)[[0, 1, -2, -1]].any()


@clamps
@seeds
def test_kelvin_voigt_is_the_gradient_of_its_dissipation(clamp, seed):
    """Viscous forces are eta J^T s' with the strains' Jacobian J and rates s'."""
    rod = make_rod(clamp)
    q = bent_state(rod, seed)
    origin = q + np.random.default_rng(seed).normal(0.0, 1e-4, len(q))
    velocity = (q - origin) * MOVING.rate_factor
    left, right = clamp_directions(MOVING.time)
    everything = np.concatenate([q, [left, right]])
    jacobian = complex_step(lambda z: strains(rod, z[:-2], z[-2], z[-1]), everything)
    rates = jacobian @ np.concatenate([velocity, [-ANGLES.rate, ANGLES.rate]])
    expected = RELAXATION * jacobian[:, :-2].T @ rates
    masses = massless(q)
    _, damped = assembled(
        fixed_model(rod, KelvinVoigt.Law(RELAXATION)), MOVING, masses, q, origin=origin
    )
    _, elastic = assembled(fixed_model(rod), MOVING, masses, q, origin=origin)
    viscous = residual_of(damped, 0) - residual_of(elastic, 0)
    free = slice(2, -2)
    assert np.abs(viscous[free] - expected[free]).max() <= 1e-8 * np.abs(expected).max()

    tangents = tangents_of(left, right, -ANGLES.rate, ANGLES.rate)
    powers = rod.chain_powers(KelvinVoigt.Law(RELAXATION), q, velocity, tangents)
    assert powers.dissipation == pytest.approx(RELAXATION * rates @ rates, rel=1e-9)
    assert powers.dissipation > 0.0
    assert rod.chain_powers(NoDamping.Law(), q, velocity, tangents).dissipation == 0.0


@clamps
def test_end_forces_and_moments_are_those_of_the_energy(clamp):
    rod = make_rod(clamp)
    q = bent_state(rod, 4)
    left, right = clamp_directions(0.0)
    powers = rod.chain_powers(NoDamping.Law(), q, 0.0 * q, tangents_of(left, right, 0.0, 0.0))
    everything = np.concatenate([q, [left, right]])
    gradient = complex_step(
        lambda z: 0.5 * np.sum(strains(rod, z[:-2], z[-2], z[-1]) ** 2), everything
    )
    # A clamp's direction is where the left hinge begins and where the right one ends.
    expected = [-gradient[-2], gradient[-1], *gradient[:2], *gradient[-4:-2]]
    actual = powers[1:]
    np.testing.assert_allclose(actual, expected, rtol=1e-8, atol=1e-8 * np.abs(gradient).max())


@clamps
def test_rigid_motion_costs_nothing(clamp):
    rod = make_rod(clamp)
    q = bent_state(rod, 1)
    turn = 3.0
    velocity = np.empty_like(q)
    velocity[0::2] = 5.0 - turn * q[1::2]
    velocity[1::2] = -2.0 + turn * q[0::2]
    still = rod.chain_powers(NoDamping.Law(), q, velocity, tangents_of(-0.3, 0.2, turn, turn))
    moving = rod.chain_powers(KelvinVoigt.Law(1.0), q, velocity, tangents_of(-0.3, 0.2, turn, turn))
    assert abs(moving.dissipation) < 1e-10
    np.testing.assert_allclose(moving[1:], still[1:], rtol=1e-7)
    # One clamp that does not turn along is enough to dissipate.
    held = rod.chain_powers(KelvinVoigt.Law(1.0), q, velocity, tangents_of(-0.3, 0.2, 0.0, turn))
    assert held.dissipation > 1.0


@seeds
def test_free_end_feels_its_force_and_moment_only(seed):
    rod = make_rod("half_element")
    q = bent_state(rod, seed)
    load = TipLoad(3.0, -4.0, 2.5)
    model = Model(
        rod, CantileverFrame(), ANGLES, NoContact.Law(), NoFriction.Law(), NoDamping.Law(), load
    )
    left, _ = clamp_directions(0.0)

    def potential(y):
        end = np.arctan((y[-1] - y[-3]) / (y[-2] - y[-4]))
        work = load.force_x * y[-2] + load.force_y * y[-1] + load.moment * end
        return 0.5 * np.sum(strains(rod, y, left, 0.0, held=0.0) ** 2) - work

    gradient = complex_step(potential, q)
    _, work = assembled(model, STILL, massless(q), q)
    scale = np.abs(gradient).max()
    assert np.abs(residual_of(work, 0)[2:] - gradient[2:]).max() <= 1e-8 * scale
    expected = complex_step(lambda y: residual_of(assembled(model, STILL, massless(q), y)[1], 0), q)
    matrix = dense(work, 0)
    assert np.abs(matrix - expected)[2:, 2:].max() <= 1e-8 * np.abs(expected).max()


def test_two_fixed_nodes_leave_out_the_clamped_elements():
    half, two = make_rod("half_element"), make_rod("two_nodes")
    assert half.element_length == two.element_length == 1.0 / ELEMENTS
    assert (half.clamp_offset, half.clamp_hinge_length) == (0.0, 0.5 / ELEMENTS)
    assert (two.clamp_offset, two.clamp_hinge_length) == (1.0 / ELEMENTS, 1.0 / ELEMENTS)
