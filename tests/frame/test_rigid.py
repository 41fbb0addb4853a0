"""The rigid frame: everything condensed onto its three coordinates, against exact derivatives."""

from typing import Any

import numpy as np
import pytest
from plain_python import assembled, complex_step, dense, residual_of

from snapjump.clamp.constant_rate import ConstantRate
from snapjump.contact.base import Ground
from snapjump.contact.logbarrier import LogBarrier
from snapjump.contact.none import NoContact
from snapjump.damping.kelvin_voigt import KelvinVoigt
from snapjump.damping.mass_proportional import MassProportional
from snapjump.damping.none import NoDamping
from snapjump.discretization.corotational import Corotational
from snapjump.discretization.der import DiscreteElasticRod
from snapjump.discretization.geometrically_exact import GeometricallyExact
from snapjump.engine.assemble import Motion
from snapjump.engine.centre_of_mass import centre_of_mass
from snapjump.engine.model import Model
from snapjump.engine.powers import powers
from snapjump.frame.base import NO_MESH
from snapjump.frame.base import STILL as NOT_TURNING
from snapjump.frame.rigid import RigidFrame
from snapjump.friction.implicit import ImplicitFriction
from snapjump.friction.lagged import LaggedFriction
from snapjump.friction.none import NoFriction
from snapjump.load.gravity import Gravity
from snapjump.load.none import NoLoad
from snapjump.parameters.robot import Robot

ELEMENTS = 9
FRAME = RigidFrame.Body(0.4, -0.15, -0.25, 0.25, 15.0, 1.3)
BARRIER = LogBarrier.Law(4e3, 0.025, 0.0)
GROUND = Ground(7.0, 1.5, 0.025)
CLAMP = ConstantRate(0.35, 1.5, 0.6, 0.1)
HELD = ConstantRate(0.35, 1.5, 0.0, 0.1)
STILL = Motion(0.0, 0.0, 0.0, 0.0)
MOVING = Motion(0.2, 50.0, 50.0, 0.0)
DOFS = 3

NO_CONTACT, NO_FRICTION, NO_DAMPING, NO_LOAD = (
    NoContact.Law(),
    NoFriction.Law(),
    NoDamping.Law(),
    NoLoad(),
)

RODS = {
    "half_element": DiscreteElasticRod(ELEMENTS, "half_element"),
    "two_nodes": DiscreteElasticRod(ELEMENTS, "two_nodes"),
    "corotational": Corotational(ELEMENTS),
    "geometrically_exact": GeometricallyExact(ELEMENTS),
}

clamps = pytest.mark.parametrize("clamp", RODS)


def make_model(
    clamp: str = "half_element",
    contact: Any = NO_CONTACT,
    friction: Any = NO_FRICTION,
    damping: Any = NO_DAMPING,
    load: Any = NO_LOAD,
    programme: ConstantRate = CLAMP,
    stretching: float | None = None,
) -> Model:
    rod = RODS[clamp].beam(Robot())
    if stretching is not None:
        rod = rod._replace(stretching_stiffness=stretching)
    return Model(rod, FRAME, programme, contact, friction, damping, load, GROUND)


def masses_of(model: Model) -> Any:
    nodes = ELEMENTS + 1 if model.discretization.clamp_distance() == 0.0 else ELEMENTS - 1
    masses = np.full(nodes, 1.0 / ELEMENTS)
    masses[[0, -1]] = 0.0
    return masses


def angles_at(model: Model, time: float = 0.0) -> Any:
    return model.clamp.angles(time)


def full_state(model: Model, free: Any, angles: Any) -> Any:
    """State with the slave nodes in place; ``free`` are the frame's and the free nodes'."""
    free = np.asarray(free)
    zero = np.zeros(model.discretization.node_dofs(), free.dtype)
    state = np.concatenate([free[:3], zero, free[3:], zero])
    model.frame.place_ends(NO_MESH, model.discretization, angles, state)
    return state


def arch(model: Model, height: float = 0.6, turn: float = 0.1, seed: int = 0) -> Any:
    """Free coordinates of a tilted robot with a kinked, slightly stretched arch."""
    rng = np.random.default_rng(seed)
    nodes = len(masses_of(model))
    offset = model.discretization.clamp_distance()
    s = np.linspace(-1.0, 1.0, nodes)
    x = (FRAME.half_span - offset) * s
    y = FRAME.mount_y + 0.25 * (1.0 - s * s) - 0.3 * offset
    nodes_xy = np.stack([x, y], axis=1)[1:-1] + rng.uniform(-1e-3, 1e-3, (nodes - 2, 2))
    c, si = np.cos(turn), np.sin(turn)
    turned = nodes_xy @ np.array([[c, si], [-si, c]]) + [0.05, height]
    if model.discretization.node_dofs() == 3:
        directions = turn + np.linspace(0.4, -0.4, nodes)[1:-1] + rng.uniform(-0.1, 0.1, nodes - 2)
        turned = np.column_stack([turned, model.discretization.turn_length() * directions])
    return np.concatenate([[0.05, height, turn], turned.ravel()])


