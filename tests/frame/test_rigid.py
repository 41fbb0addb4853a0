"""The rigid frame: everything condensed onto its three coordinates, against exact derivatives.

All of it is about one small robot, ``Case``, hence one file of more than 250 lines.
"""

from typing import Any

import numpy as np
import pytest
from bare_models import bare_model
from families import FAMILIES
from plain_python import assembled, complex_step, dense, residual_of

from snapjump import Robot
from snapjump.contact.base import Ground
from snapjump.contact.logbarrier import LogBarrier
from snapjump.damping.kelvin_voigt import KelvinVoigt
from snapjump.damping.mass_proportional import MassProportional
from snapjump.damping.none import NoDamping
from snapjump.drive.constant_rate import ConstantRate
from snapjump.engine.assemble import Motion
from snapjump.engine.centre_of_mass import centre_of_mass
from snapjump.engine.gaps import gap_safe_share
from snapjump.engine.load.gravity import Gravity
from snapjump.engine.powers import powers
from snapjump.frame.base import NO_MESH
from snapjump.frame.base import STILL as NOT_TURNING
from snapjump.frame.rigid import RigidFrame
from snapjump.friction.implicit import ImplicitFriction
from snapjump.friction.lagged import LaggedFriction

ELEMENTS = 9
FRAME = RigidFrame.Body(0.4, -0.15, -0.25, 0.25, 15.0, 1.3, 0.06, 0.01)
BARRIER = LogBarrier.Law(4e3, 0.025, 0.0)
FRICTION = ImplicitFriction.Law(0.4, 0.25)
CLAMP = ConstantRate.Law(0.35, 1.5, 0.6, 0.1)
HELD = CLAMP._replace(rate=0.0)
STILL = Motion(0.0, 0.0, 0.0, 0.0)
MOVING = Motion(0.2, 50.0, 50.0, 0.0)
DOFS = 3

MEMBERS = FAMILIES["discretization"]
RODS = {name: cls(ELEMENTS) for name, cls in MEMBERS.items()}
RODS["two_nodes"] = MEMBERS["der"](ELEMENTS, "two_nodes")
clamps = pytest.mark.parametrize("clamp", RODS)


class Case:
    """A robot with members that are given, its clamps turned until a time."""

    def __init__(self, rod: str = "der", time: float = 0.0, **members: Any):
        self.beam = members.pop("beam", RODS[rod].beam(Robot()))
        others = {"clamp": CLAMP, "ground": Ground(7.0, 1.5, 0.025)}
        self.model = bare_model(self.beam, FRAME, **(others | members))
        self.angles = self.model.clamp.angles(time)
        self.dofs, self.offset = self.beam.node_dofs(), self.beam.clamp_distance()
        self.nodes = ELEMENTS + 1 if self.offset == 0.0 else ELEMENTS - 1
        self.masses = np.full(self.nodes, 1.0 / ELEMENTS)
        self.masses[[0, -1]] = 0.0

    def state(self, free: Any, angles: Any = None) -> Any:
        """With the slave nodes in place; ``free`` are the frame's and the free nodes'."""
        free = np.asarray(free)
        zero = np.zeros(self.dofs, free.dtype)
        state = np.concatenate([free[:3], zero, free[3:], zero])
        FRAME.place_ends(NO_MESH, self.beam, angles or self.angles, state)
        return state

    def free_part(self, values: Any) -> Any:
        return np.concatenate([values[:3], values[3 + self.dofs : -self.dofs]])

    def arch(self, height: float = 0.6, turn: float = 0.1, seed: int = 0) -> Any:
        """Free coordinates of a tilted robot with a kinked, slightly stretched arch."""
        rng = np.random.default_rng(seed)
        s, inner = np.linspace(-1.0, 1.0, self.nodes), self.nodes - 2
        x = (FRAME.half_span - self.offset) * s - FRAME.offset
        y = FRAME.mount_y + 0.25 * (1.0 - s * s) - 0.3 * self.offset
        places = np.stack([x, y], axis=1)[1:-1] + rng.uniform(-1e-3, 1e-3, (inner, 2))
        c, si = np.cos(turn), np.sin(turn)
        turned = places @ np.array([[c, si], [-si, c]]) + [0.05, height]
        if self.dofs == 3:
            directions = turn + np.linspace(0.4, -0.4, self.nodes)[1:-1]
            directions = directions + rng.uniform(-0.1, 0.1, inner)
            turned = np.column_stack([turned, self.beam.rotation_length() * directions])
        return np.concatenate([[0.05, height, turn], turned.ravel()])

    def in_the_barrier(self, turn: float) -> Any:
        """The same with the feet and three nodes of the beam close to the ground."""
        free = self.arch(height=0.27, turn=turn)
        free[4 + 2 * self.dofs : 4 + 5 * self.dofs : self.dofs] = [0.011, 0.013, 0.012]
        return free

    def assembled(self, motion: Motion, state: Any, **arrays: Any) -> Any:
        return assembled(self.model, motion, self.masses, state, **arrays)[1]

    def on_the_frame(self, motion: Motion, state: Any, **arrays: Any) -> Any:
        """The residual of the frame's coordinates."""
        return self.assembled(motion, state, **arrays).frame_residual

    def check_tangent(self, free: Any, origin: Any = None) -> Any:
        """Against complex steps, in motion; the memory after the assembly."""
        angles = self.model.clamp.angles(MOVING.time)
        origin = self.state(free, angles) if origin is None else origin

        def residual(z: Any) -> Any:
            work = self.assembled(MOVING, self.state(z, angles), position_predictor=origin)
            return self.free_part(residual_of(work, DOFS))

        work = self.assembled(MOVING, self.state(free, angles), position_predictor=origin)
        keep = np.r_[0:3, 3 + self.dofs : 3 + self.dofs * (self.nodes - 1)]
        matrix, expected = dense(work, DOFS)[np.ix_(keep, keep)], complex_step(residual, free)
        # Rows of the frame and of the nodes have scales of their own.
        scale = np.abs(expected).max(axis=1, keepdims=True)
        assert (np.abs(matrix - expected) / scale).max() < 1e-8
        return work


