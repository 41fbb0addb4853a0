"""The jump: start, flight, books, gaps, monotony, the pinned baseline; mirrors and similarity."""

from dataclasses import replace

import numpy as np
import pytest
from families import FAMILIES
from physical import DESIGNS, jump, parts_of, run
from scaled import Factors, scaled

from snapjump import Design, Environment, ParameterError, Robot, simulate_jump
from snapjump.composition import with_tier
from snapjump.drive.constant_rate import ConstantRate
from snapjump.scenes.jump_start import critical, start_angle_rad
from snapjump.statics.critical import find_snap
from snapjump.stepping.adaptive import AdaptiveStep

TIGHT = AdaptiveStep(tolerance=1e-8, contact_steps=0.5)


@pytest.fixture(params=DESIGNS)
def jumped(request):
    """The jumps of four designs, one after the other."""
    return jump(**parts_of(DESIGNS[request.param]))


def test_no_gap_closes(jumped):
    arrays = jumped.arrays
    assert jumped.min_gap_m > 0.0
    assert arrays["corner_gap_m"].min() > 0.0
    assert arrays["node_gap_m"].min() > 0.0
    assert all(np.isfinite(values).all() for values in arrays.values())


def test_flight_is_ballistic(jumped):
    arrays = jumped.arrays
    # Lift-off is the end of the last step in contact; generalised alpha halves what it remembers of
    # that step's forces in each of the next.
    aloft = arrays["time_s"] > jumped.liftoff_time_s + 3e-4
    assert aloft.sum() > 5
    time = arrays["time_s"][aloft] - jumped.liftoff_time_s
    scale = jumped.liftoff_vy_m_s
    assert np.ptp(arrays["com_vx_m_s"][aloft]) < 1e-9 * scale
    assert np.ptp(arrays["com_vy_m_s"][aloft] + 10.0 * time) < 1e-9 * scale
    assert arrays["com_vx_m_s"][-1] == pytest.approx(jumped.liftoff_vx_m_s, abs=1e-9 * scale)
    fall = arrays["com_vy_m_s"][-1]
    apex_y = arrays["com_y_m"][-1] + fall**2 / 20.0
    apex_x = arrays["com_x_m"][-1] + arrays["com_vx_m_s"][-1] * fall / 10.0
    assert apex_y == pytest.approx(jumped.y_bar * 0.02, rel=1e-9)
    assert apex_x == pytest.approx(jumped.x_bar * 0.02, rel=1e-9)


def test_books_balance(jumped):
    simulation = jumped.simulation
    released = find_snap(
        simulation.robot, simulation.discretization, simulation.design.epsilon, 0.0
    )
    energy = (released.before.energy - released.after.energy) * simulation.robot.scales.energy_J
    loss = jumped.arrays["numerical_loss_J"]
    assert abs(loss[-1]) < 5e-3 * energy
    assert np.abs(loss).max() < 1e-2 * energy


def test_heavier_robots_jump_lower():
    heights = [jump(environment=Environment(0.3, m)).y_bar for m in (0.3, 0.5, 0.768, 1.2, 2.0)]
    assert all(np.diff(heights) < 0.0)


def test_beam_out_of_reach_of_the_ground():
    """A mount far above h2: the snap strikes nothing."""
    robot = Robot(mount_height=0.009)
    result = jump(robot=robot, allowed=("ok", "no_jump"))
    assert result.y_bar < 1.0
    strike = jump().y_bar
    assert result.y_bar < 0.05 * strike


@pytest.mark.parametrize("fraction", [0.7, 0.8])
def test_where_the_motion_starts_matters_little(fraction):
    """Measured with 64 elements at a tolerance of 1e-9, four designs: at most 0.1 %."""
    scene = FAMILIES["sim"]["jump"]
    near = jump(sim=scene(start_fraction=0.85), stepping=TIGHT)
    far = jump(sim=scene(start_fraction=fraction), stepping=TIGHT)
    assert far.x_bar == pytest.approx(near.x_bar, rel=5e-3)
    assert far.y_bar == pytest.approx(near.y_bar, rel=5e-3)


def test_baseline_is_pinned():
    result = simulate_jump()
    assert result.status == "ok"
    assert result.x_bar == pytest.approx(5.368, rel=0.005)
    assert result.y_bar == pytest.approx(14.265, rel=0.0015)


def test_lanes_give_the_same_jump():
    """backend=lanes: the program for batches, outcomes only."""
    alone = jump()
    wide = jump(backend="lanes")
    assert wide.x_bar == pytest.approx(alone.x_bar, rel=1e-13)
    assert wide.y_bar == pytest.approx(alone.y_bar, rel=1e-13)
    assert not wide.arrays and "max_residual" not in wide.summary