def free_part(model: Model, values: Any) -> Any:
    dofs = model.discretization.node_dofs()
    return np.concatenate([values[:3], values[3 + dofs : -dofs]])


def push_into_barrier(model: Model, free: Any) -> None:
    """Put three nodes of the beam close to the ground."""
    dofs = model.discretization.node_dofs()
    free[4 + 2 * dofs : 4 + 5 * dofs : dofs] = [0.011, 0.013, 0.012]


def check_tangent(model: Model, motion: Motion, free: Any, origin: Any = None) -> None:
    masses = masses_of(model)
    angles = angles_at(model, motion.time)
    if origin is None:
        origin = full_state(model, free, angles)

    def residual(z):
        state = full_state(model, z, angles)
        _, work = assembled(model, motion, masses, state, origin=origin)
        return free_part(model, residual_of(work, DOFS))

    _, work = assembled(model, motion, masses, full_state(model, free, angles), origin=origin)
    dofs = model.discretization.node_dofs()
    keep = np.r_[0:3, 3 + dofs : 3 + dofs * (len(masses) - 1)]
    matrix = dense(work, DOFS)[np.ix_(keep, keep)]
    expected = complex_step(residual, free)
    # Rows of the frame and of the nodes have scales of their own.
    scale = np.abs(expected).max(axis=1, keepdims=True)
    assert (np.abs(matrix - expected) / scale).max() < 1e-8


@clamps
def test_residual_is_the_gradient_of_the_whole_energy(clamp):
    """Elastic, gravitational and barrier energy, with corners and nodes in the barrier."""
    model = make_model(clamp, BARRIER, load=Gravity(20.0))
    free = arch(model, height=0.27, turn=0.005)
    push_into_barrier(model, free)
    masses, angles = masses_of(model), angles_at(model)

    def potential(z):
        state = full_state(model, z, angles)
        tangents = FRAME.end_tangents(NO_MESH, model.load, angles, state, NOT_TURNING)
        energy = model.discretization.internal_energy(state[3:], tangents)
        heights = state[4 :: model.discretization.node_dofs()]
        energy = energy + 20.0 * (FRAME.mass * state[1] + masses @ heights)
        points = [(FRAME.corner_point(NO_MESH, k, state, 0 * state)[1], 1.5) for k in range(4)]
        points += [(y, 7.0) for y in heights[1:-1]]
        near = [(gap, weight) for gap, weight in points if gap.real < BARRIER.distance]
        assert len(near) >= 4
        return energy + sum(weight * BARRIER.energy(gap) for gap, weight in near)

    figures, work = assembled(model, STILL, masses, full_state(model, free, angles))
    expected = complex_step(potential, free)
    actual = free_part(model, residual_of(work, DOFS))
    np.testing.assert_allclose(actual, expected, rtol=1e-8, atol=1e-8 * np.abs(expected).max())
    assert figures.smallest_gap == pytest.approx(0.011)


@clamps
def test_tangent_of_beam_and_frame_in_motion(clamp):
    model = make_model(clamp, damping=MassProportional.Law(3.0), load=Gravity(20.0))
    free = arch(model)
    origin = full_state(model, free + 1e-4 * np.cos(np.arange(len(free))), angles_at(model))
    check_tangent(model, MOVING, free, origin)


@clamps
def test_tangent_with_material_damping_about_rest(clamp):
    model = make_model(clamp, damping=KelvinVoigt.Law(1e-2), programme=HELD)
    check_tangent(model, MOVING, arch(model))


@clamps
def test_tangent_with_corners_and_nodes_in_the_barrier(clamp):
    model = make_model(clamp, BARRIER, load=Gravity(20.0))
    free = arch(model, height=0.27, turn=0.02)
    push_into_barrier(model, free)
    check_tangent(model, MOVING, free)


@pytest.mark.parametrize("slip", [0.02, 0.2, 3.0], ids=["stick", "edge", "slide"])
def test_tangent_of_friction_at_the_corners(slip):
    """The frame's own block is unsymmetric, and exact (soft beam, lest it hide friction)."""
    model = make_model(contact=BARRIER, friction=ImplicitFriction.Law(0.4, 0.25), stretching=10.0)
    free = arch(model, height=0.268, turn=0.01)
    origin = full_state(model, free, angles_at(model))
    origin[0] -= slip / MOVING.rate_factor
    origin[2] -= 0.1 / MOVING.rate_factor
    check_tangent(model, MOVING, free, origin)
    _, work = assembled(
        model, MOVING, masses_of(model), full_state(model, free, angles_at(model)), origin=origin
    )
    square = work.system.square
    assert abs(square[0, 1] - square[1, 0]) > 0.01 * np.abs(square).max()