def corner(k: int, state: Any, velocity: Any = None) -> Any:
    return FRAME.corner_point(NO_MESH, k, state, 0 * state if velocity is None else velocity)


@clamps
def test_residual_is_the_gradient_of_the_whole_energy(clamp):
    """Elastic, gravitational and barrier energy, with corners and nodes in the barrier."""
    case = Case(clamp, contact=BARRIER, load=Gravity(20.0))
    free, beam = case.in_the_barrier(turn=0.005), case.beam

    def potential(z):
        state = case.state(z)
        tangents = FRAME.end_tangents(NO_MESH, case.model.load, case.angles, state, NOT_TURNING)
        heights = state[4 :: case.dofs]
        energy = beam.internal_energy(state[3:], tangents)
        energy = energy + 20.0 * (FRAME.mass * state[1] + case.masses @ heights)
        points = [(corner(k, state)[1], 1.5) for k in range(4)]
        points += [(y, 7.0) for y in heights[1:-1]]
        near = [(gap, weight) for gap, weight in points if gap.real < BARRIER.distance]
        assert len(near) >= 4
        return energy + sum(weight * BARRIER.energy(gap) for gap, weight in near)

    figures, work = assembled(case.model, STILL, case.masses, case.state(free))
    expected, actual = complex_step(potential, free), case.free_part(residual_of(work, DOFS))
    np.testing.assert_allclose(actual, expected, rtol=1e-8, atol=1e-8 * np.abs(expected).max())
    assert figures.smallest_gap == pytest.approx(0.011)


@clamps
def test_tangents(clamp):
    """Of beam and frame in motion, with damping about rest, with corners and nodes in contact."""
    moving = Case(clamp, damping=MassProportional.Law(3.0), load=Gravity(20.0))
    free = moving.arch()
    moving.check_tangent(free, moving.state(free + 1e-4 * np.cos(np.arange(len(free)))))
    viscous = Case(clamp, damping=KelvinVoigt.Law(1e-2), clamp=HELD)
    viscous.check_tangent(viscous.arch())
    touching = Case(clamp, contact=BARRIER, load=Gravity(20.0))
    touching.check_tangent(touching.in_the_barrier(turn=0.02))


