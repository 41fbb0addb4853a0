"""The error estimate: what raises it, what it is compared with, and who is told."""

from dataclasses import replace

import numpy as np
import pytest
from reported import DRAFT_JUMP

from experiments.tradeoff.tiers import PROMISES
from snapjump.composition import with_tier
from snapjump.discretization.der import DiscreteElasticRod
from snapjump.error_estimate import FACTORS, LEVEL, error_estimate, mesh_percent, steps_factor
from snapjump.show.terminal.scene_report import scene_report
from snapjump.tiers import TIERS

STANDARD = with_tier("standard")
HEAVY = 1e-3  # beam over frame
DAMPED = 2e-3  # T


def test_it_grows_with_the_steps_estimates_and_levels_off():
    sums = np.array([0.0, 1e-6, 1e-5, 1e-3, 1.0])
    found = error_estimate(STANDARD, sums, HEAVY, DAMPED)
    assert np.all(np.diff(found.x_percent) > 0.0) and np.all(np.diff(found.y_percent) > 0.0)
    assert found.x_percent[-1] < 1.01 * LEVEL
    assert found.within_tier.tolist() == [True, True, True, False, False]
    np.testing.assert_array_equal(found.percent, np.maximum(found.x_percent, found.y_percent))


def test_a_failed_number_is_not_within_any_tier():
    assert not error_estimate(STANDARD, np.nan, HEAVY, DAMPED).within_tier


def test_meshes_clamps_and_light_frames():
    meshes = [DiscreteElasticRod(elements=n) for n in (32, 128)]
    coarse, fine = (mesh_percent(mesh, DAMPED) for mesh in meshes)
    assert mesh_percent(meshes[1], 0.0)[0] > 2.0 * fine[0]
    assert coarse[0] > 16.0 * fine[0] and coarse[1] > 16.0 * fine[1]
    nodes = mesh_percent(DiscreteElasticRod(elements=128, clamp="two_nodes"), DAMPED)
    assert nodes[0] > 5.0 * fine[0]
    ratios = (HEAVY, 24.0)
    heavy, light = (error_estimate(STANDARD, 1e-6, r, DAMPED).x_percent for r in ratios)
    assert light > 3.0 * heavy


def test_a_method_that_was_not_measured_is_not_trusted():
    largest = max(fixed for fixed, _ in FACTORS.values())
    explicit = replace(STANDARD, integrator="central_difference", damping="none")
    assert steps_factor(explicit) >= largest
    fixed = replace(STANDARD, stepping="fixed")
    assert steps_factor(fixed) > steps_factor(STANDARD)


def test_promises_are_those_of_the_tiers():
    for name, (percent, _) in PROMISES.items():
        assert TIERS[name].promise_percent == percent


@pytest.mark.parametrize(("within", "lines"), [(True, 0), (False, 1)])
def test_a_jump_beyond_its_tier_says_so(within, lines):
    summary = {"x_bar": 5.0, "y_bar": 14.0, "error_estimate_percent": 7.1, "within_tier": within}
    report = scene_report(DRAFT_JUMP, summary)
    told = [text for heading, text in report if heading == "warning" and text]
    expected = "estimated error 7.1 %, more than the 3 % that draft stands for"
    assert told == [expected] * lines
