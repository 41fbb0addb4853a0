"""Contact and friction of the beam's free nodes, without a frame."""

import numpy as np
import pytest
from bare_models import loose_nodes
from plain_python import assembled, complex_step, dense, residual_of

from snapjump.contact.base import Ground
from snapjump.contact.logbarrier import LogBarrier
from snapjump.engine.assemble import Motion
from snapjump.engine.load.gravity import Gravity
from snapjump.friction.implicit import ImplicitFriction

MASSES = np.array([0.3, 0.5, 0.2])
MOTION = Motion(0.0, 40.0, 40.0, 0.0)
MODEL = loose_nodes(
    contact=LogBarrier.Law(4e3, 0.025, 0.0), load=Gravity(1.0, 20.0, 6.0),
    friction=ImplicitFriction.Law(0.4, 0.25), ground=Ground(7.0, 1.5, 0.025),
)  # fmt: skip
STATE = np.array([0.0, 0.01, 0.1, 0.02, 0.2, 0.5])  # two in the barrier, one above it
ORIGIN = STATE - np.array([1e-3, 1e-4, 0.05, 0.0, 0.1, 0.0])


def test_tangent_leaves_out_friction_s_change_with_the_gap_only():
    def residual(y):
        return residual_of(assembled(MODEL, MOTION, MASSES, y, position_predictor=ORIGIN)[1], 0)

    _, work = assembled(MODEL, MOTION, MASSES, STATE, position_predictor=ORIGIN)
    matrix, expected = dense(work, 0), complex_step(residual, STATE)
    left_out = expected - matrix
    scale = np.abs(expected).max()
    assert np.abs(np.delete(left_out.ravel(), [0 * 6 + 1, 2 * 6 + 3])).max() < 1e-10 * scale
    assert np.array_equal(matrix, matrix.T)


def test_figures_report_force_gap_and_contact_time():
    figures, work = assembled(MODEL, MOTION, MASSES, STATE, position_predictor=STATE)
    assert figures.smallest_gap == 0.01
    assert figures.contact_rate_squared == 0.0  # at rest nothing bounces
    falling = STATE + [0.0, 1.0, 0.0, 0.0, 0.0, 0.0]
    fast, _ = assembled(MODEL, MOTION, MASSES, STATE, position_predictor=falling)
    inertia = MASSES[0] * MOTION.rate_factor**2
    stiffness = work.band[1, 0] - inertia
    assert stiffness > 1e3
    assert fast.contact_rate_squared == pytest.approx(stiffness / MASSES[0], rel=1e-10)


def test_gravity_pulls_down_and_along_the_slope():
    high = STATE + [0.0, 1.0] * 3
    _, work = assembled(MODEL, Motion(0.0, 0.0, 0.0, 0.0), MASSES, high, position_predictor=high)
    residual = work.residual.reshape(3, 2)
    np.testing.assert_allclose(residual, np.outer(MASSES, [-6.0, 20.0]), rtol=1e-14)
