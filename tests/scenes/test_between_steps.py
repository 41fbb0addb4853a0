"""Values between steps, against functions that are known everywhere."""

import numpy as np
import pytest

from snapjump.scenes.between_steps import at, crossing, peak

TIMES = np.array([0.0, 0.3, 0.5, 0.9, 1.0, 1.4])


def test_a_crossing_is_that_of_a_cubic_through_uneven_steps():
    root = 0.7
    values = (root - TIMES) * (1.0 + 0.2 * TIMES**2)
    assert crossing(TIMES, values) == pytest.approx(root, abs=1e-12)
    assert np.isnan(crossing(TIMES, np.ones(6)))


def test_the_first_fall_and_the_last_one():
    times = np.linspace(0.0, 9.0, 400)
    assert crossing(times, np.cos(times)) == pytest.approx(0.5 * np.pi, abs=1e-6)
    assert crossing(times, np.cos(times), which=-1) == pytest.approx(2.5 * np.pi, abs=1e-6)


def test_a_value_is_that_of_a_cubic():
    values = TIMES**3 - TIMES
    for moment in (0.0, 0.31, 0.5, 0.95, 1.4):
        assert at(TIMES, values, moment) == pytest.approx(moment**3 - moment, abs=1e-12)


def test_a_peak_is_that_of_a_parabola_through_uneven_steps():
    assert peak(TIMES, 4.0 - 3.0 * (TIMES - 0.6) ** 2) == pytest.approx(4.0, abs=1e-12)
    assert peak(TIMES, TIMES) == 1.4
    assert peak(TIMES, np.ones(6)) == 1.0
    assert np.isnan(peak(TIMES[:0], TIMES[:0]))


def test_the_largest_peak_may_lie_beside_another_step_than_the_largest():
    # The second wave is higher, but no step comes as near to its top as one to the first one's.
    times = np.arange(0.0, 9.0, 0.5)
    values = np.cos(times - 1.5) * (1.0 + 0.002 * times)
    assert np.argmax(values) == 3 and values[3] < 1.004
    assert peak(times, values) == pytest.approx(1.0 + 0.002 * (1.5 + 2.0 * np.pi), abs=3e-3)
    assert peak(times, values) > 1.01


def test_the_same_bits_every_time():
    """scipy's interpolator takes its nodes in an order by chance."""
    times = np.array([0.0, 0.1, 0.23, 0.31])
    found = {at(times, np.sin(7.0 * times), 0.17) for _ in range(50)}
    assert len(found) == 1
