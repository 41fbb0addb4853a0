"""The elastic frame: forces against its energy, the solver against a dense exact tangent.

All of it is about one small robot, ``Case``, hence one file of more than 250 lines.
"""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from plain_python import assembled, complex_step, plain_work, residual_of

from snapjump.checks import ParameterError
from snapjump.composition import Simulation, with_tier
from snapjump.damping.kelvin_voigt import KelvinVoigt
from snapjump.damping.none import NoDamping
from snapjump.declare.members import member_names
from snapjump.discretization.base import NodeMotion
from snapjump.discretization.der import DiscreteElasticRod
from snapjump.drive.constant_rate import ConstantRate
from snapjump.engine.assemble import Motion
from snapjump.engine.centre_of_mass import centre_of_mass
from snapjump.engine.gaps import gap_safe_share
from snapjump.engine.linearised import solve_linearised
from snapjump.engine.powers import powers
from snapjump.frame.base import STILL
from snapjump.frame.elastic import ElasticFrame
from snapjump.frame.parts.elastic_chain import add_chain_forces
from snapjump.frame.parts.elastic_mesh import right_mount
from snapjump.frame.rigid import RigidFrame
from snapjump.friction.none import NoFriction
from snapjump.scenes.frame_body import frame_model
from snapjump.scenes.jump_start import jump_model
from snapjump.scenes.resting import resting_guess

OPTIONS = ElasticFrame(30.0, 2.0, 6, 5, inset_m=3e-4)
MOVING = Motion(0.2, 50.0, 50.0, 0.0)
REST = Motion(0.0, 0.0, 0.0, 0.0)
FLAT = ConstantRate.Law(0.0, 1.0, 1.0, 0.0).angles(0.0)
STANDING = ConstantRate.Law(0.35, 1.5, 0.0, 0.1)
clamps = pytest.mark.parametrize("clamp", ["half_element", "two_nodes"])


def small_robot(clamp: str = "half_element", **frame: Any) -> Simulation:
    base = with_tier("draft", discretization=DiscreteElasticRod(10, clamp))
    return replace(base, frame=replace(OPTIONS, **frame))


class Case:
    """A robot of few nodes, its clamps turned, in a bent and tilted state."""

    def __init__(self, simulation: Simulation, **members: Any):
        clamp = ConstantRate.Law(0.35, 1.5, 0.6, 0.1)
        usual = {"clamp": clamp, "friction": NoFriction.Law(), "damping": NoDamping.Law()}
        self.model = jump_model(simulation)._replace(**(usual | members))
        self.masses = simulation.discretization.masses()
        self.mesh = simulation.frame.mesh(self.model.frame)
        self.dofs = int(self.mesh[0])
        rng = np.random.default_rng(3)
        state = resting_guess(simulation, self.model)
        state = state + 2e-4 * rng.uniform(-1.0, 1.0, len(state))
        self.keep = np.r_[0 : self.dofs, self.dofs + 2 : len(state) - 2]
        turn = np.array([[1.0, 0.004], [-0.004, 1.0]])
        self.free = np.ravel(state.reshape(-1, 2) @ turn)[self.keep]
        self.origin = self.state(self.free)

    def state(self, free: Any, time: float = 0.0) -> Any:
        state = np.zeros(len(free) + 4, np.asarray(free).dtype)
        state[self.keep] = free
        angles = self.model.clamp.angles(time)
        self.model.frame.place_ends(self.mesh, self.model.discretization, angles, state)
        return state

    def tangents(self, state: Any, angles: Any = FLAT) -> Any:
        frame, load = self.model.frame, self.model.load
        return frame.end_tangents(self.mesh, load, angles, state, STILL)

    def memory(self, model: Any, motion: Motion, state: Any, **arrays: Any) -> Any:
        """That of an assembly from the origin, or from ``arrays`` that are given."""
        given = {"position_predictor": self.origin, **arrays}
        return assembled(model, motion, self.masses, state, self.mesh, **given)[1]

    def residual(self, free: Any, motion: Motion) -> Any:
        work = self.memory(self.model, motion, self.state(free, motion.time))
        return residual_of(work, self.dofs)[self.keep]


