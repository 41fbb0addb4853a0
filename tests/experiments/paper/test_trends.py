"""Which way curves run, and where they level off."""

import numpy as np
import pytest

from experiments.trends import (
    between,
    counter_step,
    fit_saturating,
    plateau,
    power,
    relative_range,
    saturating,
    straight_line,
)


def test_counter_step():
    assert counter_step(np.array([0.0, 1.0, 2.0]), rising=True) == 0.0
    assert counter_step(np.array([0.0, 3.0, 2.0, 4.0]), rising=True) == pytest.approx(0.25)
    assert counter_step(np.array([4.0, 1.0, 2.0, 0.0]), rising=False) == pytest.approx(0.25)
    assert counter_step(np.array([2.0, 1.0]), rising=True) == np.inf


def test_plateau():
    places = np.linspace(0.0, 1.0, 51)
    found = plateau(places, 3.0 * np.minimum(places, 0.4) + 2.0)
    assert found.threshold == pytest.approx(0.4)
    assert found.slope_before == pytest.approx(3.0)
    assert found.level == pytest.approx(3.2)
    assert found.levelling < 1e-9 and found.relative_swing < 1e-9

    straight = plateau(places, places)
    assert straight.levelling == pytest.approx(1.0)
    waves = plateau(places, np.minimum(places, 0.4) + 0.02 * np.sin(40.0 * places))
    assert waves.swing == pytest.approx(0.04, rel=0.2)


def test_saturating_law_and_its_fit():
    places = np.logspace(-6, -2, 25)
    values = saturating(places, 600.0, 1e-3)
    assert fit_saturating(places, values) == pytest.approx((600.0, 1e-3))
    assert values[0] == pytest.approx(600.0 * places[0], rel=1e-5)
    assert values[-1] == pytest.approx(0.6, rel=0.01)


def test_between():
    places = np.array([0.0, 1.0, 2.0, 3.0])
    assert between(places, places**2, 0.5, 2.5) == pytest.approx([0.5, 1.0, 4.0, 6.5])


def test_straight_line():
    places = np.linspace(0.1, 0.3, 21)
    line = straight_line(places, 80.0 * places - 1.0)
    assert (line.slope, line.intercept) == (pytest.approx(80.0), pytest.approx(-1.0))
    assert line.deviation_percent < 1e-9 and line.at(places)[0] == pytest.approx(7.0)
    places = np.linspace(0.01, 0.3, 30)
    assert straight_line(places, 80.0 * places + 25.0 * places**2).worst_place == 0.01


def test_power_law_and_range():
    places = np.linspace(0.3, 2.0, 18)
    assert power(places, 3.0 * places**-0.7) == pytest.approx(-0.7)
    assert relative_range(np.array([9.0, 10.0, 11.0])) == pytest.approx(0.2)
