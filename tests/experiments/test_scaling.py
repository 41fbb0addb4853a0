"""The benchmark of lanes and threads on a coarse robot: its accounts add up and disturb nothing."""

from dataclasses import replace

import numpy as np
import pytest

from experiments.designs import spread_designs
from experiments.scaling import costs, ledger, table
from experiments.scaling.costs import Costs, update
from experiments.scaling.floors import floor, roofline
from experiments.scaling.ledger import Operations, cache_lines, with_ledger
from experiments.scaling.measure import measure
from experiments.scaling.split import split, timed, untouched
from snapjump.batch import variants
from snapjump.composition import with_tier
from snapjump.discretization.der import DiscreteElasticRod
from snapjump.engine.march import march as march_on
from snapjump.number.functions import fma, sqrt
from snapjump.number.lane import view_numbers
from snapjump.number.memory import aligned_zeros
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
        found = timed(march)
    assert np.array_equal(march.run(), undisturbed)
    assert found["iteration"] > found["assembly"] > 0.0


@pytest.mark.compiles
def test_the_parts_make_a_pass(robots):
    parts = split(*robots, 1)
    whole = parts.pop("pass")
    assert sum(parts.values()) == pytest.approx(whole, abs=1e-3)


def roof(least):
    """A made-up roofline of one width."""
    units = {"arithmetic": 60.0, "division": 50.0, "memory": least, "floor": least}
    parts = (*table.PARTS,)
    return {
        "cycles": dict.fromkeys(Costs._fields, 0.5),
        "of_a_node": dict.fromkeys(parts, dict.fromkeys(Operations._fields, 7.0)),
        "floors": dict.fromkeys(parts, units),
    }


def of_each_kind(numbers, lanes, count):
    """Two sums, and one operation of every other kind, each of what the one before gave."""
    x = view_numbers(numbers, lanes)
    a, y = x[0], x[1]
    for _ in range(count):
        a = sqrt(fma(a, y, y) / (a + y) * y - a)
    x[0] = a


@pytest.mark.parametrize("width", [1, 8])
def test_operations_are_counted_as_they_run(width):
    program, kept = with_ledger(of_each_kind)
    numbers = aligned_zeros((2, width))
    numbers[:] = 3.0
    program(numbers, (0,) * width, 1)
    kept.operations(1)
    program(numbers, (0,) * width, 1000)
    found = kept.operations(1000)
    assert found[:5] == (2.0, 1.0, 1.0, 1.0, 1.0)
    assert kept.operations(1000) == Operations(*[0.0] * 7)


@pytest.mark.parametrize("share, written", [(0.5, 0.0), (2.0, 1.0)])
def test_lines_are_those_that_the_cache_cannot_keep(share, written):
    program, kept = with_ledger(update.py_func)
    lines = int(share * cache_lines())
    numbers = aligned_zeros((lines, 8))
    program(numbers, (0,) * 8, 1)
    kept.operations(1)
    program(numbers, (0,) * 8, 3)
    found = kept.operations(3 * lines)
    assert found.lines_written == pytest.approx(written, abs=1e-3)
    assert found.lines_read == pytest.approx(0.0, abs=1e-3)


def test_more_accesses_than_there_is_room_for_are_told(monkeypatch):
    monkeypatch.setattr(ledger, "ROOM", 64)
    program, kept = with_ledger(update.py_func)
    program(aligned_zeros((100, 8)), (0,) * 8, 1)
    with pytest.raises(RuntimeError, match="with room for 64"):
        kept.operations(1)


def test_costs_are_those_of_this_processor(monkeypatch):
    """On none that has been made is a quotient or a root as quick as a sum or a product."""
    monkeypatch.setattr(costs, "STEPS", 20_000)
    found = costs.costs(8, 2**18)
    assert min(found) > 0.0
    assert min(found.quotients, found.roots) > 2.0 * max(found.sums, found.products, found.fused)


def test_a_floor_is_of_the_units_that_are_busy_longest():
    price = Costs(
        sums=0.5, products=0.5, fused=1.0, turns=0.25, quotients=16.0, roots=20.0,
        lines_read=1.0, lines_written=4.0,
    )  # fmt: skip
    found = floor(Operations(100.0, 40.0, 30.0, 2.0, 1.0, 5.0, 3.0), price)
    assert found == {"arithmetic": 50.0, "division": 52.0, "memory": 17.0, "floor": 52.0}
    shared = price._replace(turns=0.5)  # one unit for sums and products
    assert floor(Operations(100.0, 40.0, 30.0, 2.0, 1.0, 5.0, 3.0), shared)["floor"] == 85.0


@pytest.mark.slow
def test_what_parts_take_makes_a_pass(robots, monkeypatch):
    monkeypatch.setattr(costs, "STEPS", 20_000)
    found = roofline(*robots, 1)
    taken = found["of_a_node"]
    whole = taken.pop("pass")
    for kind, number in whole.items():
        assert sum(part[kind] for part in taken.values()) == pytest.approx(number, abs=0.05)
    assert whole["fused"] > taken["assembly"]["fused"] > 0.0
    assert whole["fused"] > taken["solve"]["fused"] > 0.0
    assert taken["contact"]["quotients"] > 0.0
    assert found["floors"]["pass"]["floor"] > 0.0


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
        "rooflines": {"1": roof(80.4), "8": roof(210.6)},
    }  # fmt: skip
    page = table.page(figures)
    assert "8 lanes over 1, in time of a Newton iteration: 3.12 times" in page
    assert "2 threads over 1, in jumps per second: 1.94 times" in page
    assert "2080 times the released program's" in page
    assert "| a pass in all | 5 | 2.5 | 2 | 100 | 120 | 80 | 480 | 211 | memory |" in page
    assert "| square root | 0.5 | 0.5 | 7 | 7 |" in page
    assert "| sums and products in turns | 0.5 | 0.5 |  |  |" in page
