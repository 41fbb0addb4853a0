"""The error estimate: what raises it, where it says nothing, and who is told."""

from dataclasses import replace

import numpy as np
import pytest
from reported import DRAFT_JUMP

from experiments.tradeoff.tiers import PROMISES
from snapjump.calibrated import GROUPS, MEMBERS
from snapjump.composition import Simulation, with_tier
from snapjump.declare.families import FAMILIES
from snapjump.declare.inputs import with_inputs
from snapjump.declare.members import member_names
from snapjump.discretization.der import DiscreteElasticRod
from snapjump.drag.quadratic import QuadraticDrag
from snapjump.error_estimate import FACTORS, LEVEL, error_estimate, mesh_percent, steps_factor
from snapjump.scenes.jump_start import composed_model
from snapjump.scenes.march_outputs import side_by_side
from snapjump.show.terminal.scene_report import scene_report
from snapjump.stepping.adaptive import AdaptiveStep
from snapjump.tiers import TIERS

STANDARD = with_tier("standard")
MOUNT = 0.0736  # L, of a pre-compression of 0.2


def models(*simulations):
    """Their models side by side, without any statics."""
    found = [composed_model(one, 0.0, MOUNT, 0.1) for one in simulations]
    return side_by_side(found, range(len(found)), len(found))


def estimated(simulation, *sums):
    alike = models(*[simulation] * len(sums))
    return error_estimate(simulation, alike, np.array(sums, dtype=float))


def of(path, *values):
    """Estimates (%) of x of robots that differ in one input."""
    robots = [with_inputs(STANDARD, {path: value}) for value in values]
    return error_estimate(STANDARD, models(*robots), np.full(len(robots), 5e-4)).x_percent


def test_it_grows_with_the_steps_estimates_and_levels_off():
    found = estimated(STANDARD, 0.0, 1e-5, 1e-4, 1e-2, 10.0)
    assert np.all(np.diff(found.x_percent) > 0.0) and np.all(np.diff(found.y_percent) > 0.0)
    assert found.x_percent[-1] < 1.01 * LEVEL
    assert found.within_tier.tolist() == [True, True, True, False, False]
    np.testing.assert_array_equal(found.percent, np.maximum(found.x_percent, found.y_percent))


def test_without_an_apex_nothing_is_known():
    found = estimated(STANDARD, np.nan)
    assert np.isnan(found.x_percent[0]) and found.within_tier[0] is None


@pytest.mark.parametrize(
    ("path", "easy", "hard"),
    [
        ("environment.mass_bar", 2.0, 0.02),
        ("damping.relaxation_time_s", 2e-5, 5e-7),
        ("drive.rate_rad_s", 5.0, 200.0),
        ("environment.mu", 0.5, 0.9),
        ("robot.mount_height", 1.5e-3, 5e-4),
        ("robot.frame_height_m", 0.01, 0.05),
    ],
)
def test_what_makes_a_robot_hard(path, easy, hard):
    robots = [with_inputs(STANDARD, {path: value}) for value in (easy, hard)]
    alike = [composed_model(one, 0.0, height(one), 0.1) for one in robots]
    found = error_estimate(STANDARD, side_by_side(alike, range(2), 2), np.full(2, 5e-4))
    assert found.x_percent[1] > 1.8 * found.x_percent[0]


@pytest.mark.parametrize("side", [-1.0, 1.0])
def test_what_throws_against_the_mismatch_makes_x_alone_harder(side):
    """An offset of 2 mm is a quarter of half the clear span, less what the beam's ends take off."""
    robots = [
        with_inputs(STANDARD, {"design.delta_alpha": side * lag, "frame.mass_centre_offset_m": c})
        for lag, c in ((0.1, 0.0), (0.1, side * 2e-3), (0.1, -side * 2e-3), (1e-3, -side * 2e-3))
    ]
    found = error_estimate(STANDARD, models(*robots), np.full(4, 5e-4))
    ratios = found.x_percent / found.x_percent[0]
    assert ratios[[0, 1, 3]].tolist() == [1.0, 1.0, 1.0]
    assert 0.95 * 0.25 / 0.08 < ratios[2] < 0.25 / 0.08
    assert len(set(found.y_percent)) == 1


