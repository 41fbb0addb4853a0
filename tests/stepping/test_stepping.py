"""Which steps are accepted and what follows them; smaller tolerances are smaller errors."""

from dataclasses import replace

import numpy as np
import pytest

from experiments.designs import spread_designs
from experiments.errors import relative_errors
from snapjump.batch import simulate_batch, variants
from snapjump.composition import with_tier
from snapjump.robot.robot import Robot
from snapjump.stepping.adaptive import GROWTH, OVERSHOOT, SAFETY, SHRINKAGE, AdaptiveStep
from snapjump.stepping.fixed import FixedStep

TOLERANCE = 1e-6
ADAPTIVE = AdaptiveStep.Control(TOLERANCE, 2.0, 1e-3, 1e-9, 0.2, 0.1, 4.0)
FIXED = FixedStep.Control(1e-3, 1e-8)
ORDER = 3.0
FREE = 0.0  # contact rate of a robot in the air


def test_adaptive_accepts_what_is_accurate_and_resolved():
    assert ADAPTIVE.accepts(0.99 * TOLERANCE, 1e-3, FREE)
    assert not ADAPTIVE.accepts(1.01 * TOLERANCE, 1e-3, FREE)
    # A step may be longer than contact allows, as it may begin in the air: but not much.
    limit = OVERSHOOT * ADAPTIVE.contact_steps / 1e-3
    assert 1.0 <= OVERSHOOT <= 5.0
    assert ADAPTIVE.accepts(0.0, 1e-3, 0.99 * limit)
    assert not ADAPTIVE.accepts(0.0, 1e-3, 1.01 * limit)
    assert not ADAPTIVE.accepts(float("nan"), 1e-3, FREE)


@pytest.mark.parametrize("factor", [0.3, 0.7, 1.0, 1.6])
def test_adaptive_aims_a_little_below_the_step_that_meets_the_tolerance(factor):
    error = TOLERANCE * (1e-2 / (factor * 1e-2)) ** ORDER
    assert ADAPTIVE.next_step(error, ORDER, 1e-2, FREE) == pytest.approx(SAFETY * factor * 1e-2)


def test_adaptive_limits_growth_and_shrinkage():
    assert 0.0 < SHRINKAGE < SAFETY < 1.0 < GROWTH
    assert ADAPTIVE.next_step(0.0, ORDER, 1e-3, FREE) == pytest.approx(GROWTH * 1e-3)
    assert ADAPTIVE.next_step(1e3, ORDER, 1e-3, FREE) == pytest.approx(SHRINKAGE * 1e-3)
    assert ADAPTIVE.next_step(0.0, ORDER, 0.15, FREE) == 0.2


def test_adaptive_resolves_contact():
    assert ADAPTIVE.next_step(0.0, ORDER, 1e-3, 1e4) == pytest.approx(2e-4)
    assert ADAPTIVE.next_step(0.0, ORDER, 1e-3, 10.0) == pytest.approx(GROWTH * 1e-3)


def test_a_refused_step_is_repeated_shorter():
    error, step = 8.0 * TOLERANCE, 1e-3
    assert not ADAPTIVE.accepts(error, step, FREE)
    assert ADAPTIVE.next_step(error, ORDER, step, FREE) < step
    assert not ADAPTIVE.accepts(0.0, step, 1e4)
    assert ADAPTIVE.next_step(0.0, ORDER, step, 1e4) < step
    assert ADAPTIVE.step_after_failure(step) == pytest.approx(0.4 * step)


def test_fixed_step_is_halved_by_failures_and_grows_back():
    step = FIXED.first_step()
    assert step == 1e-3
    step = FIXED.step_after_failure(FIXED.step_after_failure(step))
    assert step == 2.5e-4
    # Neither errors nor contact matter.
    assert FIXED.accepts(1e9, step, 1e9)
    for longer in (5e-4, 1e-3, 1e-3):
        step = FIXED.next_step(1e9, 2.0, step, 1e9)
        assert step == longer


def test_bounds_and_tolerances():
    assert (ADAPTIVE.first_step(), ADAPTIVE.smallest_step()) == (1e-3, 1e-9)
    assert ADAPTIVE.newton_tolerance() == pytest.approx(1e-7)
    assert FIXED.smallest_step() == pytest.approx(1e-9)
    assert FIXED.newton_tolerance() == 1e-8


def test_a_scene_sets_the_range_of_steps_that_are_chosen():
    narrowed = ADAPTIVE.within(1e-150, 1e-2)
    assert (narrowed.smallest_step(), narrowed.largest) == (1e-150, 1e-2)
    assert narrowed.newton_tolerance() == ADAPTIVE.newton_tolerance()
    assert FIXED.within(1e-150, 1e-2) == FIXED


def test_options_are_in_seconds_and_shares_of_the_length():
    scales = Robot().scales
    fixed = FixedStep(1e-5).control(scales)
    assert fixed.step * scales.time_s == pytest.approx(1e-5)
    adaptive = AdaptiveStep(1e-5, 0.7).control(scales)
    assert (adaptive.tolerance, adaptive.contact_steps) == (1e-5, 0.7)
    assert adaptive.smallest < adaptive.first < adaptive.largest


TOLERANCES = (1e-5, 1e-6, 1e-7, 1e-8)


OTHERS = [pytest.param(name, marks=pytest.mark.slow) for name in ("tr_bdf2", "esdirk3")]


@pytest.mark.parametrize("name", ["generalized_alpha", *OTHERS])
def test_errors_fall_with_the_tolerance(name):
    """Median over sixteen designs against a far smaller tolerance, on one mesh."""
    base = with_tier("draft", integrator=name)
    designs = spread_designs(16)

    def jumps(tolerance):
        stepping = replace(base.stepping, tolerance=tolerance)
        batch = simulate_batch(variants(replace(base, stepping=stepping), designs))
        assert set(batch.status) == {"ok"}

        return batch.x_bar, batch.y_bar

    limit = jumps(1e-10)
    errors = [
        np.median(relative_errors(*jumps(tolerance), *limit), axis=1) for tolerance in TOLERANCES
    ]
    assert (np.diff(errors, axis=0) < 0.0).all(), errors
