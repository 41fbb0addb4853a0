"""Many designs at once: rows like those of single jumps, and a status for what is refused."""

import math
from dataclasses import replace

import numpy as np
import pandas as pd
import pytest
from robots import BASELINE as BASE

from snapjump import ParameterError, Robot
from snapjump.backend.lanes import LanesBackend
from snapjump.batch import Batch, simulate_batch, simulate_designs, variants
from snapjump.composition import with_tier
from snapjump.declare.outputs import FLAG, NUMBER, WORD
from snapjump.discretization.der import DiscreteElasticRod
from snapjump.simulation import simulate
from snapjump.statics.threshold_curve import ThresholdCurve

# delta_alpha, epsilon, mass_bar, mu
GOOD = (
    (0.10, 0.20, 0.768, 0.3), (0.02, 0.11, 0.400, 0.1), (0.15, 0.29, 1.500, 0.6),
    (0.05, 0.17, 2.000, 0.2), (-0.10, 0.23, 0.500, 0.5),
)  # fmt: skip
BAD = {
    (0.1, 0.41, 0.768, 0.3): "bad_design",  # compressed too far
    (0.6, 0.20, 0.768, 0.3): "bad_design",  # too oblique
    (0.1, 0.20, 0.001, 0.3): "bad_design",  # lighter than its beam
    (0.1, 0.20, 0.768, -0.1): "bad_design",  # friction that pushes
    (0.1, np.nan, 0.768, 0.3): "bad_design",
    (0.1, 1e-6, 0.768, 0.3): "no_threshold",  # compressed straight
}
ALL = np.array([GOOD[0], *BAD, *GOOD[1:]])
PLACES = [0, *range(1 + len(BAD), len(ALL))]
COUNTS = ("kernel_seconds", "error_sum_bar", "coarsest_contact_step")
TIMING = {output.name for output in Batch.declared() if output.timing}


@pytest.fixture(scope="module")
def batch():
    """What becomes of designs that can be built and of those that cannot."""
    return simulate_designs(BASE, ALL, threads=2, lanes=1)


@pytest.fixture(scope="module")
def curve():
    return ThresholdCurve.through(BASE.robot, BASE.discretization, 0.1, 0.3)


def test_refused_designs_are_rows_with_a_status(batch):
    assert batch.status == ["ok", *BAD.values(), *["ok"] * (len(GOOD) - 1)]
    refused = np.array([status != "ok" for status in batch.status])
    for output in Batch.declared():
        values = batch.columns()[output.name]
        assert values.shape == (len(ALL),)
        if output.kind == WORD:
            continue
        if output.kind == FLAG:
            assert {*values[~refused]} <= {True, False} and {*values[refused]} == {None}
            continue
        assert np.isfinite(values[~refused]).all(), output.name
        if output.kind != NUMBER or output.name in COUNTS:
            assert (values[refused] == 0).all(), output.name
        else:
            assert np.isnan(values[refused]).all(), output.name


def test_refused_designs_say_why_by_their_rows(batch):
    assert batch.refusals.keys() == {*range(1, 1 + len(BAD))}
    assert batch.refusals[1].startswith("design.epsilon = 0.41 is not allowed: ")
    assert batch.refusals[4].startswith("environment.mu = -0.1 is not allowed: ")
    assert all("\n" not in line and line for line in batch.refusals.values())


@pytest.mark.parametrize(
    "given",
    [{"lanes": 0}, {"lanes": 3}, {"threads": 0}, {"threads": -5}, {"most_iterations": math.nan},
     {"most_iterations": 0}],
)  # fmt: skip
def test_batches_in_no_lanes_or_threads_are_refused(given):
    with pytest.raises(ParameterError, match=next(iter(given))):
        simulate_batch([BASE], **given)


def test_a_batch_of_nothing_is_refused():
    with pytest.raises(ParameterError, match="simulations"):
        simulate_batch([])


def test_rows_are_those_of_the_batch_of_good_designs(batch):
    """They are equal to the last bit, at another width and number of threads."""
    alone = simulate_batch(variants(BASE, GOOD), lanes=8).columns()
    for name, values in batch.columns().items():
        assert name in TIMING or np.array_equal(values[PLACES], alone[name]), name