def test_friction_opposes_sliding_at_the_feet():
    model = make_model(contact=BARRIER, friction=ImplicitFriction.Law(0.4, 0.25))
    state = full_state(model, arch(model, height=0.27, turn=0.0), angles_at(model))
    frictionless = make_model(contact=BARRIER)
    masses = masses_of(model)
    origin = state.copy()
    origin[0::2] -= 1.0  # everything slides along +x
    origin[1], origin[2] = state[1], state[2]
    origin[3::2] = state[3::2]
    with_friction = assembled(model, MOVING, masses, state, origin=origin)[1]
    without = assembled(frictionless, MOVING, masses, state, origin=origin)[1]
    drag = with_friction.system.frame_residual - without.system.frame_residual
    normal = -(
        without.system.frame_residual[1]
        - assembled(make_model(), MOVING, masses, state, origin=origin)[1].system.frame_residual[1]
    )
    # Sliding beyond the threshold: mu N against the motion, at the feet below the centre.
    assert drag[0] == pytest.approx(0.4 * normal, rel=1e-12)
    assert drag[2] == pytest.approx(0.25 * drag[0], rel=1e-12)
    assert drag[1] == 0.0


@pytest.mark.parametrize("height", [0.27, 0.30])  # within the barrier's reach, and lifted off
def test_lagged_friction_takes_force_and_velocity_of_the_step_s_beginning(height):
    model = make_model(contact=BARRIER, friction=LaggedFriction.Law(0.4, 0.25))
    plain = make_model(contact=BARRIER)
    masses = masses_of(model)
    begun = full_state(model, arch(model, height=0.26, turn=0.0), angles_at(model))
    now = full_state(model, arch(model, height=height, turn=0.0), angles_at(model))
    velocity = np.zeros((2, len(now)))
    velocity[0, 0] = 2.0
    arrays = {"start": begun, "velocity": velocity, "origin": now}
    lagged = assembled(model, MOVING, masses, now, **arrays)[1]
    without = assembled(plain, MOVING, masses, now, **arrays)[1]
    at_start = assembled(plain, MOVING, masses, begun, origin=begun)[1]
    clear = assembled(make_model(), MOVING, masses, begun, origin=begun)[1]
    normal = clear.system.frame_residual[1] - at_start.system.frame_residual[1]
    drag = lagged.system.frame_residual - without.system.frame_residual
    assert drag[0] == pytest.approx(0.4 * normal, rel=1e-12)
    assert np.array_equal(lagged.system.square, without.system.square)


@clamps
@pytest.mark.parametrize("damping", [NoDamping.Law(), KelvinVoigt.Law(1e-2)])
def test_internal_forces_have_no_resultant(clamp, damping):
    model = make_model(clamp, damping=damping)
    angles = angles_at(model, MOVING.time)
    state = full_state(model, arch(model), angles)
    origin = full_state(model, arch(model, turn=0.11, seed=1), angles)
    drift = (state - origin) * MOVING.rate_factor  # as fast as now: no acceleration
    _, work = assembled(model, MOVING, masses_of(model), state, origin=origin, drift=drift)
    force = residual_of(work, DOFS)
    dofs = model.discretization.node_dofs()
    nodes, places = force[3:].reshape(-1, dofs), state[3:].reshape(-1, dofs)
    scale = np.abs(force).max()
    resultant = force[:2] + nodes[:, :2].sum(axis=0)
    moment = force[2] + state[0] * force[1] - state[1] * force[0]
    moment += np.sum(places[:, 0] * nodes[:, 1] - places[:, 1] * nodes[:, 0])
    moment += model.discretization.turn_length() * nodes[:, 2:].sum()
    assert scale > 1.0
    assert np.abs(resultant).max() < 1e-11 * scale * len(nodes)
    assert abs(moment) < 1e-11 * scale * len(nodes)


@clamps
def test_clamps_give_the_power_that_the_energy_gains(clamp):
    """The reaction torque: at a still robot, work of the clamps is change of elastic energy."""
    model = make_model(clamp)
    masses, free = masses_of(model), arch(model)
    angles = angles_at(model)
    state = full_state(model, free, angles)

    def energy(turned):
        # The right clamp turns along with the left one, at the same rate.
        moved = angles._replace(left=angles.left + turned[0], right=angles.right + turned[0])
        at = full_state(model, np.asarray(free, complex), moved)
        tangents = FRAME.end_tangents(NO_MESH, model.load, moved, at, NOT_TURNING)
        return model.discretization.internal_energy(at[3:], tangents)

    gain = complex_step(energy, [0.0])[0] * CLAMP.rate
    _, work = assembled(model, STILL, masses, state)
    found = powers(model, STILL, masses, work, state, 0.0 * state)
    assert found.clamps == pytest.approx(gain, rel=1e-9)
    assert found.friction == found.damping == found.contact == 0.0


