"""Families whose members are found by their files."""

import pytest
from refusals import refused

from snapjump.declare.members import make_member, member_group, member_names


def test_members_are_the_modules_but_for_the_contract():
    assert "mlp" in member_names("surrogate")
    assert "base" not in member_names("surrogate")


def test_a_group_becomes_options_and_back():
    group = {"name": "mlp", "width": 8, "layers": 2}
    assert member_group(make_member("surrogate", group)) == group


@pytest.mark.parametrize(
    ("group", "key"),
    [
        ({"name": "nonesuch"}, "surrogate"),
        ({"name": "base"}, "surrogate"),
        ({"name": "mlp", "width": 8, "layers": 2, "depth": 3}, "surrogate.depth"),
        ({"name": "mlp", "width": 0, "layers": 2}, "surrogate.width"),
        ("mlp", "surrogate"),
    ],
)
def test_bad_groups_are_named(group, key):
    with refused(key):
        make_member("surrogate", group)
