"""Plans: the box is kept, stretches are those of the whole, seeds are heeded; all axes."""

import tracemalloc
import warnings
from dataclasses import replace

import numpy as np
import pytest
from refusals import refused

from snapjump import Environment, ParameterError
from snapjump.composition import with_tier
from snapjump.declare.fields import number
from snapjump.declare.inputs import (
    DEFAULT_INPUTS,
    column_names,
    inputs_of,
    slope_names,
    value_at,
    with_inputs,
)
from snapjump.plan.grid import Grid
from snapjump.plan.latin_hypercube import LatinHypercube
from snapjump.plan.parts.axes import default_axes, recorded_axes
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


@pytest.mark.parametrize(
    ("options", "pinned"), [(LatinHypercube, PINNED_LATIN), (Sobol, PINNED_SOBOL)]
)
def test_designs_are_the_same_on_every_machine(options, pinned):
    """Integers and correctly rounded arithmetic alone: these digits hold anywhere."""
    assert options(count=1000, seed=7).plan(RANGES).designs(500, 501).tolist() == [pinned]


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


BASE = with_tier("draft")


def test_every_number_of_a_physical_part_is_an_input():
    found = inputs_of(BASE)
    assert {"robot.thickness_m", "robot.mount_height", "contact.stiffness_N_m"} <= set(found)
    assert {"damping.relaxation_time_s", "friction.velocity_threshold_m_s"} <= set(found)
    assert not [path for path in found if path.startswith(("discretization", "stepping", "sim"))]
    assert found["robot.length_m"].unit == "m" and found["design.epsilon"].kind == "control"
    for path, one in found.items():
        if path.startswith(("robot", "design", "environment")):
            assert one.plan and one.meaning and one.symbol
            assert one.plan[0] < one.plan[1] and one.kind in ("control", "environment", "property")


def test_values_are_set_by_path():
    other = with_inputs(BASE, {"robot.mount_height": 2e-3, "contact.stiffness_N_m": 2e4})
    assert value_at(other, "robot.mount_height") == 2e-3
    assert other.contact.stiffness_N_m == 2e4 and other.design == BASE.design
    with pytest.raises(ParameterError, match="robot.mount_height = 0.02"):
        with_inputs(BASE, {"robot.mount_height": 0.02})


def test_the_four_by_default():
    axes = Sobol(epsilon=[0.15, 0.2]).axes(BASE)  # type: ignore[arg-type]
    assert tuple(axis.path for axis in axes) == DEFAULT_INPUTS
    assert [axis.column for axis in axes] == ["delta_alpha_rad", "epsilon", "mass_bar", "mu"]
    assert axes[1].range == (0.15, 0.2) and axes[2].range == (0.3, 2.0)
    old = {"plan": {axis.column: list(axis.range) for axis in axes}}
    assert recorded_axes(old) == axes == default_axes([axis.range for axis in axes])


def test_any_inputs_in_the_order_given():
    given = {"robot.thickness_m": None, "design.epsilon": [0.1, 0.2]}
    thickness, epsilon = Sobol(inputs=given).axes(BASE)  # type: ignore[arg-type]
    assert thickness.column == "thickness_m" and thickness.range == (3.5e-5, 7.5e-5)
    assert epsilon.range == (0.1, 0.2) and epsilon.label == "pre-compression ε"


def test_two_of_one_name_are_called_by_their_paths():
    one, other = inputs_of(BASE)["robot.length_m"], inputs_of(BASE)["design.epsilon"]
    twin = replace(other, path="frame.length_m", column="length_m")
    assert column_names([one, twin, other]) == ["robot_length_m", "frame_length_m", "epsilon"]
    assert slope_names([one, twin, other]) == ["robot_length_m", "frame_length_m", "epsilon"]


@pytest.mark.parametrize(
    ("options", "key"),
    [
        ({"delta_alpha_rad": [-0.51, 0.1]}, "plan.delta_alpha_rad"),
        ({"epsilon": [0.0, 0.2]}, "plan.epsilon"),
        ({"epsilon": [0.1, 0.41]}, "plan.epsilon"),
        ({"mass_bar": [0.001, 2.0]}, "plan.mass_bar"),
        ({"mu": [-1e-9, 0.5]}, "plan.mu"),
        ({"inputs": {"robot.frame_height_m": [0.01, 0.0]}}, "plan.inputs.robot.frame_height_m"),
        ({"inputs": {"robot.mount_height": [1e-3, 0.02]}}, "plan.inputs.robot.mount_height"),
        ({"inputs": {"robot.thickness_m": [1e-5, 0.01]}}, "plan.inputs.robot.thickness_m"),
        ({"inputs": {"robot.colour": None}}, "plan.inputs"),
        ({"inputs": {"discretization.elements": [8.0, 80.0]}}, "plan.inputs"),
        ({"inputs": {"design.epsilon": None}, "epsilon": [0.1, 0.2]}, "plan.epsilon"),
    ],
)
def test_what_no_robot_has(options, key):
    with refused(key):
        Sobol(**options).axes(BASE)


def test_a_range_that_is_not_declared_has_to_be_given():
    class Windy(Environment):
        """An environment with one number more."""

        wind_rad: float = number(0.0, unit="rad")

    base = replace(BASE, environment=Windy())
    with pytest.raises(ParameterError, match=r"plan.inputs.environment.wind_rad = None .* a range"):
        Sobol(inputs={"environment.wind_rad": None}).axes(base)
    (axis,) = Sobol(inputs={"environment.wind_rad": (-0.1, 0.1)}).axes(base)
    assert axis.column == "wind_rad" and axis.short == "wind_rad (rad)"
