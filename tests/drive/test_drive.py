import math

import numpy as np
import pytest
from command_line import here

from snapjump.batch import simulate_batch, simulate_designs
from snapjump.checks import ParameterError
from snapjump.composition import Simulation, with_tier
from snapjump.drive.constant_rate import ConstantRate
from snapjump.drive.hold_release import HoldRelease
from snapjump.drive.parts.two_rates import TwoRates
from snapjump.drive.smooth_start import SmoothStart
from snapjump.drive.unload import Unload
from snapjump.run.tasks.command_line import EXIT_BAD_INPUT
from snapjump.simulation import build, simulate
from snapjump.statics.arch import StaticArch
from snapjump.statics.critical import find_snap

CONSTANT = ConstantRate.Law(0.4, 1.5, 0.09, 0.1)
SMOOTH = SmoothStart.Law(0.4, 1.5, 0.09, 0.1, 1.0, 2.0)
programmes = pytest.mark.parametrize("clamp", [CONSTANT, SMOOTH])


@programmes
@pytest.mark.parametrize("time", [0.3, 2.0, 9.0])
def test_rates_are_derivatives_of_the_angles(clamp, time):
    angles = clamp.angles(time)
    step = 1e-4
    after, before = clamp.angles(time + step), clamp.angles(time - step)
    left = (after.left - before.left) / (2.0 * step)
    right = (after.right - before.right) / (2.0 * step)
    assert angles.left_rate == pytest.approx(left, rel=1e-7)
    assert angles.right_rate == pytest.approx(right, rel=1e-7)


@programmes
@pytest.mark.parametrize("time", [0.0, 3.0, 1e3])
def test_the_right_clamp_lags(clamp, time):
    angles = clamp.angles(time)
    assert angles.left - angles.right == pytest.approx(0.1, abs=1e-15)


@programmes
def test_begins_at_start_and_stops_at_end(clamp):
    assert clamp.angles(0.0).left == 0.4
    done = clamp.angles(1e3)
    assert (done.left, done.left_rate, done.right_rate) == (1.5, 0.0, 0.0)


def test_constant_rate_reaches_the_end_on_time():
    arrival = (1.5 - 0.4) / 0.09
    assert CONSTANT.angles(0.999 * arrival).left_rate == 0.09
    assert CONSTANT.angles(1.001 * arrival).left_rate == 0.0
    assert CONSTANT.angles(5.0).left == pytest.approx(0.85)


def test_smooth_start_begins_at_rest_and_becomes_a_late_constant_rate():
    assert SMOOTH.angles(0.0).left_rate == 0.0
    late = SMOOTH.angles(11.0)
    assert late.left_rate == pytest.approx(0.09, rel=5e-3)
    missing = 0.09 * 2.0 * 2.718281828459045**-5.5
    assert late.left == pytest.approx(CONSTANT.angles(9.0).left + missing, rel=1e-12)
    sudden = SMOOTH._replace(rise_time=1e-9)
    assert sudden.angles(3.0).left == pytest.approx(CONSTANT.angles(3.0).left, abs=1e-9)


UNLIKE = TwoRates(*CONSTANT, 0.25)


def test_clamps_with_rates_of_their_own_lag_at_the_beginning_and_stop_together():
    begun, later, done = (UNLIKE.angles(time) for time in (0.0, 5.0, 1e3))
    assert begun.right == pytest.approx(0.3) and begun.right_rate == pytest.approx(0.0225)
    assert later.right == pytest.approx(0.3 + 5.0 * 0.0225)
    assert done.right == pytest.approx(0.3 + 0.25 * 1.1) and done.right_rate == 0.0
    drive = ConstantRate(rate_rad_s=20.0, right_rate_rad_s=-5.0)
    assert drive.programme(Simulation(), 0.0).right_share == -0.25


def test_robots_beside_each_other_all_have_a_right_rate_or_none():
    both = [with_tier("draft", drive=ConstantRate(right_rate_rad_s=r)) for r in (None, 10.0)]
    with pytest.raises(ParameterError, match="drive = 'constant_rate' .* given or null"):
        simulate_batch(both)


def test_a_span_opens_and_its_clamps_keep_their_angles():
    one = Simulation(sim="snap", drive=Unload(angle_rad=0.5, end_epsilon=0.05))
    law, scales = one.drive.programme(one, 0.0), one.robot.scales
    begun, later, done = (law.angles(time) for time in (0.0, 4.0, 1e6))
    assert (begun.apart, begun.apart_rate) == (0.0, 0.0)
    assert (later.left, later.right, later.left_rate) == (0.5, pytest.approx(0.4), 0.0)
    assert (done.apart, done.apart_rate) == (pytest.approx(0.15), 0.0)
    ahead, behind = (law.angles(4.0 + way).apart for way in (1e-5, -1e-5))
    assert later.apart_rate == pytest.approx((ahead - behind) / 2e-5, rel=1e-7)
    assert law.rate == pytest.approx(0.1 / scales.velocity_m_s)


