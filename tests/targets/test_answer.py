"""What can be reached is reached, what cannot be is answered with the nearest apex."""

from dataclasses import replace

import numpy as np
import pytest
from made_up_maps import HEIGHT, SLOPE, MadeUpModel, MadeUpSimulator, problem, straight

from snapjump.inverse.finite_difference import FiniteDifferenceOptions
from snapjump.inverse.gauss_newton import GaussNewtonOptions
from snapjump.targets.answer import BOUNDARY_BAR, answer

HIGH = 0.3 * HEIGHT
CORNER = np.array([0.19 * SLOPE * HIGH, HIGH])


def test_a_target_that_can_be_reached():
    given = problem([5.0, 10.0], MadeUpModel())
    found = answer(given, GaussNewtonOptions())
    assert found.reachable and found.simulations == 0 and 0.0 < found.seconds < 1.0
    controls = found.solutions[0].controls
    np.testing.assert_allclose(controls, [0.5 / SLOPE, 10.0 / HEIGHT], rtol=1e-6)


def test_a_target_that_cannot_be_reached():
    given = problem(CORNER + [1.0, 2.0], MadeUpModel())
    found = answer(given, FiniteDifferenceOptions())
    assert not found.reachable and len(found.solutions) == 1
    np.testing.assert_allclose(found.solutions[0].controls, [0.19, 0.3], rtol=1e-9)
    np.testing.assert_allclose(found.solutions[0].apex, CORNER, rtol=1e-9)
    assert found.simulations == 0


@pytest.mark.parametrize(("beyond", "reachable"), [(0.9, True), (1.1, False)])
def test_a_target_on_the_boundary(beyond, reachable):
    """The forward model's own error is not held against it."""
    given = problem([5.0, HIGH + beyond * BOUNDARY_BAR], MadeUpModel())
    found = answer(given, GaussNewtonOptions())
    assert found.reachable == reachable
    assert found.solutions[0].controls[1] == pytest.approx(0.3)


def test_without_a_forward_model_the_miss_decides():
    target = straight(np.array([[0.07, 0.2, 3.0, 0.3]]))[0]
    given = problem(target, None, MadeUpSimulator(), mass_bar=3.0)
    method = FiniteDifferenceOptions()
    found = answer(given, method)
    assert found.reachable and found.simulations == given.simulator.simulations > 0
    assert not answer(replace(given, target=target + 20.0), method).reachable
