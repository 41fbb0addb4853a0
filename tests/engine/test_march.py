"""The time loop: no memory is allocated in it, it can be interrupted, and it gives up by name."""

import numpy as np
import pytest
from numba.core.runtime import _nrt_python, rtsys
from robots import DESIGNS, small_march

from snapjump.batch.derivatives import place
from snapjump.engine import clock, status
from snapjump.engine import march as loop
from snapjump.engine import outcome as c


def go_on(march, passes, of_a_stage=25.0, of_a_march=2e6, **stepping):
    limits = {"most_in_stage": of_a_stage, "most_in_march": of_a_march}
    method = march.method._replace(stepping=march.stepping._replace(**stepping), **limits)
    memory, lanes = (march.recorder, march.memory, march.queue), (0,) * march.lanes
    return loop.march(march.models[0], march.masses, method, *memory, lanes, passes)


def allocations(march, passes):
    before = rtsys.get_allocation_stats()
    go_on(march, passes)
    after = rtsys.get_allocation_stats()
    return after.alloc - before.alloc, after.mi_alloc - before.mi_alloc


@pytest.fixture
def counted():
    enabled = _nrt_python.memsys_stats_enabled()
    _nrt_python.memsys_enable_stats()
    yield
    if not enabled:
        _nrt_python.memsys_disable_stats()


@pytest.mark.parametrize("lanes", [1, 8])
def test_nothing_is_allocated_in_the_loop(starts, lanes, counted):
    march = small_march(DESIGNS, lanes, starts)
    go_on(march, 1)
    # What is left is the wrapping of the arguments, once a call.
    few, many = allocations(march, 1), allocations(march, 400)
    assert few == allocations(march, 1) == many
    assert march.memory.clock[clock.STEPS].sum() > 0


def test_slices_of_passes_are_one_march(starts):
    whole, sliced = (small_march(DESIGNS[:3], 1, [v[:3] for v in starts]) for _ in range(2))
    assert go_on(whole, 1_000_000)
    slices = 1
    while not go_on(sliced, 97):
        slices += 1
    assert slices > 10
    assert np.array_equal(sliced.queue.outcome, whole.queue.outcome)
    # There is nothing left to do.
    assert go_on(sliced, 97)


def ends(march, passes, **limits):
    """What becomes of a march of one robot that ends within so many passes."""
    assert go_on(march, passes, **limits)
    return march.queue.outcome[0]


@pytest.fixture
def march_of_one(starts):
    """Makes marches of one robot from its start."""
    return lambda **changed: small_march(DESIGNS[1:2], 1, [v[1:2] for v in starts], **changed)


def test_iteration_limit(march_of_one):
    outcome = ends(march_of_one(), 1000, of_a_march=20.0)
    assert outcome[c.STATUS] == status.ITERATION_LIMIT
    assert outcome[c.ITERATIONS] == 20.0


def test_step_underflow(march_of_one):
    """If one iteration is never enough, Newton's method fails however small the step; so does the
    estimate of the error for a tolerance that is never met."""
    march = march_of_one()
    outcome = ends(march, 1000, of_a_stage=1.0, smallest=1e-5, newton_share=1e-12)
    assert outcome[c.STATUS] == status.STEP_UNDERFLOW
    assert outcome[c.STEPS] == 0.0
    assert outcome[c.STEP] < 1e-5
    # 0.4^k of the first step: one failure each
    assert outcome[c.FAILURES] == np.ceil(np.log(1e-5 / march.stepping.first) / np.log(0.4))
    outcome = ends(march_of_one(), 1000, tolerance=1e-16, newton_share=1e4, smallest=1e-5)
    assert outcome[c.STATUS] == status.STEP_UNDERFLOW
    assert outcome[c.REJECTED] > 0.0


def test_time_limit(march_of_one):
    """While the clamps still turn; if they have stopped before the snap, there was no jump."""
    outcome = ends(march_of_one(duration=0.05), 10_000)
    assert outcome[c.STATUS] == status.TIME_LIMIT
    assert outcome[c.TIME] == pytest.approx(0.05, rel=1e-9)
    assert outcome[c.STEPS] > 3.0
    march = march_of_one(duration=0.05)
    march.queue.numbers[0, place(march.models[0], "clamp", "end")] = march.models[0].clamp.start
    assert ends(march, 10_000)[c.STATUS] == status.NO_JUMP


def test_a_state_that_is_not_finite_is_not_followed(march_of_one):
    march = march_of_one()
    march.queue.velocity[0, 10] = np.nan
    assert ends(march, 100_000)[c.STATUS] not in (status.RUNNING, status.OK, status.NO_JUMP)


def test_a_start_beyond_the_fold_is_refused():
    """Followed past its critical angle the upper branch is lost."""
    march = small_march(DESIGNS[1:2], 1)
    march.queue.numbers[0, place(march.models[0], "clamp", "start")] = 1.2
    march.find_starts()
    assert march.queue.status[0] == status.NO_EQUILIBRIUM


def test_every_status_has_a_name_and_a_reason():
    names, reasons = status.NAMES, status.REASONS
    assert set(names) == set(reasons)
    assert status.RUNNING not in names
    assert len(set(names.values())) == len(names)
    assert names[status.OK] == "ok"
    assert all(reason for ended, reason in reasons.items() if ended != status.OK)
