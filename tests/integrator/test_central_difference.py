"""The stable step that explicit steps are held to: the matrix of a step on either side of it."""

import math
from types import SimpleNamespace

import numpy as np
import pytest
from bare_models import loose_nodes
from integration import MASSES, Pull, amplification, amplified

from snapjump.engine.explicit import slave_acceleration
from snapjump.friction.implicit import ImplicitFriction

# Shares of the bound, h^2 k + 4 h c = 4 m, and on which side of it they are.
SIDES = ((0.99, True), (1.01, False))


@pytest.mark.parametrize("damped", [0.0, 0.1, 0.38, 0.5, 0.9, 0.99, 1.0])
def test_explicit_steps_are_stable_up_to_the_step_that_is_allowed(damped):
    """Of the bound so much is the damping's: all of it, that of a force of the velocity alone."""
    for share, stable in SIDES:
        omega_h, drag = math.sqrt(4.0 * share * (1.0 - damped)), share * damped
        roots, stable_step = amplification("central_difference", omega_h, drag)
        assert stable_step == pytest.approx(share**-0.5)
        assert (np.abs(roots).max() <= 1.0 + 1e-6) == stable


def test_an_explicit_step_is_held_to_what_sticking_friction_bears():
    """Friction at rest damps like c = 2 mu f / eps_v."""
    mu, width = 0.3, 1e-3
    for share, stable in SIDES:
        weight = 0.5 * share * MASSES[0] * width / mu
        pressed = Pull(lambda y, weight=weight: -weight)
        model = loose_nodes(contact=pressed, friction=ImplicitFriction.Law(mu, width))
        roots, stable_step = amplified("central_difference", model, 0, 1e-9 * width)
        assert stable_step == pytest.approx(share**-0.5, rel=1e-6)
        assert (np.abs(roots).max() <= 1.0 + 1e-6) == stable


def test_the_velocity_of_what_moves_with_a_clamp_does_not_alternate():
    """An error of it dies out, and what remains is the motion's change in a step."""
    rate, pull, time = 3.0, 7.0, 0.0
    velocity, acceleration = rate + 5.0, pull - 900.0  # far from what they should be
    for count in range(60):
        step = 1e-2 * (1.0 + 0.5 * (-1) ** count)
        start, end = (rate * t + 0.5 * pull * t * t for t in (time, time + step))
        work = SimpleNamespace(
            state=[end], start=[start], velocity=np.array([[velocity]]),
            acceleration=np.array([[acceleration]]),
        )  # fmt: skip
        new = slave_acceleration(work, 0, step)
        velocity += 0.5 * step * (acceleration + new)
        acceleration, time = new, time + step
    assert abs(velocity - (rate + pull * time)) < pull * 0.015
    assert abs(acceleration - pull) < 5.0 * pull
