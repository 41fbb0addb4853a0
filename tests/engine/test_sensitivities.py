"""Derivatives of a jump against central differences of the same program, its steps frozen."""

from dataclasses import replace

import numpy as np
import pytest

from experiments.sensitivities.agreement import frozen_errors
from snapjump.batch import variant
from snapjump.composition import with_tier
from snapjump.contact.logbarrier import LogBarrier
from snapjump.declare.inputs import DEFAULT_INPUTS, inputs_of, value_at
from snapjump.discretization.corotational import Corotational
from snapjump.discretization.der import DiscreteElasticRod
from snapjump.drag.quadratic import QuadraticDrag
from snapjump.friction.implicit import ImplicitFriction
from snapjump.integrator.generalized_alpha import GeneralizedAlpha
from snapjump.scenes.sensitivities import CORRECTIONS
from snapjump.statics.threshold_curve import ThresholdCurve
from snapjump.stepping.adaptive import AdaptiveStep

BASE = with_tier(
    "draft",
    discretization=DiscreteElasticRod(16),
    integrator=GeneralizedAlpha(spectral_radius=0.0),
    stepping=AdaptiveStep(2e-5, 2.0, 16.0),
    contact=LogBarrier(distance_m=1e-3),
    # The kinks of friction, at its true 1e-4 m/s, leave nothing of differences.
    friction=ImplicitFriction(velocity_threshold_m_s=1.0),
    drag=QuadraticDrag(area_m2=2e-4),
)
# All inputs beside the four, where they are but for some, four at a time.
VALUES = {path: value_at(BASE, path) for path in inputs_of(BASE) if path not in DEFAULT_INPUTS}
VALUES |= {"robot.mount_height": 1.4e-3, "contact.damping_s": 1e-6}
VALUES |= {"frame.mass_centre_height_m": 8e-3, "frame.inertia_kg_m2": 1.2e-7}
VALUES |= {"frame.mass_centre_offset_m": 5e-4, "frame.clamp_mass_kg": 2e-4}
VALUES |= {"drive.right_rate_rad_s": 18.0}
VALUES |= {"robot.yield_stress_Pa": 1.5e9, "design.epsilon": 0.15, "environment.slope_rad": 0.1}
FOURS = [dict(list(VALUES.items())[k : k + 4]) for k in range(0, len(VALUES), 4)]
# delta_alpha, epsilon, mass_bar, mu
DESIGNS = ((0.03, 0.15, 1.3, 0.25), (0.15, 0.18, 1.6, 0.2))
# Where no kink of the frozen steps lies within the differences' reach of any input.
SMOOTH = (0.1, 0.18, 1.6, 0.2)


@pytest.fixture(scope="module")
def curve():
    return ThresholdCurve.through(BASE.robot, BASE.discretization, 0.14, 0.21)


@pytest.mark.compiles
@pytest.mark.parametrize("design", DESIGNS)
def test_derivatives_are_those_of_the_frozen_steps(design, curve):
    """The matrix lacks nothing: one solution is all."""
    (errors,) = frozen_errors(BASE, np.array(design), curve, (1,))
    assert errors.max() < 1e-5


@pytest.mark.compiles
@pytest.mark.parametrize("values", FOURS)
def test_derivatives_by_any_inputs(values, curve):
    base = variant(BASE, SMOOTH)
    (errors,) = frozen_errors(base, np.array(list(values.values())), curve, (1,), tuple(values))
    found = dict(zip(values, errors, strict=True))
    assert max(found.values()) < 5e-5, found


@pytest.mark.slow
def test_corrections_make_good_what_a_matrix_lacks():
    """Of elements that do not tell what their symmetric matrix lacks."""
    base = replace(BASE, discretization=Corotational(16))
    curve = ThresholdCurve.through(base.robot, base.discretization, 0.14, 0.21)
    one, three = frozen_errors(base, np.array(DESIGNS[0]), curve, (1, CORRECTIONS)).max(axis=1)
    assert three < 1e-4 and three < 0.02 * one
