"""Chains of elements whose nodes turn, against strains written down independently: Crisfield's
rotations of the ends against the chord, and Simo and Reissner's strains at the middle."""

from typing import Any

import numpy as np
import pytest
from plain_python import assembled, complex_step, dense, residual_of

from snapjump.clamp.constant_rate import ConstantRate
from snapjump.contact.none import NoContact
from snapjump.damping.kelvin_voigt import KelvinVoigt
from snapjump.damping.mass_proportional import MassProportional
from snapjump.damping.none import NoDamping
from snapjump.discretization.corotational import Corotational
from snapjump.discretization.geometrically_exact import GeometricallyExact
from snapjump.discretization.parts.beam_elements import (
    Span,
)
from snapjump.engine.assemble import Motion
from snapjump.engine.model import Model
from snapjump.frame.fixed import FixedFrame
from snapjump.frame.parts.cantilever import CantileverFrame
from snapjump.friction.none import NoFriction
from snapjump.load.none import NoLoad
from snapjump.load.tip import TipLoad

ELEMENTS = 9
LENGTH = 1.0 / ELEMENTS
STILL = Motion(0.0, 0.0, 0.0, 0.0)
MOVING = Motion(0.4, 30.0, 30.0, 0.0)
RELAXATION = 2e-3
ELASTIC = NoDamping.Law()
CLAMP = ConstantRate(0.3, 1.5, 0.7, 0.1)
HELD, NO_LOAD = FixedFrame.Body(0.4, 0.0), NoLoad()
BEAMS = {
    "corotational": Corotational.Beam(LENGTH, 2e5),
    "geometrically_exact": GeometricallyExact.Beam(LENGTH, 2e5, 6e4),
}
FREE = slice(3, -3)

beams = pytest.mark.parametrize("beam", BEAMS.values(), ids=BEAMS)
seeds = pytest.mark.parametrize("seed", range(3))


def bent_state(seed: int) -> Any:
    """A random arch, 0.1 % stretched, with kinks."""
    rng = np.random.default_rng(seed)
    turns = np.linspace(0.9, -0.9, ELEMENTS) + rng.uniform(-0.1, 0.1, ELEMENTS)
    lengths = LENGTH * (1.0 + rng.uniform(-1e-3, 1e-3, ELEMENTS))
    state = np.zeros(3 * (ELEMENTS + 1))
    state[3::3] = np.cumsum(lengths * np.cos(turns))
    state[4::3] = np.cumsum(lengths * np.sin(turns))
    directions = np.linspace(1.0, -1.0, ELEMENTS + 1) + rng.uniform(-0.1, 0.1, ELEMENTS + 1)
    state[2::3] = LENGTH * directions
    return state


def strains(beam: Any, q: Any) -> Any:
    """Strains whose squares sum up to twice the energy."""
    ex, ey = np.diff(q[0::3]), np.diff(q[1::3])
    theta = q[2::3] / LENGTH
    bending = np.diff(theta) / np.sqrt(LENGTH)
    if isinstance(beam, Corotational.Beam):
        chord = np.arctan(ey / ex)
        a = np.array([theta[:-1] - chord, theta[1:] - chord])
        stretching = np.sqrt(beam.stretching_stiffness / LENGTH) * (
            np.sqrt(ex * ex + ey * ey) - LENGTH
        )
        root = np.linalg.cholesky(np.array([[4.0, 2.0], [2.0, 4.0]]) / LENGTH)
        return np.concatenate([stretching, *(root.T @ a)])
    middle = 0.5 * (theta[:-1] + theta[1:])
    c, s = np.cos(middle), np.sin(middle)
    stretching = np.sqrt(beam.stretching_stiffness / LENGTH) * (c * ex + s * ey - LENGTH)
    shearing = np.sqrt(beam.shear_stiffness / LENGTH) * (c * ey - s * ex)
    return np.concatenate([stretching, shearing, bending])


