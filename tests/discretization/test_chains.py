"""Chains of elements against strains written down independently and differentiated exactly.

Every chain is held to the same rules, hence one file of more than 250 lines.
"""

from typing import Any

import numpy as np
import pytest
from bare_models import bare_model
from chains import CHAINS, ELEMENTS, LENGTH, RODS, TURNING
from plain_python import assembled, complex_step, dense

from snapjump.damping.kelvin_voigt import KelvinVoigt
from snapjump.damping.mass_proportional import MassProportional
from snapjump.damping.none import NoDamping
from snapjump.discretization.base import EndTangents
from snapjump.discretization.parts.beam_elements import Span
from snapjump.drive.constant_rate import ConstantRate
from snapjump.engine.assemble import Motion
from snapjump.engine.load.tip import TipLoad
from snapjump.engine.model import Model
from snapjump.frame.fixed import FixedFrame
from snapjump.frame.parts.cantilever import CantileverFrame

CLAMP = ConstantRate.Law(0.3, 1.5, 0.7, 0.1)
STILL = Motion(0.0, 0.0, 0.0, 0.0)
MOVING = Motion(0.4, 30.0, 30.0, 0.0)
RELAXATION = 2e-3
ELASTIC, VISCOUS = NoDamping.Law(), KelvinVoigt.Law(RELAXATION)


chains = pytest.mark.parametrize("chain", CHAINS.values(), ids=CHAINS)
rods = pytest.mark.parametrize("chain", RODS.values(), ids=RODS)
turning = pytest.mark.parametrize("chain", TURNING.values(), ids=TURNING)
seeds = pytest.mark.parametrize("seed", range(3))


def model_of(chain: Any, damping: Any = ELASTIC, **others: Any) -> Model:
    frame = others.pop("frame", FixedFrame.Body(0.4, 0.0))
    return bare_model(chain.beam, frame, clamp=CLAMP, damping=damping, **others)


