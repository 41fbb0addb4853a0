"""Plans: the box is kept, any stretch equals that of the whole, and seeds are heeded."""

import tracemalloc
import warnings

import numpy as np
import pytest

from snapjump.plan.grid import Grid
from snapjump.plan.latin_hypercube import LatinHypercube
from snapjump.plan.sobol import Sobol

RANGES = ((0.01, 0.19), (0.1, 0.3), (0.3, 2.0), (0.1, 0.6))
PLANS = {
    "grid": Grid(points=4).plan(RANGES),
    "sobol": Sobol(count=300).plan(RANGES),
    "latin_hypercube": LatinHypercube(count=300).plan(RANGES),
}

PINNED_LATIN = [0.1560970706585355, 0.14524525230567578, 1.7283603391669649, 0.23454352075031443]
PINNED_SOBOL = [0.18434677712619305, 0.29145151991397145, 0.7917853730730713, 0.46160432547330854]


def unit(designs):
    low, high = np.array(RANGES).T
    return (designs - low) / (high - low)


@pytest.mark.parametrize("name", PLANS)
def test_stretches_are_those_of_the_whole(name):
    plan = PLANS[name]
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        whole = plan.designs(0, plan.count)
        assert whole.shape == (plan.count, 4)
        for size in (1, 37, 128):
            firsts = range(0, plan.count, size)
            parts = [plan.designs(first, min(first + size, plan.count)) for first in firsts]
            assert (np.concatenate(parts) == whole).all()
    assert plan.designs(5, 5).shape == (0, 4)


@pytest.mark.parametrize("name", PLANS)
def test_designs_are_within_their_ranges_and_all_different(name):
    plan = PLANS[name]
    designs = plan.designs(0, plan.count)
    low, high = np.array(plan.ranges).T
    assert (designs >= low).all() and (designs <= high).all()
    assert len(np.unique(designs, axis=0)) == plan.count


@pytest.mark.parametrize("name", PLANS)
@pytest.mark.parametrize("stretch", [(-1, 3), (3, 2), (0, 301)])
def test_a_stretch_beyond_the_plan_is_an_error(name, stretch):
    with pytest.raises(ValueError):
        PLANS[name].designs(*stretch)


def test_the_paper_s_grid():
    plan = Grid().plan(RANGES)
    assert plan.count == 50_625
    corners = plan.designs(0, 1), plan.designs(plan.count - 1, plan.count)
    assert corners[0].tolist() == [[0.01, 0.1, 0.3, 0.1]]
    assert corners[1].tolist() == [[0.19, 0.3, 2.0, 0.6]]
    # The last input runs fastest, in even steps.
    assert plan.designs(0, 15)[:, 3] == pytest.approx(0.1 + 0.5 * np.arange(15) / 14, rel=1e-15)
    assert (plan.designs(0, 15)[:, :3] == plan.designs(0, 1)[:, :3]).all()


def test_a_latin_hypercube_has_one_point_in_every_interval():
    for count in (1, 2, 7, 300, 1025):
        options = LatinHypercube(count=count, seed=3)
        points = unit(options.plan(RANGES).designs(0, count))
        intervals = np.sort(np.floor(points * count - 1e-9).astype(int).clip(0), axis=0)
        assert (intervals == np.arange(count)[:, None]).all()


def test_inputs_of_a_latin_hypercube_are_unrelated():
    options = LatinHypercube(count=4096)
    designs = options.plan(RANGES).designs(0, 4096)
    correlation = np.corrcoef(designs.T) - np.eye(4)
    # Four times the standard deviation of a correlation of unrelated numbers.
    assert np.abs(correlation).max() < 4.0 / 64.0
    steps = np.corrcoef(designs[1:].T, designs[:-1].T)[:4, 4:]
    assert np.abs(steps).max() < 4.0 / 64.0


def test_sobol_points_are_more_even_than_random_ones():
    from scipy.stats.qmc import discrepancy

    options = Sobol(count=256)
    points = unit(options.plan(RANGES).designs(0, 256))
    random = np.random.default_rng(0).random((256, 4))
    assert discrepancy(points) < 0.2 * discrepancy(random)


@pytest.mark.parametrize("options", [Sobol, LatinHypercube])
def test_seeds(options):
    first, again, other = (options(count=64, seed=seed).plan(RANGES) for seed in (1, 1, 2))
    assert (first.designs(0, 64) == again.designs(0, 64)).all()
    assert not (first.designs(0, 64) == other.designs(0, 64)).any()


def test_a_latin_hypercube_is_the_same_on_every_machine():
    """Integers and correctly rounded arithmetic alone: these digits hold anywhere."""
    designs = LatinHypercube(count=1000, seed=7).plan(RANGES).designs(500, 501)
    assert designs.tolist() == [PINNED_LATIN]


def test_sobol_points_are_the_same_on_every_machine():
    designs = Sobol(count=1000, seed=7).plan(RANGES).designs(500, 501)
    assert designs.tolist() == [PINNED_SOBOL]


@pytest.mark.parametrize("options", [Grid(points=32), Sobol(count=2**20),
                                     LatinHypercube(count=2**20)])  # fmt: skip
def test_a_million_designs_are_planned_and_not_held(options):
    plan = options.plan(RANGES)
    assert plan.count == 2**20
    plan.designs(0, 8)
    tracemalloc.start()
    plan.designs(plan.count - 1024, plan.count)
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert peak < 2**20  # bytes; the whole plan has 32 times as many