@pytest.mark.parametrize("slip", [0.02, 0.2, 3.0], ids=["stick", "edge", "slide"])
def test_tangent_of_friction_at_the_corners(slip):
    """The frame's own block is unsymmetric, and exact (soft beam, lest it hide friction)."""
    soft = Case().beam._replace(stretching_stiffness=10.0)
    case = Case(beam=soft, contact=BARRIER, friction=FRICTION)
    free = case.arch(height=0.268, turn=0.01)
    origin = case.state(free)
    origin[0] -= slip / MOVING.rate_factor
    origin[2] -= 0.1 / MOVING.rate_factor
    square = case.check_tangent(free, origin).corner_block
    assert abs(square[0, 1] - square[1, 0]) > 0.01 * np.abs(square).max()


def test_friction_opposes_sliding_at_the_feet():
    cases = Case(contact=BARRIER, friction=FRICTION), Case(contact=BARRIER), Case()
    state = cases[0].state(cases[0].arch(height=0.27, turn=0.0))
    origin = state.copy()
    origin[0] -= 1.0  # the frame slides along +x
    with_friction, without, clear = (
        case.on_the_frame(MOVING, state, position_predictor=origin) for case in cases
    )
    drag, normal = with_friction - without, clear[1] - without[1]
    # Sliding beyond the threshold: mu N against the motion, at the feet below the centre.
    assert drag[0] == pytest.approx(0.4 * normal, rel=1e-12)
    assert drag[2] == pytest.approx(0.25 * drag[0], rel=1e-12)
    assert drag[1] == 0.0


@pytest.mark.parametrize("height", [0.27, 0.30])  # within the barrier's reach, and lifted off
def test_lagged_friction_takes_force_and_velocity_of_the_step_s_beginning(height):
    smooth = Case(contact=BARRIER)
    rough = Case(contact=BARRIER, friction=LaggedFriction.Law(0.4, 0.25))
    begun, now = (rough.state(rough.arch(height=h, turn=0.0)) for h in (0.26, height))
    velocity = np.zeros((2, len(now)))
    velocity[0, 0] = 2.0
    arrays = {"start": begun, "velocity": velocity, "position_predictor": now}
    lagged, without = (case.assembled(MOVING, now, **arrays) for case in (rough, smooth))
    at_start, clear = (
        case.on_the_frame(MOVING, begun, position_predictor=begun) for case in (smooth, Case())
    )
    drag = lagged.frame_residual - without.frame_residual
    assert drag[0] == pytest.approx(0.4 * (clear[1] - at_start[1]), rel=1e-12)
    assert np.array_equal(lagged.corner_block, without.corner_block)


@clamps
@pytest.mark.parametrize("damping", [NoDamping.Law(), KelvinVoigt.Law(1e-2)])
def test_internal_forces_have_no_resultant(clamp, damping):
    case = Case(clamp, MOVING.time, damping=damping)
    state, origin = case.state(case.arch()), case.state(case.arch(turn=0.11, seed=1))
    drift = (state - origin) * MOVING.rate_factor  # as fast as now: no acceleration
    force = residual_of(
        case.assembled(MOVING, state, position_predictor=origin, velocity_predictor=drift), DOFS
    )
    nodes, places = force[3:].reshape(-1, case.dofs), state[3:].reshape(-1, case.dofs)
    scale = np.abs(force).max()
    resultant = force[:2] + nodes[:, :2].sum(axis=0)
    moment = force[2] + state[0] * force[1] - state[1] * force[0]
    moment += np.sum(places[:, 0] * nodes[:, 1] - places[:, 1] * nodes[:, 0])
    moment += case.beam.rotation_length() * nodes[:, 2:].sum()
    assert scale > 1.0
    assert np.abs(resultant).max() < 1e-11 * scale * len(nodes)
    assert abs(moment) < 1e-11 * scale * len(nodes)


@clamps
def test_clamps_give_the_power_that_the_energy_gains(clamp):
    """The reaction torque: at a still robot, work of the clamps is change of elastic energy."""
    case = Case(clamp)
    free, angles = case.arch(), case.angles
    state = case.state(free)

    def energy(turned):
        # The right clamp turns along with the left one, at the same rate.
        moved = angles._replace(left=angles.left + turned[0], right=angles.right + turned[0])
        at = case.state(np.asarray(free, complex), moved)
        tangents = FRAME.end_tangents(NO_MESH, case.model.load, moved, at, NOT_TURNING)
        return case.beam.internal_energy(at[3:], tangents)

    gain = complex_step(energy, [0.0])[0] * CLAMP.rate
    work = case.assembled(STILL, state)
    found = powers(case.model, STILL, case.masses, work, state, 0.0 * state)
    assert found.clamps == pytest.approx(gain, rel=1e-9)
    assert found.friction == found.damping == found.contact == 0.0


