"""The recorder's ledger and its samples, with powers that are known functions of time."""

import numpy as np
import pytest
from bare_models import loose_nodes
from plain_python import plain_work

from snapjump.declare.members import member_class
from snapjump.engine.assemble import Motion
from snapjump.engine.clock import LARGEST_RESIDUAL, STAGE, STEP, TIME
from snapjump.engine.recorder import trajectory
from snapjump.engine.recorder.none import NoRecorder

TABLEAU = member_class("integrator", "tr_bdf2")().scheme()
MODEL = loose_nodes()
MASSES = np.array([2.0])


def march(recorder, steps, accepted=lambda k: True):
    """Steps of the recorder alone; returns the times at which they ended."""
    stages = len(TABLEAU.nodes)
    work = plain_work(MODEL, 1, stages)
    recorder.record_start(MODEL, MASSES, work)
    times = [0.0]
    for k, step in enumerate(steps):
        work.clock[STEP] = step
        for stage in range(1, stages):
            work.clock[STAGE] = stage
            time = work.clock[TIME] + TABLEAU.nodes[stage] * step
            now = Motion(time, *([1.0 / (TABLEAU.gamma * step)] * 2), 0.0)
            recorder.record_stage(MODEL, MASSES, now, TABLEAU, work, True)
        if accepted(k):
            work.clock[TIME] += step
            work.start[:] = work.clock[TIME], k
            work.velocity[0] = 10.0 + k
            times.append(float(work.clock[TIME]))
        recorder.record_step(None, None, None, work, accepted(k))
    return times


@pytest.fixture(autouse=True)
def known_powers(monkeypatch):
    def known(model, motion, *others):
        return 1.0, 2.0 * motion.time, -motion.time, 3.0, 4.0 * motion.time

    monkeypatch.setattr(trajectory, "powers", known)


def test_works_are_integrals_of_the_powers():
    recorder = trajectory.make_recorder(2, 2.0, 0.01)
    times = march(recorder, [0.1, 0.2, 0.05, 0.4])
    count = recorder.filled[0]
    t = np.array(times)
    np.testing.assert_allclose(recorder.times[:count], t, atol=1e-15)
    expected = np.stack([t, t**2, -0.5 * t**2, 3.0 * t, 2.0 * t**2], axis=1)
    np.testing.assert_allclose(recorder.works[:count], expected, atol=1e-14)
    np.testing.assert_allclose(recorder.states[:count, 0], t, atol=1e-15)
    assert recorder.velocities[:count, 0].tolist() == [0.0, 10.0, 11.0, 12.0, 13.0]


def test_refused_steps_leave_no_trace():
    recorder = trajectory.make_recorder(2, 2.0, 0.01)
    march(recorder, [0.1, 0.7, 0.2], accepted=lambda k: k != 1)
    assert recorder.filled[0] == 3
    np.testing.assert_allclose(recorder.totals, [0.3, 0.09, -0.045, 0.9, 0.18], atol=1e-15)


def test_samples_keep_their_distance_and_never_overflow():
    recorder = trajectory.make_recorder(2, 1.0, 0.1)
    march(recorder, [0.03] * 30)
    gaps = np.diff(recorder.times[: recorder.filled[0]])
    assert gaps.min() >= 0.1 - 1e-12
    assert gaps.max() < 0.13 + 1e-12
    short = trajectory.make_recorder(2, 0.1, 0.1)
    march(short, [0.2] * 100)
    assert short.filled[0] < len(short.times)
    np.testing.assert_allclose(short.totals[0], 20.0)


def test_residual_left_in_a_stage_is_recorded():
    recorder = trajectory.make_recorder(2, 1.0, 0.1)
    work = plain_work(MODEL, 1, len(TABLEAU.nodes))
    work.clock[STAGE] = 1.0
    now = Motion(0.1, 20.0, 20.0, 0.0)
    recorder.record_stage(MODEL, MASSES, now, TABLEAU, work, True)
    assert work.clock[LARGEST_RESIDUAL] == 0.0
    # 4 parts of force in play, 3 of them along x, none balanced.
    work.velocity_predictor[:] = 3.0, 1.0
    recorder.record_stage(MODEL, MASSES, now, TABLEAU, work, True)
    assert work.clock[LARGEST_RESIDUAL] == pytest.approx(0.75)


def test_no_recorder_asks_for_nothing():
    NoRecorder().record_start(None, None, None)
    NoRecorder().record_stage(None, None, None, None, None, None)
    NoRecorder().record_step(None, None, None, None, None)