@pytest.mark.parametrize(
    ("key", "told"),
    [
        ("robot.rotation_rate_rad_s", "drive.rate_rad_s now"),
        ("robot.rotation_end_rad", "drive.end_rad now"),
        ("sim.rise_time_s", "drive.rise_time_s now"),
    ],
)
def test_old_keys_are_told_their_new_names_and_kept_ones_are_read(key, told, tmp_path):
    assert told in here(tmp_path, f"{key}=0.5", "figures=false", code=EXIT_BAD_INPUT).stderr
    group, _, name = key.partition(".")
    scene = {"name": "snap" if group == "sim" else "jump"}
    kept = build({"sim": scene, **{group: {**(scene if group == "sim" else {}), name: 0.5}}})
    assert getattr(kept.drive, told.split()[0].rpartition(".")[2]) == 0.5


def test_refusals():
    with pytest.raises(ParameterError, match="drive = 'unload' .* with sim=jump"):
        Simulation(drive="unload")
    with pytest.raises(ParameterError, match="drive = 'hold_release' .* with sim=static"):
        Simulation(sim="static", drive="hold_release")
    with pytest.raises(ParameterError, match="drive.end_epsilon = 0.3 .* below design.epsilon"):
        Simulation(sim="snap", drive=Unload(end_epsilon=0.3))


def snapped(drive, **scene):
    steps = {"name": "adaptive", "tolerance": 1e-7}
    scene = {"name": "snap", **scene}
    one = with_tier("standard", sim=scene, drive=drive, design=MISMATCHED, stepping=steps)
    result = simulate(one)
    assert result.status == "ok"
    return one, result.summary


MISMATCHED = {"epsilon": 0.2, "delta_alpha": 0.15}


@pytest.mark.compiles
def test_a_span_that_opens_slowly_snaps_the_arch_where_statics_does():
    """And what the clamps then do is in the ledger."""
    slow = Unload(angle_rad=0.6, rate_m_s=0.005, end_epsilon=0.05)
    one, found = snapped(slow, duration_s=0.8, sample_interval_s=1e-4)
    opened = one.drive.programme(one, 0.0).angles(found["snap_time_s"] / one.robot.scales.time_s)

    def missing(epsilon):
        snap = find_snap(one.robot, one.discretization, epsilon, MISMATCHED["delta_alpha"])
        return snap.alpha_rad - slow.angle_rad

    low, high = 0.05, 0.2
    for _ in range(20):
        middle = 0.5 * (low + high)
        low, high = (low, middle) if missing(middle) > 0.0 else (middle, high)
    # The delay behind the fold opens the span a little further.
    delay = low - (0.2 - opened.apart)
    assert 0.0 < delay < 0.01 * low
    assert abs(found["numerical_loss_share"]) < 2e-3
    arch = StaticArch(one.robot, one.discretization, 0.2)
    energy_J = one.robot.scales.energy_J
    begun = arch.equilibrium(slow.rest(one, arch), 0.6, 0.45).energy * energy_J
    assert -begun < found["clamp_work_J"] < 0.0


@pytest.mark.compiles
def test_an_arch_is_the_slower_the_less_it_is_beyond_its_fold():
    """Without damping the time goes with the distance to the power -1/4 (Gomez and others)."""
    times = []
    for beyond in (4e-4, 4e-3):
        _, found = snapped(HoldRelease(beyond_rad=beyond))
        times.append(found["snap_time_s"])
        assert found["clamp_work_J"] == pytest.approx(0.0, abs=1e-12)
    assert -0.5 < math.log10(times[1] / times[0]) < -0.2


@pytest.mark.slow
def test_jumps_of_clamps_that_are_driven_otherwise():
    """At rest in the beginning a jump is little another; with one clamp still it is thrown aside.
    In lanes they are what they are alone."""
    rows = [[0.1, 0.2, 0.768, 0.3], [0.0, 0.15, 1.2, 0.4]]

    def apexes(drive, lanes=8):
        batch = simulate_designs(with_tier("draft", drive=drive), rows, threads=1, lanes=lanes)
        assert batch.status == ["ok", "ok"]
        return batch.apexes

    usual, smooth = apexes("constant_rate"), SmoothStart(rise_time_s=1e-4)
    assert np.allclose(apexes(smooth), usual, rtol=0.05)
    assert np.array_equal(apexes(smooth), apexes(smooth, lanes=1))
    still = apexes(ConstantRate(right_rate_rad_s=0.0))
    assert np.all(np.abs(still[1] - usual[1]) > 0.5)
    alike = apexes(ConstantRate(right_rate_rad_s=20.0))
    assert np.array_equal(alike, usual)