def held_to(model: Model, motion: Motion, q: Any, each: float = 0.0, origin: Any = None) -> Any:
    """The memory after an assembly, nodes weighing so much ``each``."""
    masses = np.full(len(q) // model.discretization.node_dofs(), each)
    arrays = {} if origin is None else {"position_predictor": origin}
    return assembled(model, motion, masses, q, **arrays)[1]


def free(chain: Any) -> slice:
    return slice(chain.dofs, -chain.dofs)


def directions(time: float = 0.0) -> tuple[float, float]:
    turned = CLAMP.start + CLAMP.rate * time
    return -turned, turned - CLAMP.delta_alpha


def tangents_of(left: float, right: float, left_rate: float, right_rate: float) -> EndTangents:
    begin, end = (np.cos(left), np.sin(left)), (np.cos(right), np.sin(right))
    return EndTangents(*begin, left_rate, *end, right_rate, 0.0, 0.0)


def energy_gradient(chain: Any, q: Any, time: float = 0.0) -> Any:
    """Gradient of the strains' energy by the nodes' coordinates and the clamps' directions."""

    def energy(z: Any) -> Any:
        return 0.5 * np.sum(chain.strains(z[:-2], z[-2], z[-1]) ** 2)

    return complex_step(energy, np.concatenate([q, directions(time)]))


def moved_back(q: Any, seed: int) -> Any:
    """Where a chain was that is on its way to q."""
    return q + np.random.default_rng(seed).normal(0.0, 1e-4, len(q))


@turning
@pytest.mark.parametrize("turn", [0.3, -3.1, 20.0])
def test_element_value_gradient_and_hessian(chain, turn):
    beam = chain.beam
    z = np.array([0.99 * LENGTH * np.cos(turn + 0.2), LENGTH * np.sin(turn + 0.2), turn])

    def element(z):
        return beam.strain_element(ELASTIC, Span(*z, 0.0, 0.0, 0.0, 0.0))

    own = element(z)
    hessian = [[own.xx, own.xy, own.xt], [own.xy, own.yy, own.yt], [own.xt, own.yt, own.tt]]
    for found, function in (
        (own[:3], lambda z: beam.straining_energy(*z)),
        (hessian, lambda z: np.array(element(z)[:3])),
    ):
        expected = complex_step(function, z)
        np.testing.assert_allclose(found, expected, rtol=0.0, atol=1e-13 * np.abs(expected).max())


@chains
@seeds
def test_residual_is_the_gradient_of_the_energy(chain, seed):
    q, (left, right) = chain.bent(seed), directions()
    tangents = tangents_of(left, right, 0.0, 0.0)
    by_hand = 0.5 * np.sum(chain.strains(q, left, right) ** 2)
    assert chain.beam.internal_energy(q, tangents) == pytest.approx(by_hand, rel=1e-12)
    gradient = energy_gradient(chain, q)[:-2]
    own = complex_step(lambda y: chain.beam.internal_energy(y, tangents), q)
    scale = np.abs(gradient).max()
    assert np.abs(own - gradient).max() <= 1e-10 * scale
    error = (held_to(model_of(chain), STILL, q).residual - gradient)[free(chain)]
    assert np.abs(error).max() <= chain.close * scale


@chains
@seeds
@pytest.mark.parametrize("damping", [ELASTIC, VISCOUS, MassProportional.Law(3.0)])
def test_band_is_the_derivative_of_the_residual(chain, seed, damping):
    """The band leaves out the term that damping would make unsymmetric, eta J^T dJ/dt."""
    q, model = chain.bent(seed), model_of(chain, damping)
    origin, dofs, inner = moved_back(q, seed), chain.dofs, free(chain)

    def jacobian(time):
        left, right = directions(MOVING.time + time)
        position = q + time * (q - origin) * MOVING.rate_factor
        return complex_step(lambda y: chain.strains(y, left, right), position)

    work = held_to(model, MOVING, q, LENGTH, origin)
    matrix = dense(work, 0)
    expected = complex_step(lambda y: held_to(model, MOVING, y, LENGTH, origin).residual, q)
    if damping is VISCOUS:
        change = (jacobian(1e-5) - jacobian(-1e-5)) / 2e-5
        expected = expected - RELAXATION * jacobian(0.0).T @ change
    error = np.abs(matrix[inner, inner] - expected[inner, inner]).max()
    assert error <= 1e-8 * np.abs(expected).max()
    # Slave nodes are left as identities without a load.
    assert np.array_equal(matrix[:dofs, :], np.eye(dofs, len(q)))
    assert np.array_equal(matrix[-dofs:, :], np.eye(len(q))[-dofs:])
    assert not work.residual[:dofs].any() and not work.residual[-dofs:].any()


@chains
@seeds
def test_kelvin_voigt_is_the_gradient_of_its_dissipation(chain, seed):
    """Viscous forces are eta J^T s' with the strains' Jacobian J and rates s'."""
    q, inner = chain.bent(seed), free(chain)
    origin = moved_back(q, seed)
    velocity = (q - origin) * MOVING.rate_factor
    left, right = directions(MOVING.time)
    everything = np.concatenate([q, [left, right]])
    jacobian = complex_step(lambda z: chain.strains(z[:-2], z[-2], z[-1]), everything)
    rates = jacobian @ np.concatenate([velocity, [-CLAMP.rate, CLAMP.rate]])
    expected = RELAXATION * jacobian[:, :-2].T @ rates
    damped, elastic = (
        held_to(model_of(chain, damping), MOVING, q, 0.0, origin).residual
        for damping in (VISCOUS, ELASTIC)
    )
    error = np.abs((damped - elastic)[inner] - expected[inner]).max()
    assert error <= 1e-8 * np.abs(expected).max()
    tangents = tangents_of(left, right, -CLAMP.rate, CLAMP.rate)
    powers = chain.beam.chain_powers(VISCOUS, q, velocity, tangents)
    assert powers.dissipation == pytest.approx(RELAXATION * rates @ rates, rel=1e-9)
    assert powers.dissipation > 0.0
    assert chain.beam.chain_powers(ELASTIC, q, velocity, tangents).dissipation == 0.0


@chains
def test_end_forces_and_moments_are_those_of_the_energy(chain):
    q = chain.bent(4)
    gradient = energy_gradient(chain, q)
    last = len(q) - chain.dofs
    expected = [*chain.moments(gradient), *gradient[:2], *gradient[last : last + 2]]
    tangents = tangents_of(*directions(), 0.0, 0.0)
    actual = chain.beam.chain_powers(ELASTIC, q, 0.0 * q, tangents)[1:]
    near = chain.closest * np.abs(gradient).max()
    np.testing.assert_allclose(actual, expected, rtol=0.0, atol=near)


@rods
def test_rigid_motion_costs_nothing(chain):
    rod, q, turn = chain.beam, chain.bent(1), 3.0
    velocity = np.empty_like(q)
    velocity[0::2] = 5.0 - turn * q[1::2]
    velocity[1::2] = -2.0 + turn * q[0::2]
    along = tangents_of(-0.3, 0.2, turn, turn)
    still = rod.chain_powers(ELASTIC, q, velocity, along)
    moving = rod.chain_powers(KelvinVoigt.Law(1.0), q, velocity, along)
    assert abs(moving.dissipation) < 1e-10
    np.testing.assert_allclose(moving[1:], still[1:], rtol=1e-7)
    # One clamp that does not turn along is enough to dissipate.
    held = rod.chain_powers(KelvinVoigt.Law(1.0), q, velocity, tangents_of(-0.3, 0.2, 0.0, turn))
    assert held.dissipation > 1.0


@turning
@pytest.mark.parametrize("turn", [0.7, 3.0, -7.0, 40.0])
def test_rigid_turns_change_nothing(chain, turn):
    beam, q = chain.beam, chain.bent(1)
    x, y = q[0::3], q[1::3]
    c, s = np.cos(turn), np.sin(turn)
    places = [c * x - s * y + 5.0, s * x + c * y, q[2::3] + LENGTH * turn]
    turned = np.ravel(np.column_stack(places))
    energy = beam.internal_energy(q, None)
    assert beam.internal_energy(turned, None) == pytest.approx(energy, rel=1e-11)
    spinning = np.ravel(np.column_stack([-3.0 * y, 3.0 * x, np.full_like(x, 3.0 * LENGTH)]))
    assert abs(beam.chain_powers(KelvinVoigt.Law(1.0), q, spinning, None).dissipation) < 1e-9


@pytest.mark.parametrize("name", ["half_element", *TURNING])
@seeds
def test_free_end_feels_its_force_and_moment_only(name, seed):
    chain = CHAINS[name]
    q, (left, _), dofs = chain.bent(seed), directions(), chain.dofs
    load = TipLoad(3.0, -4.0, 2.5)
    model = model_of(chain, frame=CantileverFrame(), load=load)

    def potential(y):
        work = load.force_x * y[-dofs] + load.force_y * y[1 - dofs]
        work = work + load.moment * chain.tip_turn(y)
        return 0.5 * np.sum(chain.strains(y, left, 0.0, held=0.0) ** 2) - work

    gradient, work = complex_step(potential, q), held_to(model, STILL, q)
    error = np.abs(work.residual - gradient)[dofs:].max()
    assert error <= chain.close * np.abs(gradient).max()
    expected = complex_step(lambda y: held_to(model, STILL, y).residual, q)
    error = np.abs(dense(work, 0) - expected)[dofs:, dofs:].max()
    assert error <= 1e-8 * np.abs(expected).max()


@turning
def test_lumped_inertia_is_that_of_rigid_half_elements(chain):
    """2 (l/2)^3 / 3 about a node, in theta."""
    q = chain.bent(0)
    heavy, light = (dense(held_to(model_of(chain), MOVING, q, m), 0) for m in (LENGTH, 0.0))
    inertia = np.diag(heavy - light)[free(chain)] / MOVING.rate_factor**2
    expected = np.tile([LENGTH, LENGTH, LENGTH**3 / 12.0 / LENGTH**2], ELEMENTS - 1)
    np.testing.assert_allclose(inertia, expected, rtol=1e-6)


def test_two_fixed_nodes_leave_out_the_clamped_elements():
    half, two = (RODS[clamp].beam for clamp in ("half_element", "two_nodes"))
    assert half.element_length == two.element_length == LENGTH
    assert (half.clamp_offset, half.clamp_hinge_length) == (0.0, 0.5 * LENGTH)
    assert (two.clamp_offset, two.clamp_hinge_length) == (LENGTH, LENGTH)