def model_of(beam: Any, damping: Any = ELASTIC, frame: Any = HELD, load: Any = NO_LOAD) -> Model:
    return Model(
        beam,
        frame,
        CLAMP,
        NoContact.Law(),
        NoFriction.Law(),
        damping,
        load,
    )


MASSLESS = np.zeros(ELEMENTS + 1)


@beams
@pytest.mark.parametrize("turn", [0.3, -3.1, 20.0])
def test_element_value_gradient_and_hessian(beam, turn):
    z = np.array([0.99 * LENGTH * np.cos(turn + 0.2), LENGTH * np.sin(turn + 0.2), turn])

    def gradient(z):
        return np.array(beam.strain_element(ELASTIC, Span(*z, 0.0, 0.0, 0.0, 0.0))[:3])

    own = beam.strain_element(ELASTIC, Span(*z, 0.0, 0.0, 0.0, 0.0))
    expected = complex_step(lambda z: beam.straining_energy(*z), z)
    np.testing.assert_allclose(own[:3], expected, rtol=0.0, atol=1e-13 * np.abs(expected).max())
    hessian = np.array(
        [[own.xx, own.xy, own.xt], [own.xy, own.yy, own.yt], [own.xt, own.yt, own.tt]]
    )
    expected = complex_step(gradient, z)
    np.testing.assert_allclose(hessian, expected, rtol=0.0, atol=1e-13 * np.abs(expected).max())


@beams
@seeds
def test_residual_is_the_gradient_of_the_energy(beam, seed):
    q = bent_state(seed)
    by_hand = 0.5 * np.sum(strains(beam, q) ** 2)
    assert beam.internal_energy(q, None) == pytest.approx(by_hand, rel=1e-12)
    gradient = complex_step(lambda y: 0.5 * np.sum(strains(beam, y) ** 2), q)
    _, work = assembled(model_of(beam), STILL, MASSLESS, q)
    error = np.abs(residual_of(work, 0)[FREE] - gradient[FREE]).max()
    assert error <= 1e-9 * np.abs(gradient).max()


@beams
@seeds
@pytest.mark.parametrize(
    "damping", [ELASTIC, KelvinVoigt.Law(RELAXATION), MassProportional.Law(3.0)]
)
def test_band_is_the_derivative_of_the_residual(beam, seed, damping):
    """Up to a term that damping would make unsymmetric: eta J^T dJ/dt, left out of the band."""
    q = bent_state(seed)
    origin = q + np.random.default_rng(seed).normal(0.0, 1e-4, len(q))
    model = model_of(beam, damping)
    masses = np.full(ELEMENTS + 1, LENGTH)

    def residual(y):
        return residual_of(assembled(model, MOVING, masses, y, origin=origin)[1], 0)

    def jacobian(time):
        position = q + time * (q - origin) * MOVING.rate_factor
        return complex_step(lambda y: strains(beam, y), position)

    _, work = assembled(model, MOVING, masses, q, origin=origin)
    matrix, expected = dense(work, 0), complex_step(residual, q)
    if isinstance(damping, KelvinVoigt.Law):
        change = (jacobian(1e-5) - jacobian(-1e-5)) / 2e-5
        expected = expected - RELAXATION * jacobian(0.0).T @ change
    error = np.abs(matrix[FREE, FREE] - expected[FREE, FREE]).max()
    assert error <= 1e-8 * np.abs(expected).max()
    # Slave nodes are left as identities without a load.
    assert np.array_equal(matrix[:3, :], np.eye(3, len(q)))
    assert np.array_equal(matrix[-3:, :], np.eye(len(q))[-3:])
    assert not residual_of(work, 0)[[0, 1, 2, -3, -2, -1]].any()