def test_inertia_and_weight_of_the_frame():
    model = make_model(load=Gravity(20.0))
    masses = masses_of(model)
    state = full_state(model, arch(model), angles_at(model))
    origin = state.copy()
    drift = np.zeros_like(state)
    drift[:3] = [-0.1, 0.2, 0.3]
    moving = assembled(model, MOVING, masses, state, origin=origin, drift=drift)[1]
    still = assembled(make_model(), MOVING, masses, state, origin=origin)[1]
    gained = moving.system.frame_residual - still.system.frame_residual
    expected = -50.0 * drift[:3] * [FRAME.mass, FRAME.mass, FRAME.inertia]
    expected[1] += 20.0 * FRAME.mass
    np.testing.assert_allclose(gained, expected, rtol=1e-10)


@clamps
def test_ends_are_where_the_frame_holds_them(clamp):
    model = make_model(clamp)
    angles = angles_at(model)
    state = full_state(model, arch(model, turn=0.4), angles)
    offset = model.discretization.clamp_distance()
    dofs = model.discretization.node_dofs()
    for node, side, direction in (
        (state[3 : 3 + dofs], -1.0, 0.4 - angles.left),
        (state[-dofs:], 1.0, 0.4 + angles.right),
    ):
        body = np.array([side * FRAME.half_span, FRAME.mount_y])
        c, s = np.cos(0.4), np.sin(0.4)
        mount = state[:2] + [c * body[0] - s * body[1], s * body[0] + c * body[1]]
        expected = mount - side * offset * np.array([np.cos(direction), np.sin(direction)])
        np.testing.assert_allclose(node[:2], expected, atol=1e-14)
        if dofs == 3:
            assert node[2] == pytest.approx(model.discretization.turn_length() * direction)


@pytest.mark.parametrize("turn", [-3.0, -0.2, 0.0, 1.5])
def test_a_step_leaves_every_corner_its_share_of_gap(turn):
    rng = np.random.default_rng(3)
    limited = 0
    for _ in range(200):
        state = np.array([0.0, 0.5 + rng.uniform(), turn])
        gaps = [FRAME.corner_point(NO_MESH, k, state, 0 * state)[1] for k in range(4)]
        if min(gaps) <= 0.0:
            continue
        drop = rng.normal(0.0, 1.0, 3)
        share = FRAME.limit_step(NO_MESH, state, drop, 0.15)
        assert 0.0 < share <= 1.0
        limited += share < 1.0
        after = state - share * drop
        for k, gap in enumerate(gaps):
            assert FRAME.corner_point(NO_MESH, k, after, 0 * after)[1] >= 0.15 * gap * (1.0 - 1e-12)
    assert limited > 20


def test_corner_velocity_is_the_derivative_of_its_place():
    state, velocity = np.array([0.1, 0.6, 0.3]), np.array([0.4, -0.2, 2.0])
    for corner in range(4):
        moved = complex_step(
            lambda t, k=corner: FRAME.corner_point(NO_MESH, k, state + t[0] * velocity, velocity)[
                0
            ],
            [0.0],
        )[0]
        assert FRAME.corner_point(NO_MESH, corner, state, velocity)[2] == pytest.approx(
            moved, rel=1e-12
        )
    corners = {
        tuple(np.round(FRAME.corner_point(NO_MESH, k, 0 * state, velocity)[:2], 12))
        for k in range(4)
    }
    assert corners == {(x, y) for x in (-0.4, 0.4) for y in (-0.25, 0.25)}


@clamps
def test_centre_of_mass_weighs_frame_and_beam(clamp):
    model = make_model(clamp)
    dofs = model.discretization.node_dofs()
    masses = masses_of(model)
    state = full_state(model, arch(model), angles_at(model))
    x, y, vx, vy = centre_of_mass(model, masses, NO_MESH, state, 2.0 * state)
    total = FRAME.mass + masses.sum()
    assert x == pytest.approx((FRAME.mass * state[0] + masses @ state[3::dofs]) / total, rel=1e-14)
    assert y == pytest.approx((FRAME.mass * state[1] + masses @ state[4::dofs]) / total, rel=1e-14)
    assert (vx, vy) == pytest.approx((2.0 * x, 2.0 * y))