def test_inertia_and_weight_of_the_frame():
    heavy, light = Case(load=Gravity(20.0)), Case()
    state = heavy.state(heavy.arch())
    drift = np.zeros_like(state)
    drift[:3] = [-0.1, 0.2, 0.3]
    moving = heavy.on_the_frame(MOVING, state, position_predictor=state, velocity_predictor=drift)
    gained = moving - light.on_the_frame(MOVING, state, position_predictor=state)
    expected = -50.0 * drift[:3] * [FRAME.mass, FRAME.mass, FRAME.inertia]
    expected[1] += 20.0 * FRAME.mass
    np.testing.assert_allclose(gained, expected, rtol=1e-10)


@clamps
def test_ends_are_where_the_frame_holds_them(clamp):
    case = Case(clamp)
    state = case.state(case.arch(turn=0.4))
    for node, side, direction in (
        (state[3 : 3 + case.dofs], -1.0, 0.4 - case.angles.left),
        (state[-case.dofs :], 1.0, 0.4 + case.angles.right),
    ):
        x, y = side * FRAME.half_span - FRAME.offset, FRAME.mount_y
        c, s = np.cos(0.4), np.sin(0.4)
        mount = state[:2] + [c * x - s * y, s * x + c * y]
        expected = mount - side * case.offset * np.array([np.cos(direction), np.sin(direction)])
        np.testing.assert_allclose(node[:2], expected, atol=1e-14)
        if case.dofs == 3:
            assert node[2] == pytest.approx(case.beam.rotation_length() * direction)


@pytest.mark.parametrize("turn", [-3.0, -0.2, 0.0, 1.5])
def test_a_step_leaves_every_corner_its_share_of_gap(turn):
    rng = np.random.default_rng(3)
    model = Case(contact=BARRIER).model
    limited = 0
    for _ in range(200):
        state = np.array([0.0, 0.5 + rng.uniform(), turn])
        gaps = [corner(k, state)[1] for k in range(4)]
        if min(gaps) <= 0.0:
            continue
        drop = rng.normal(0.0, 1.0, 3)
        share = gap_safe_share(model, np.zeros(0), NO_MESH, state, drop, drop)
        assert 0.0 < share <= 1.0
        limited += share < 1.0
        after = state - share * drop
        for k, gap in enumerate(gaps):
            assert corner(k, after)[1] >= 0.15 * gap * (1.0 - 1e-12)
    assert limited > 20


def test_corner_velocity_is_the_derivative_of_its_place():
    state, velocity = np.array([0.1, 0.6, 0.3]), np.array([0.4, -0.2, 2.0])
    for k in range(4):
        moved = complex_step(lambda t, k=k: corner(k, state + t[0] * velocity, velocity)[0], [0.0])
        assert corner(k, state, velocity)[2] == pytest.approx(moved[0], rel=1e-12)
    corners = {tuple(np.round(corner(k, 0 * state, velocity)[:2], 12)) for k in range(4)}
    assert corners == {(x, y) for x in (-0.46, 0.34) for y in (-0.25, 0.25)}


@clamps
def test_centre_of_mass_weighs_frame_and_beam(clamp):
    case = Case(clamp)
    state, masses = case.state(case.arch()), case.masses
    x, y, vx, vy = centre_of_mass(case.model, masses, NO_MESH, state, 2.0 * state)
    total = FRAME.mass + masses.sum()
    beam_x, beam_y = (masses @ state[k :: case.dofs] for k in (3, 4))
    assert x == pytest.approx((FRAME.mass * state[0] + beam_x) / total, rel=1e-14)
    assert y == pytest.approx((FRAME.mass * state[1] + beam_y) / total, rel=1e-14)
    assert (vx, vy) == pytest.approx((2.0 * x, 2.0 * y))
