"""What determines a dataset, and what does not."""

import pytest
from refusals import refused
from small_datasets import CONFIG, small

from snapjump.checks import ParameterError
from snapjump.dataset.specification import first_difference, restored, specify
from snapjump.declare.members import member_names

PLAN = {"name": "sobol", "count": 8}


def test_a_plain_specification_tells_everything_again():
    for integrator in member_names("integrator"):
        damping = {"name": "none"} if integrator == "central_difference" else {}
        changes = {"integrator": {"name": integrator}, "damping": damping}
        try:
            specification = small(**changes)
        except ParameterError:  # the tableaux are completed by their YAML files
            continue
        again = restored(specification.plain, CONFIG["backend"])
        assert again.plain == specification.plain
        assert again.simulation == specification.simulation


def test_what_changes_numbers_changes_the_specification():
    base = small()
    changed = [
        small(25),
        small(shard_size=9),
        small(stepping={"name": "adaptive", "tolerance": 2e-5}),
        small(robot={"length_m": 0.021}),
        small(plan={"name": "latin_hypercube", "count": 24, "seed": 1}),
    ]
    assert len({one.sha256 for one in [base, *changed]}) == 6
    # Lanes, design and environment do not.
    others = [small(backend=one) for one in ({"name": "scalar"}, {"name": "lanes", "width": 4})]
    others.append(small(design={"epsilon": 0.3}, environment={"mu": 0.5}))
    assert {one.sha256 for one in others} == {base.sha256}
    assert [a.slope for a in base.axes] == ["delta_alpha", "epsilon", "mass_bar", "mu"]


@pytest.mark.parametrize(
    ("changes", "key"),
    [
        ({"sim": {"name": "snap"}}, "sim"),
        ({"plan": {"name": "dice"}}, "plan"),
        ({"plan": {}}, "plan"),
        ({"plan": 3}, "plan"),
        ({"plan": {**PLAN, "points": 3}}, "plan.points"),
        ({"plan": {**PLAN, "mass_bar": [0.001, 2.0]}}, "plan.mass_bar"),
        ({"robot": {"gravity_m_s2": 0.0}}, "robot.gravity_m_s2"),
        ({"stepping": {"name": "fixed", "step_s": -1.0}}, "stepping.step_s"),
    ],
)
def test_bad_input(changes, key):
    with refused(key):
        small(**changes)


@pytest.mark.parametrize("size", [0, -1, 1.5, True, 1_000_001])
def test_shard_sizes(size):
    with pytest.raises(ParameterError, match=r"dataset\.shard_size"):
        specify({**CONFIG, "plan": PLAN}, size)


def test_shards_are_the_whole_plan():
    specification = small(20, 8)
    stretches = [specification.stretch(number) for number in range(specification.shards)]
    assert stretches == [(0, 8), (8, 16), (16, 20)]


def test_the_first_difference_has_its_key_and_both_values():
    assert first_difference({"a": {"b": 1}}, {"a": {"b": 1.0}}) is None
    assert first_difference({"a": {"b": 1}, "c": 2}, {"a": {"b": 3}}) == ("a.b", 1, 3)
    assert first_difference({"a": 1}, {"a": 1, "d": 2}) == ("d", None, 2)