@clamps
@pytest.mark.parametrize("contact", ["nodes", "corners"])
def test_residual_is_the_gradient_of_the_whole_energy(clamp, contact):
    case = Case(small_robot(clamp, contact=contact))
    model, mesh, dofs = case.model, case.mesh, case.dofs
    angles = model.clamp.angles(0.0)

    def potential(z):
        state = case.state(z)
        tangents = case.tangents(state, angles)
        energy = model.discretization.internal_energy(state[dofs:], tangents)
        energy = energy + model.frame.energy(mesh, state)
        fall = model.load.acceleration
        for k in range(0, dofs, 2):
            energy = energy + fall * model.frame.mass_of(mesh, k) * state[k + 1]
            weight = model.frame.point_share(mesh, k // 2, model.ground)
            if state[k + 1].real < model.contact.distance:
                energy = energy + weight * model.contact.energy(state[k + 1])
        return energy + fall * (case.masses @ state[dofs + 1 :: 2])

    expected = complex_step(potential, case.free)
    actual = case.residual(case.free, REST)
    np.testing.assert_allclose(actual, expected, rtol=0.0, atol=1e-9 * np.abs(expected).max())


@clamps
@pytest.mark.parametrize("damping", [NoDamping.Law(), KelvinVoigt.Law(1e-3)])
def test_solution_of_the_linearised_system(clamp, damping):
    """Elimination of the beam, mounts, band and border against a dense, exact tangent."""
    case = Case(small_robot(clamp), damping=damping, clamp=STANDING)
    matrix = complex_step(lambda z: case.residual(z, MOVING), case.free)
    np.testing.assert_allclose(matrix, matrix.T, rtol=0.0, atol=1e-9 * np.abs(matrix).max())
    expected = np.linalg.solve(matrix, case.residual(case.free, MOVING))
    work = plain_work(case.model, len(case.masses), mesh=case.mesh)
    work.state[:] = work.position_predictor[:] = case.origin
    solution = solve_linearised(case.model, MOVING, case.masses, work)
    actual = np.concatenate([work.frame_residual, work.residual])[case.keep]
    np.testing.assert_allclose(actual, expected, rtol=0.0, atol=1e-8 * np.abs(expected).max())
    assert solution.negative_pivots == (np.linalg.eigvalsh(matrix) < 0.0).sum()
    assert solution.correction == pytest.approx(np.abs(expected).max(), rel=1e-6)


def test_mounts_turn_with_their_edges():
    case = Case(small_robot())
    state = case.origin
    vector = np.random.default_rng(1).normal(size=len(state))

    def directions(t):
        tangents = case.tangents(state + t[0] * vector)
        return np.array([tangents.left_y / tangents.left_x, tangents.right_y / tangents.right_x])

    slopes = complex_step(directions, [0.0]).ravel()
    values = directions([0.0])
    turning = case.model.frame.mount_rotations(case.mesh, state, vector)
    np.testing.assert_allclose(turning, slopes / (1.0 + values**2), rtol=1e-10)


def test_material_damping_takes_out_the_power_of_its_forces():
    case = Case(small_robot(), damping=KelvinVoigt.Law(1e-3), clamp=STANDING)
    motion = MOVING._replace(time=0.0)
    rng = np.random.default_rng(2)
    state = case.state(case.free + 1e-6 * rng.normal(size=len(case.free)))
    velocity = (state - case.origin) * motion.rate_factor
    undamped = case.model._replace(damping=NoDamping.Law())
    # Without inertia.
    damped, undamped = (
        case.memory(model, motion, state, velocity_predictor=velocity)
        for model in (case.model, undamped)
    )
    force = residual_of(damped, case.dofs) - residual_of(undamped, case.dofs)
    found = powers(case.model, motion, case.masses, damped, state, velocity)
    assert found.damping == pytest.approx(force[case.keep] @ velocity[case.keep], rel=1e-4)


def test_mass_outline_and_centre_are_the_rigid_frame_s():
    simulation = small_robot()
    case = Case(simulation)
    frame = case.model.frame
    rigid = frame_model(replace(simulation, frame=RigidFrame()), frame.mount_y)
    state = resting_guess(simulation, case.model)
    masses = [frame.mass_of(case.mesh, k) for k in range(0, case.dofs, 2)]
    assert sum(masses) == pytest.approx(rigid.mass, rel=1e-12)
    box = frame.box(case.mesh, state, 0.0 * state)
    assert (box.cosine, box.sine) == (1.0, 0.0)
    assert box.top_y - box.foot_y == pytest.approx(0.5)
    assert box.mount_y - box.foot_y == pytest.approx(frame.mount_y)
    no_beam = 0.0 * case.masses
    x, y, _, _ = centre_of_mass(case.model, no_beam, case.mesh, state, state)
    assert x == pytest.approx(0.0, abs=1e-14)
    # Clamped masses hang at the mounts' edges in both.
    assert y - state[1] == pytest.approx(-rigid.foot_y, rel=1e-12)


def test_an_even_mesh_rounds_the_mount_to_an_edge_s_middle():
    frame = Case(small_robot(mount="edge_middle")).model.frame
    edge = 0.5 / OPTIONS.leg_elements
    assert (frame.low_length, frame.high_length) == pytest.approx((edge, edge))
    assert frame.mount_y / edge % 1.0 == pytest.approx(0.5)


def test_no_node_falls_below_its_share_of_the_gap():
    case = Case(small_robot())
    state = case.origin
    drop = np.zeros(len(state))
    drop[1] = 4.0 * state[1]
    share = gap_safe_share(case.model, case.masses, case.mesh, state, drop, drop[case.dofs :])
    assert state[1] - share * drop[1] == pytest.approx(0.15 * state[1])


def test_a_clamp_that_does_not_follow_its_leg_turns_with_the_mounts_line():
    """Only the right tangent changes; a share of one is the mount's own edge."""
    all_of_it, none = (Case(small_robot(right_follow=share)) for share in (1.0, 0.0))
    state = all_of_it.origin
    with_leg, without = (case.tangents(state) for case in (all_of_it, none))
    assert without[:3] == with_leg[:3]
    first, last = (2 * int(edge) for edge in (all_of_it.mesh[1], right_mount(all_of_it.mesh)))
    middle = [0.5 * (state[i : i + 2] + state[i + 2 : i + 4]) for i in (first, last)]
    line = middle[1] - middle[0]
    angle = np.arctan2(line[1], line[0])
    assert np.arctan2(without.right_y, without.right_x) == pytest.approx(angle, abs=1e-6)
    assert np.arctan2(with_leg.right_y, with_leg.right_x) != pytest.approx(angle, abs=1e-6)


def test_the_beam_s_mass_on_top_of_the_robot_s():
    rest, on_top = (small_robot(beam_on_top=value) for value in (False, True))
    frames = [jump_model(s).frame for s in (rest, on_top)]
    assert frames[1].mass - frames[0].mass == pytest.approx(1.0, rel=1e-12)


@pytest.mark.parametrize("name", [n for n in member_names("discretization") if n != "der"])
def test_elements_with_rotations_are_refused_by_name(name):
    with pytest.raises(ParameterError, match="der with frame=elastic"):
        replace(small_robot(), discretization=name)


def test_an_inset_beyond_the_beam_s_compression_is_refused():
    with pytest.raises(ParameterError, match=r"frame.inset_m = 0.003 .* \[0, 0.002\] m"):
        jump_model(small_robot(inset_m=3e-3))


def test_the_legs_open_like_beams_under_a_thrust_between_the_mounts():
    """P (2 a^3/3 + a^2 w)/B: two cantilevers of length a and the top w that bends with them."""
    bending = 1000.0
    simulation = small_robot(
        bending_ratio=bending, stretching_ratio=10.0, leg_elements=24, top_elements=20, inset_m=0.0
    )
    frame = jump_model(simulation).frame
    mesh = simulation.frame.mesh(frame)
    dofs = int(mesh[0])
    rest = np.zeros(dofs)
    frame.rest(mesh, rest, 1.0)

    def gradient(state):
        residual = np.zeros(dofs, state.dtype)
        band = np.zeros((dofs, 6), state.dtype)
        add_chain_forces(
            frame, mesh, NoDamping.Law(), NodeMotion(state, state, 0.0), residual, band
        )
        return residual

    assert np.abs(gradient(rest)).max() < 1e-13 * frame.stretching / frame.low_length
    stiffness = complex_step(gradient, rest)
    # Three rigid motions, and nothing else, cost no energy.
    assert (np.linalg.eigvalsh(stiffness) < 1e-4 * bending).sum() == 3
    thrust = np.zeros(dofs)
    left, right = 2 * int(mesh[1]), 2 * int(right_mount(mesh))
    thrust[[left, left + 2]], thrust[[right, right + 2]] = -0.5, 0.5
    moved = np.linalg.pinv(stiffness, rcond=1e-13, hermitian=True) @ thrust
    a, w = frame.top_y - frame.mount_y, 2.0 * frame.half_span
    # A corner's hinge gives a quarter of what its length of beam would (see elastic_chain).
    corner = 0.5 * (frame.high_length + frame.top_length)
    expected = (2.0 / 3.0 * a**3 + a * a * (w - 1.5 * corner)) / bending
    assert thrust @ moved == pytest.approx(expected, rel=0.01)
