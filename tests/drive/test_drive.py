import pytest

from snapjump.drive.constant_rate import ConstantRate
from snapjump.drive.smooth_start import SmoothStart

CONSTANT = ConstantRate.Law(0.4, 1.5, 0.09, 0.1, 1.0)
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
