"""Derivatives of a jump against central differences of the same program, its steps frozen."""

import numpy as np
import pytest

from experiments.sensitivities.agreement import frozen_errors
from snapjump.batch import variant
from snapjump.composition import with_tier
from snapjump.contact.logbarrier import LogBarrier
from snapjump.discretization.der import DiscreteElasticRod
from snapjump.friction.implicit import ImplicitFriction
from snapjump.statics.threshold_curve import ThresholdCurve
from snapjump.stepping.adaptive import AdaptiveStep

BASE = with_tier(
    "draft",
    discretization=DiscreteElasticRod(16),
    stepping=AdaptiveStep(2e-5, 2.0),
    contact=LogBarrier(distance_m=1e-3),
    # The kinks of friction, at its true 1e-4 m/s, leave nothing of differences.
    friction=ImplicitFriction(velocity_threshold_m_s=1.0),
)
# Values of inputs beside the four, four at a time.
OTHERS = (
    {
        "robot.frame_height_m": 0.01,
        "robot.thickness_m": 5e-5,
        "robot.rotation_rate_rad_s": 20.0,
        "damping.relaxation_time_s": 1e-5,
    },
    {
        "contact.stiffness_N_m": 1e4,
        "robot.mount_height": 1.4e-3,
        "robot.gravity_m_s2": 10.0,
        "robot.length_m": 0.02,
    },
    {
        "robot.youngs_modulus_Pa": 2e11,
        "robot.density_kg_m3": 5000.0,
        "contact.distance_m": 1e-3,
        "friction.velocity_threshold_m_s": 1.0,
    },
    {
        "contact.damping_s": 1e-6,
        "robot.width_m": 0.01,
        "design.epsilon": 0.15,
        "environment.slope_rad": 0.1,
    },
)
# delta_alpha, epsilon, mass_bar, mu
DESIGNS = ((0.03, 0.15, 1.3, 0.25), (0.15, 0.18, 1.6, 0.2))


@pytest.fixture(scope="module")
def curve():
    return ThresholdCurve.through(BASE.robot, BASE.discretization, 0.14, 0.21)


@pytest.mark.compiles
@pytest.mark.parametrize("design", DESIGNS)
def test_derivatives_are_those_of_the_frozen_steps(design, curve):
    one, two, six = frozen_errors(BASE, np.array(design), curve, (1, 2, 6)).max(axis=1)
    # Two corrections leave little of what Newton's matrix lacks, six nothing.
    assert six < 1e-5
    assert two < 5e-4
    assert two < 0.2 * one


@pytest.mark.compiles
@pytest.mark.parametrize("values", OTHERS)
def test_derivatives_by_any_inputs(values, curve):
    base = variant(BASE, DESIGNS[0])
    errors = frozen_errors(base, np.array(list(values.values())), curve, (2, 6), tuple(values))
    two, six = (dict(zip(values, row, strict=True)) for row in errors)
    assert max(six.values()) < 5e-5, six
    assert max(two.values()) < 1e-2, two
