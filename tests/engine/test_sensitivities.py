"""Derivatives of a jump against central differences of the same program, its steps frozen."""

import numpy as np
import pytest
from frozen_steps import adaptive_steps, apex, exact_jump, flight_of, march_along

from snapjump.batch import model_derivatives, prepare_designs
from snapjump.composition import with_tier
from snapjump.ending.flight import FlightEnding
from snapjump.ending.timed import TimedEnding
from snapjump.options.contact import LogBarrierOptions
from snapjump.options.discretization import DiscreteElasticRodOptions
from snapjump.options.friction import ImplicitFrictionOptions
from snapjump.options.stepping import AdaptiveStepOptions
from snapjump.scenes.resting import resting_guesses
from snapjump.scenes.runner import March
from snapjump.scenes.sensitivities import record_sensitivities
from snapjump.statics.threshold_curve import ThresholdCurve

# The kinks of friction, seldom at its true 1e-4 m/s, leave nothing of differences there.
SMOOTH = ImplicitFrictionOptions(velocity_threshold_m_s=1.0)
BASE = with_tier(
    "draft",
    discretization=DiscreteElasticRodOptions(16),
    stepping=AdaptiveStepOptions(2e-5, 2.0),
    contact=LogBarrierOptions(distance_m=1e-3),
    friction=SMOOTH,
)
DESIGNS = ((0.03, 0.15, 1.3, 0.25), (0.15, 0.18, 1.6, 0.2))
# Of the differences: rounding spoils the small one, a kink of the map within reach the large one.
STEPS = (1e-5, 3e-6)


@pytest.fixture(scope="module")
def curve():
    return ThresholdCurve.through(BASE.robot, BASE.discretization, 0.14, 0.21)


def jump_of(design, curve, base=BASE):
    """The march of one robot, its start found."""
    ready = prepare_designs(base, np.array([design]), curve)
    march = March(
        models=ready.models,
        masses=base.discretization.masses(),
        states=resting_guesses(ready.simulations, ready.models),
        simulation=base,
        ending=FlightEnding(base.sim.time_limit_s / base.robot.scales.time_s),
    )
    march.find_starts()
    return march


def differences(design, curve, steps, solutions, h, base=BASE):
    """Derivatives (4, 2) of the apex, by central differences of fourth order."""
    rows = []
    for k in range(4):
        total = np.zeros(2)
        for weight, count in ((8.0, 1), (-8.0, -1), (-1.0, 2), (1.0, -2)):
            other = np.array(design)
            other[k] += count * h
            jump = jump_of(other, curve, base)
            exact_jump(jump, steps, solutions)
            total += weight * apex(jump)
        rows.append(total / (12.0 * h))
    return np.array(rows)


def derivatives(design, curve, steps, solutions, corrections, base=BASE):
    """The recorder's own (4, 2) along the same solutions."""
    jump = jump_of(design, curve, base)
    flights, _ = record_sensitivities(
        jump, model_derivatives(base, np.array([design]), curve), corrections
    )
    anything = {"tolerance": 1e9, "contact_steps": 1e9, "newton_share": 1e-9, "largest": 1e9}
    jump.stepping = jump.stepping._replace(**anything)
    jump.ending = TimedEnding(float(np.sum(steps)) * (1.0 - 1e-12))
    march_along(jump, steps, solutions)
    x, y, vx, vy = flights[0]
    speed, rise = flight_of(jump)[2:]
    fall = jump.models[0].load.acceleration
    by_x = x + vx * rise / fall + speed * vy / fall
    return np.array([by_x, y + rise * vy / fall]).T


@pytest.mark.parametrize("design", DESIGNS)
def test_derivatives_are_those_of_the_frozen_steps(design, curve):
    jump = jump_of(design, curve)
    steps = adaptive_steps(jump)
    exact = jump_of(design, curve)
    solutions = exact_jump(exact, steps)
    expected = [differences(design, curve, steps, solutions, h) for h in STEPS]
    scale = np.abs(expected[0]).max(axis=0)
    errors = []
    for corrections in (1, 2, 6):
        found = derivatives(design, curve, steps, solutions, corrections)
        both = [np.abs(found - one) / scale for one in expected]
        errors.append(np.minimum(*both).max())
    # Two corrections leave little of what Newton's matrix lacks, six nothing.
    assert errors[2] < 1e-5
    assert errors[1] < 5e-4
    assert errors[1] < 0.2 * errors[0]
