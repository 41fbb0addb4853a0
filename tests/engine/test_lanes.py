"""Robots side by side in lanes: each as if it were alone."""

import numpy as np
import pytest
from robots import DESIGNS, small_march

from snapjump.engine import outcome as c
from snapjump.engine.status import OK
from snapjump.scenes import runner


def two(*others):
    """A width that no other test compiles for."""
    return pytest.param(2, *others, marks=pytest.mark.compiles)


@pytest.fixture(scope="session")
def alone(starts):
    """What becomes of every design when it is simulated by itself."""
    return small_march(DESIGNS, 1, starts).run().copy()


def test_robots_jump(alone):
    assert (alone[:, c.STATUS] == OK).all()
    assert (alone[:, c.COM_VY] > 0.0).all()
    assert len({tuple(row) for row in alone}) == len(DESIGNS)
    assert (alone[:, c.SMALLEST_GAP] > 0.0).all()
    assert (alone[:, c.LARGEST_RESIDUAL] < 0.1).all()


def test_starts_are_equilibria_of_a_stable_branch(starts):
    state, velocity, _ = starts
    nodes = state[:, 3:].reshape(len(DESIGNS), -1, 2)
    middle = nodes.shape[1] // 2
    # Arched upwards, and drooping between arch and clamps as the clamps turn on.
    assert (nodes[:, middle, 1] > nodes[:, 0, 1]).all()
    assert (velocity[:, 3:].reshape(nodes.shape)[:, middle, 1] < 0.0).all()
    # delta_alpha = 0 is symmetric.
    even = DESIGNS.index((0.2, 0.0, 0.3, 1.0))
    mirrored = nodes[even, ::-1] * [-1.0, 1.0]
    np.testing.assert_allclose(nodes[even], mirrored, atol=1e-9)


@pytest.mark.parametrize(
    ("width", "threads"),
    [(8, 1), (8, 2), (1, 2), (1, 3), (1, 5), *(two(threads) for threads in (1, 2, 3, 5))],
)
def test_outcomes_do_not_depend_on_lanes_and_threads(starts, alone, width, threads):
    march = small_march(DESIGNS, width, starts, threads=threads)
    assert len(march.crew) == threads
    assert np.array_equal(march.run(), alone)


@pytest.mark.parametrize("seed", [0, 1])
def test_outcomes_do_not_depend_on_the_order_of_the_queue(starts, alone, seed):
    """11 robots in 8 lanes: three are taken up when others have landed."""
    order = np.random.default_rng(seed).permutation(len(DESIGNS))
    shuffled = [values[order] for values in starts]
    march = small_march([DESIGNS[k] for k in order], 8, shuffled)
    assert np.array_equal(march.run(), alone[order])
    assert march.queue.counts[0] == 0
    assert (march.queue.carried == -1).all()


def test_fewer_robots_than_lanes(starts, alone):
    few = [values[:3] for values in starts]
    assert np.array_equal(small_march(DESIGNS[:3], 8, few).run(), alone[:3])


def test_robots_without_a_start_are_skipped(starts, alone):
    march = small_march(DESIGNS, 8, starts)
    march.queue.status[[0, 4, 10]] = 7.0
    outcome = march.run()
    kept = np.flatnonzero(march.queue.status == 0.0)
    assert np.array_equal(outcome[kept], alone[kept])
    assert (outcome[[0, 4, 10], c.STATUS] == 7.0).all()


@pytest.mark.parametrize(("width", "threads"), [(8, 1), (1, 3), two(3)])
def test_lanes_and_threads_find_the_same_starts(starts, width, threads):
    march = small_march(DESIGNS, width, threads=threads)
    march.find_starts()
    assert not march.queue.status.any()
    for found, expected in zip(march.queue[1:4], starts, strict=True):
        assert np.array_equal(found, expected)


@pytest.mark.parametrize("width", [1, two()])
def test_workers_that_take_turns_share_one_queue(starts, alone, monkeypatch, width):
    """Slices of three workers in an order that no race decides: each gets its part."""
    monkeypatch.setattr(runner, "PASSES_PER_SLICE", 7)
    monkeypatch.setattr(runner, "run_crew", take_turns)
    march = small_march(DESIGNS, width, starts, threads=3)
    shares = []
    assert np.array_equal(march.run(lambda share, text: shares.append(share)), alone)
    assert all(worker.queue.counts[1] > 100 for worker in march.crew)
    assert all((worker.queue.carried == -1).all() for worker in march.crew)
    # A pass is an iteration of every lane that has a robot.
    idle = width * march.passes - alone[:, c.ITERATIONS].sum()
    assert 0 <= idle < 0.5 * march.passes
    # What is told of the progress counts robots that have landed.
    assert shares == sorted(shares)
    told = set(np.round(np.array(shares) * len(DESIGNS), 9))
    assert {0, len(DESIGNS)} <= told <= set(range(len(DESIGNS) + 1))
    assert len(told) > len(DESIGNS) // 2  # some land within one slice


def take_turns(crew, advance, report):
    working = list(crew)
    while working:
        working = [worker for worker in working if not advance(worker)]
        report()


def test_no_more_threads_than_there_is_work_for(starts):
    assert len(small_march(DESIGNS, 8, starts, threads=9).crew) == 2
    assert len(small_march(DESIGNS[:1], 8, threads=9).crew) == 1