def test_columns_of_a_frame_are_found_by_their_names(batch):
    frame = pd.DataFrame(ALL, columns=["delta_alpha", "epsilon", "mass_bar", "mu"])[::-1]
    found = simulate_designs(BASE, frame[frame.columns[::-1]], threads=2, lanes=1)
    np.testing.assert_array_equal(found.x_bar[::-1], batch.x_bar)


def test_rows_are_those_of_single_jumps(batch):
    for place, simulation in zip(PLACES, variants(BASE, GOOD), strict=True):
        summary = simulate(simulation).summary
        for name, values in batch.columns().items():
            assert name in TIMING or values[place] == summary[name], name


def test_the_flight_is_one_parabola(batch):
    length, gravity = BASE.robot.length_m, BASE.robot.gravity_m_s2
    aloft = batch.apex_time_s - batch.liftoff_time_s
    rise = batch.liftoff_vy_m_s * aloft - 0.5 * gravity * aloft**2
    np.testing.assert_allclose((batch.y_bar - batch.liftoff_y_bar) * length, rise, rtol=1e-9)
    drift = batch.liftoff_vx_m_s * aloft
    np.testing.assert_allclose((batch.x_bar - batch.liftoff_x_bar) * length, drift, rtol=1e-9)
    np.testing.assert_allclose(batch.liftoff_vy_m_s, gravity * aloft, rtol=1e-9)


def test_kernel_time_is_shared_by_iterations(batch):
    assert batch.kernel_seconds.sum() == pytest.approx(batch.march_seconds, rel=1e-12)
    assert batch.lane_passes >= batch.newton_iterations.sum()
    longest = np.argmax(batch.newton_iterations)
    assert np.argmax(batch.kernel_seconds) == longest


def test_thresholds_from_a_curve(batch, curve):
    found = simulate_designs(BASE, ALL[PLACES], curve=curve, threads=1)
    assert found.status == ["ok"] * len(GOOD)
    heights = batch.mount_height_bar[PLACES]
    np.testing.assert_allclose(found.mount_height_bar, heights, atol=1e-8)
    # The start differs by 1e-9; adaptive steps make of that what the tolerance allows.
    np.testing.assert_allclose(found.y_bar, batch.y_bar[PLACES], rtol=1e-2)


def test_beyond_the_curve_thresholds_are_computed(curve):
    beyond = np.array([[0.1, 0.35, 0.768, 0.3]])
    with_curve = simulate_designs(BASE, beyond, curve=curve, threads=1)
    without = simulate_designs(BASE, beyond, threads=1)
    assert with_curve.x_bar[0] == without.x_bar[0]


def test_the_backend_says_how_many_lanes_and_threads(batch):
    lanes = replace(BASE, backend=LanesBackend(width=8, threads=1))
    found = simulate_designs(lanes, ALL)
    assert np.array_equal(found.x_bar, batch.x_bar, equal_nan=True)
    assert found.lane_passes == simulate_designs(BASE, ALL, threads=1, lanes=8).lane_passes


def test_progress_ends_with_all_jumps():
    told: list[tuple[float, str]] = []
    options = {"threads": 2, "lanes": 1, "progress": lambda *args: told.append(args)}
    simulate_designs(BASE, np.array(GOOD), **options)
    assert told[-1][0] == 1.0 and told[-1][1].startswith("5 of 5 jumps")


@pytest.mark.parametrize("designs", [{}, BAD])
def test_no_designs_at_all_and_none_but_refused_ones(designs):
    found = simulate_designs(BASE, np.reshape(list(designs), (-1, 4)))
    assert found.status == list(designs.values())
    for values in (found.mount_height_bar, found.x_bar):
        assert values.shape == (len(designs),) and np.isnan(values).all()


def test_wrong_arguments(curve):
    one = np.array([GOOD[0]])
    for changed, designs, options, line in (
        (BASE, one[0], {}, "designs = .*shape"),
        (BASE, one, {"lanes": 3}, "lanes = 3"),
        (BASE, one, {"threads": 0}, "threads = 0"),
        (replace(BASE, discretization=DiscreteElasticRod(32)), one, {"curve": curve},
         "curve = .*element_length"),
        (replace(BASE, robot=Robot(length_m=0.03)), one, {"curve": curve},
         "curve = .*of this robot"),
        (with_tier("draft", sim="static"), one, {}, "sim = 'static'"),
    ):  # fmt: skip
        with pytest.raises(ParameterError, match=line):
            simulate_designs(changed, designs, **options)