@pytest.mark.parametrize("name", ["corotational", "geometrically_exact"])
@pytest.mark.slow
def test_elements_with_rotations_jump_like_discrete_rods(name):
    """They agree within 1 % at 104 elements; books balance; lanes are scalars to the bit."""
    members = FAMILIES["discretization"]
    rod = simulate_jump(accuracy="draft", discretization=members["der"](elements=104))
    alone = simulate_jump(accuracy="draft", discretization=members[name](elements=104))
    assert alone.status == "ok"
    assert alone.x_bar == pytest.approx(rod.x_bar, rel=0.01)
    assert alone.y_bar == pytest.approx(rod.y_bar, rel=0.01)
    loss = alone.arrays["numerical_loss_J"]
    assert np.abs(loss).max() < 5e-3 * alone.arrays["elastic_J"].max()
    wide = simulate_jump(
        accuracy="draft", discretization=members[name](elements=104), backend="lanes"
    )
    assert (wide.x_bar, wide.y_bar) == (alone.x_bar, alone.y_bar)
    assert wide.summary["newton_iterations"] == alone.summary["newton_iterations"]


def test_equal_clamps_jump_straight_up():
    result = jump(design=Design(0.2, 0.0))
    assert abs(result.x_bar) <= 1e-8
    assert np.abs(result.arrays["frame_angle_rad"]).max() < 1e-8


@pytest.mark.parametrize("slope", [0.0, 0.15])
def test_mirrored_mismatch_and_slope_mirror_the_jump(slope):
    """The left clamp is the reference: the mirror image starts and ends that much earlier.

    The elimination runs from left to right, so that the two differ by rounding, and adaptive
    steps raise that to a share of their tolerance.
    """
    lag = 0.1
    uphill, downhill = (Environment(slope_rad=sign * slope) for sign in (1.0, -1.0))
    right = jump(design=Design(0.2, lag), environment=uphill, stepping=TIGHT)
    left = jump(
        design=Design(0.2, -lag),
        environment=downhill,
        drive=ConstantRate(end_rad=1.5 - lag),
        stepping=TIGHT,
    )
    assert left.x_bar == pytest.approx(-right.x_bar, rel=1e-3)
    assert left.y_bar == pytest.approx(right.y_bar, rel=1e-4)
    assert left.x_world_bar == pytest.approx(-right.x_world_bar, rel=1e-3)


def test_without_friction_nothing_moves_sideways():
    result = jump(environment=Environment(mu=0.0))
    assert np.abs(result.arrays["com_vx_m_s"]).max() < 1e-10 * result.liftoff_vy_m_s


def test_similarity():
    """E, rho and L scaled at fixed dimensionless groups change nothing.

    By powers of two, so that rounding is the same: else adaptive steps raise it to 1e-3 here.
    """
    baseline = jump()
    larger = run(scaled(baseline.simulation, Factors(length=2.0, time=8.0, mass=32.0)))
    assert larger.x_bar == pytest.approx(baseline.x_bar, rel=1e-6)
    assert larger.y_bar == pytest.approx(baseline.y_bar, rel=1e-6)
    assert larger.apex_time_s == pytest.approx(8.0 * baseline.apex_time_s, rel=1e-6)


BASE = with_tier("draft")


@pytest.mark.parametrize("lag", [0.0, 0.05, 0.3])
def test_mirrored_designs_start_mirrored(lag):
    leads, lags = (
        replace(BASE, design=Design(epsilon=0.1, delta_alpha=sign * lag)) for sign in (1.0, -1.0)
    )
    left = start_angle_rad(leads)
    right = start_angle_rad(lags) + lag
    assert right == pytest.approx(left, rel=1e-14)


def critical_of(epsilon, elements):
    mesh = replace(BASE.discretization, elements=elements)
    return critical(replace(BASE, design=Design(epsilon=epsilon), discretization=mesh))


@pytest.mark.parametrize(("epsilon", "elements"), [(1e-5, 56), (1e-5, 8), (1.5e-5, 104)])
def test_what_does_not_buckle_is_refused(epsilon, elements):
    with pytest.raises(ParameterError, match=r"design\.epsilon = .*buckles"):
        critical_of(epsilon, elements)


def test_a_mesh_that_shows_no_snap_is_blamed_itself():
    thin = replace(
        BASE,
        robot=replace(BASE.robot, thickness_m=5e-6),
        design=Design(1e-3),
        environment=Environment(mass_bar=10.0),
    )
    mesh = replace(BASE.discretization, elements=8)
    with pytest.raises(ParameterError, match=r"discretization\.elements = 8 .* 56 elements"):
        critical(replace(thin, discretization=mesh))


def test_what_snaps_on_no_mesh_is_the_design():
    thick = replace(BASE, robot=replace(BASE.robot, thickness_m=5e-4), design=Design(0.01))
    with pytest.raises(ParameterError, match=r"design\.epsilon = 0\.01 .*snaps back"):
        critical(thick)


@pytest.mark.parametrize("epsilon", [0.01, 0.07, 0.1, 0.4])
def test_eight_elements_snap_where_a_mesh_so_coarse_does(epsilon):
    """Too early, by an error of second order: the coarsest mesh has its own threshold."""
    eight, twelve, many = (critical_of(epsilon, n).alpha_rad for n in (8, 12, 104))
    assert 0.80 * many < eight < twelve < many
    assert (many - eight) / (many - twelve) == pytest.approx((12 / 8) ** 2, rel=0.3)