def height(simulation):
    given = simulation.robot.mount_height
    return MOUNT if isinstance(given, str) else given / simulation.robot.length_m


def test_meshes_and_clamps():
    coarse, fine = (mesh_percent(DiscreteElasticRod(elements=n)) for n in (32, 128))
    assert coarse[0] > 16.0 * fine[0] and coarse[1] > 16.0 * fine[1]
    nodes = mesh_percent(DiscreteElasticRod(elements=128, clamp="two_nodes"))
    assert nodes[0] > 5.0 * fine[0]


def test_a_method_that_was_not_measured_says_nothing():
    explicit = replace(STANDARD, integrator="central_difference", damping="none")
    assert "central_difference" not in FACTORS and np.isnan(steps_factor(explicit))
    found = estimated(replace(STANDARD, integrator="central_difference", damping="none"), 1e-4)
    assert found.within_tier[0] is None and found.because[0]
    fixed = replace(STANDARD, stepping="fixed")
    assert steps_factor(fixed) > steps_factor(STANDARD)


UNKNOWN = [
    ("contact", "signorini"), ("friction", "lagged"), ("damping", "none"),
    ("damping", "mass_proportional"), ("frame", "elastic"), ("drive", "smooth_start"),
]  # fmt: skip


@pytest.mark.parametrize(("family", "member"), UNKNOWN)
def test_members_that_were_not_calibrated_say_nothing(family, member):
    integrator = "implicit_euler" if member == "signorini" else "generalized_alpha"
    simulation = with_tier("standard", **{family: member, "integrator": integrator})
    found = estimated(simulation, 1e-4)
    assert found.within_tier[0] is None and f"{family}={member}" in found.because[0]


@pytest.mark.parametrize(
    ("family", "member"), [("drag", QuadraticDrag), ("stepping", AdaptiveStep)]
)
def test_a_law_of_ones_own_says_nothing(family, member):
    class Own(member):
        """Of this file, after which it is called."""

    found = estimated(replace(STANDARD, **{family: Own()}), 1e-4)
    assert found.within_tier[0] is None and f"{family}=test_error_estimate" in found.because[0]


def test_drag_is_known_as_far_as_it_was_calibrated():
    model = composed_model(STANDARD, 0.0, MOUNT, 0.1)
    known = replace(STANDARD, drag="quadratic")
    airy = [model._replace(drag=QuadraticDrag.Law(share)) for share in (0.0, 0.099, 0.101, np.nan)]
    found = error_estimate(known, side_by_side(airy, range(4), 4), np.full(4, 1e-5))
    assert found.within_tier.tolist() == [True, True, None, None]
    assert found.x_percent[1] == estimated(STANDARD, 1e-5).x_percent[0]
    assert "drag" in found.because[2]


def test_no_family_is_forgotten():
    apart = {"sim", "backend", "integrator"}  # which has FACTORS; the others solve the same
    assert set(FAMILIES) - set(MEMBERS) == apart


def test_every_member_is_calibrated_or_says_nothing():
    # With which nothing jumps, and what needs a file.
    apart = {
        ("frame", "fixed"),
        ("contact", "none"),
        ("drive", "unload"),
        ("drive", "hold_release"),
    }
    apart |= {("drive", "table")}
    names = {(family, name) for family in MEMBERS for name in member_names(family)}
    known = {(family, name) for family, some in MEMBERS.items() for name in some}
    assert names - known - apart == set(UNKNOWN)


