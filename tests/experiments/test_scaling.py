"""The benchmark of lanes and threads on a coarse robot: its accounts add up and disturb nothing."""

from dataclasses import replace

import numpy as np
import pytest

from experiments.designs import spread_designs
from experiments.scaling import table
from experiments.scaling.measure import measure
from experiments.scaling.split import pieces, split, untouched
from snapjump.batch import variants
from snapjump.composition import with_tier
from snapjump.discretization.der import DiscreteElasticRod
from snapjump.engine.march import march as march_on
from snapjump.scenes.jump_march import jump_march
from snapjump.scenes.jump_start import jump_model
from snapjump.statics.threshold_curve import ThresholdCurve

BASE = replace(with_tier("draft"), discretization=DiscreteElasticRod(24))


@pytest.fixture(scope="module")
def robots():
    """Four coarse simulations and their models."""
    simulations = variants(BASE, spread_designs(4))
    return simulations, [jump_model(simulation) for simulation in simulations]


def started(robots):
    march = jump_march(*robots)
    march.find_starts()
    return march


def test_throughput():
    curve = ThresholdCurve.through(BASE.robot, BASE.discretization, 0.1, 0.3)
    found = measure(BASE, curve, [(1, 1), (8, 2)], 16, 1)
    for (lanes, _), values in found.items():
        assert values.jumps_per_second > 0.0
        assert values.failed == 0
        idle = 1.0 - values.us_per_pass / values.us_per_iteration
        assert values.idle_share == pytest.approx(idle, abs=1e-12)
        assert (values.idle_share == 0.0) == (lanes == 1)


@pytest.mark.compiles
def test_the_pieces_leave_the_march_as_it_was(robots):
    undisturbed, march = started(robots).run(), started(robots)
    worker = march.crew[0]
    march_on(*march.arguments(worker), 100)
    with untouched(worker.memory):
        found = pieces(march)
    assert np.array_equal(march.run(), undisturbed)
    assert found["iteration"] > found["assembly"] > 0.0


def test_the_parts_make_a_pass(robots):
    parts = split(*robots, 1)
    whole = parts.pop("pass")
    assert sum(parts.values()) == pytest.approx(whole, abs=1e-3)


def test_the_page():
    parts = dict.fromkeys(("assembly", "contact", "solve", "correction", "stages"), 1.0)
    figures = {
        "tier": "standard", "designs": 64, "repeats": 3, "threads": 2,
        "throughput": [{"lanes": 8, "threads": 2, "jumps_per_second": 123.456}],
        "lanes_over_scalar": 3.125, "threads_over_one": 1.9375,
        "threads_over_one_undisturbed": 1.96875, "jumps_per_second_core": 80.0,
        "released_over_ours": 2080.0,
        "us_of_a_lane_and_pass": {"1": {**parts, "pass": 5.0}, "8": {**parts, "pass": 2.5}},
        "cycles_of_a_node": {"1": {**parts, "pass": 120}, "8": {**parts, "pass": 480}},
    }  # fmt: skip
    page = table.page(figures)
    assert "8 lanes over 1, in time of a Newton iteration: 3.12 times" in page
    assert "2 threads over 1, in jumps per second: 1.94 times" in page
    assert "2080 times the released program's" in page
    assert "| a pass in all | 5 | 2.5 | 2 | 100 | 120 | 480 |" in page