@beams
@seeds
def test_kelvin_voigt_is_the_gradient_of_its_dissipation(beam, seed):
    """Viscous forces are eta J^T s' with the strains' Jacobian J and rates s'."""
    q = bent_state(seed)
    origin = q + np.random.default_rng(seed).normal(0.0, 1e-4, len(q))
    velocity = (q - origin) * MOVING.rate_factor
    jacobian = complex_step(lambda y: strains(beam, y), q)
    rates = jacobian @ velocity
    expected = RELAXATION * jacobian.T @ rates
    damped, elastic = (
        residual_of(assembled(model_of(beam, d), MOVING, MASSLESS, q, origin=origin)[1], 0)
        for d in (KelvinVoigt.Law(RELAXATION), ELASTIC)
    )
    error = np.abs((damped - elastic)[FREE] - expected[FREE]).max()
    assert error <= 1e-8 * np.abs(expected).max()
    powers = beam.chain_powers(KelvinVoigt.Law(RELAXATION), q, velocity, None)
    assert powers.dissipation == pytest.approx(RELAXATION * rates @ rates, rel=1e-9)
    assert beam.chain_powers(ELASTIC, q, velocity, None).dissipation == 0.0


@beams
def test_end_forces_and_moments_are_those_of_the_energy(beam):
    q = bent_state(4)
    gradient = complex_step(lambda y: 0.5 * np.sum(strains(beam, y) ** 2), q)
    # The left clamp's moment counts against its direction, as of a hinge that begins there.
    moments = [-LENGTH * gradient[2], LENGTH * gradient[-1]]
    expected = [*moments, *gradient[:2], *gradient[-3:-1]]
    actual = beam.chain_powers(ELASTIC, q, 0.0 * q, None)[1:]
    np.testing.assert_allclose(actual, expected, rtol=0.0, atol=1e-10 * np.abs(gradient).max())


@beams
@pytest.mark.parametrize("turn", [0.7, 3.0, -7.0, 40.0])
def test_rigid_turns_change_nothing(beam, turn):
    q = bent_state(1)
    c, s = np.cos(turn), np.sin(turn)
    turned = q.copy()
    turned[0::3] = c * q[0::3] - s * q[1::3] + 5.0
    turned[1::3] = s * q[0::3] + c * q[1::3]
    turned[2::3] += LENGTH * turn
    assert beam.internal_energy(turned, None) == pytest.approx(
        beam.internal_energy(q, None), rel=1e-11
    )
    spinning = np.empty_like(q)
    spinning[0::3], spinning[1::3], spinning[2::3] = -3.0 * q[1::3], 3.0 * q[0::3], 3.0 * LENGTH
    moving = beam.chain_powers(KelvinVoigt.Law(1.0), q, spinning, None)
    assert abs(moving.dissipation) < 1e-9


@beams
@seeds
def test_free_end_feels_its_force_and_moment_only(beam, seed):
    q = bent_state(seed)
    load = TipLoad(3.0, -4.0, 2.5)
    model = model_of(beam, frame=CantileverFrame(), load=load)

    def potential(y):
        work = load.force_x * y[-3] + load.force_y * y[-2] + load.moment * y[-1] / LENGTH
        return 0.5 * np.sum(strains(beam, y) ** 2) - work

    gradient = complex_step(potential, q)
    _, work = assembled(model, STILL, MASSLESS, q)
    scale = np.abs(gradient).max()
    assert np.abs(residual_of(work, 0)[3:] - gradient[3:]).max() <= 1e-9 * scale


@beams
def test_lumped_inertia_is_that_of_rigid_half_elements(beam):
    """2 (l/2)^3 / 3 about a node, in theta."""
    q = bent_state(0)
    masses = np.full(ELEMENTS + 1, LENGTH)
    heavy, light = (
        dense(assembled(model_of(beam), MOVING, m, q)[1], 0) for m in (masses, MASSLESS)
    )
    inertia = np.diag(heavy - light)[FREE] / MOVING.rate_factor**2
    expected = np.tile([LENGTH, LENGTH, LENGTH**3 / 12.0 / LENGTH**2], ELEMENTS - 1)
    np.testing.assert_allclose(inertia, expected, rtol=1e-6)