@pytest.mark.parametrize("start", [0.5, 0.85])
def test_a_start_that_leaves_out_loading_says_nothing(start):
    late = replace(STANDARD, sim=STANDARD.sim.changed(start_fraction=start))
    assert estimated(late, 1e-4).within_tier[0] is None


@pytest.mark.parametrize(
    ("path", "value"),
    [
        ("environment.mass_bar", 0.0101),
        ("environment.mu", 3.0),
        ("damping.relaxation_time_s", 0.0),
        ("damping.relaxation_time_s", 1e-8),
        ("drive.rate_rad_s", 2000.0),
        ("drive.right_rate_rad_s", 10.0),
        ("contact.stiffness_N_m", 1e12),
        ("friction.velocity_threshold_m_s", 1.0),
        ("friction.velocity_threshold_m_s", 1e-6),
        ("environment.slope_rad", 0.25),
        ("contact.distance_m", 1e-5),
        ("robot.frame_height_m", 0.2),
    ],
)
def test_robots_beyond_what_was_calibrated_say_nothing(path, value):
    beyond = with_inputs(STANDARD, {path: value})
    known, found = (
        error_estimate(STANDARD, models(one), np.full(1, 1e-4)) for one in (STANDARD, beyond)
    )
    assert (*known.within_tier, *found.within_tier) == (True, None)
    assert known.because[0] == "" and "outside" in found.because[0]
    assert np.isnan(found.x_percent[0]) and np.isnan(found.y_percent[0])


@pytest.mark.parametrize("delta_alpha", [-0.4, 0.4])
def test_a_mismatch_of_more_than_half_the_snap_says_nothing(delta_alpha):
    beyond = with_inputs(
        STANDARD, {"design.delta_alpha": delta_alpha, "design.epsilon": 0.1}
    )  # which snaps at 0.64 rad
    found = error_estimate(STANDARD, models(beyond), np.full(1, 1e-4))
    assert found.within_tier.tolist() == [None] and "mismatch" in found.because[0]


@pytest.mark.parametrize(
    ("loss", "residual", "told"),
    [
        (0.03, 0.7, [True, False, None]),
        (0.5, 0.1, [False, False, None]),
        (-0.5, 0.1, [False, False, None]),
        (0.03, 3.0, [False, False, None]),
        (np.nan, 0.1, [True, False, None]),
    ],
)
def test_energy_and_forces_out_of_balance_keep_no_promise(loss, residual, told):
    found = estimated(STANDARD, 1e-5, 1.0, np.nan).balanced(loss, np.array([residual]))
    assert found.within_tier.tolist() == told


def test_the_default_robot_is_well_inside_every_range():
    model = composed_model(Simulation(), 0.0, MOUNT, 0.1)
    for group in GROUPS:
        assert group.low <= group.read(model) <= 0.5 * group.high, group.meaning


def test_promises_are_those_of_the_tiers():
    for name, (percent, _) in PROMISES.items():
        assert TIERS[name].promise_percent == percent


@pytest.mark.parametrize(("within", "lines"), [(True, 0), (False, 1)])
def test_a_jump_beyond_its_tier_says_so(within, lines):
    summary = {"x_bar": 5.0, "y_bar": 14.0, "error_estimate_percent": 7.1, "within_tier": within}
    report = scene_report(DRAFT_JUMP, summary)
    told = [text for heading, text in report if heading == "warning" and text]
    expected = "estimated error 7.1 %, which may be more than the 3 % that draft stands for"
    assert told == [expected] * lines


def test_a_jump_that_does_not_know_its_error_prints_no_tiers_line():
    summary = {"x_bar": 5.0, "y_bar": 14.0, "error_estimate_percent": None, "within_tier": None,
               "error_unknown_because": "friction coefficient outside [0, 1.2]"}  # fmt: skip
    lines = dict(scene_report(DRAFT_JUMP, summary))
    assert lines["accuracy"] == (
        "draft: numerical error not known here (friction coefficient outside [0, 1.2])"
    )
