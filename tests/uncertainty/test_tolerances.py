"""The table of tolerances: its defaults, rows of one's own, and what is refused."""

import pytest
from hydra_config import CONF
from refusals import refused

from snapjump.composition import Simulation
from snapjump.declare.inputs import inputs_of
from snapjump.uncertainty.parts.tolerances import DEFAULTS, KEY, LAWS, Choice, Tolerance, checked


def test_the_defaults_are_inputs_of_the_default_robot_or_families():
    known = {*inputs_of(Simulation()), *LAWS}
    assert set(DEFAULTS) <= known and checked(None) == checked({})
    assert [*checked(None)] == [*DEFAULTS]


def test_the_file_tells_the_defaults():
    text = (CONF / "uncertainty" / "model.yaml").read_text()
    for name, row in DEFAULTS.items():
        (how,) = row
        after = text.partition(name)[2]
        assert after, name
        if how != "members":
            assert float(after.partition(how)[2].split()[0].rstrip(",")) == row[how], name


def test_ends_of_a_tolerance():
    assert Tolerance("factor", 4.0).ends(2.0) == (0.5, 8.0)
    assert Tolerance("relative", 0.5).ends(-2.0) == (-3.0, -1.0)
    assert Tolerance("absolute", 0.25).ends(2.0) == (1.75, 2.25)
    assert Tolerance("factor", 4.0).ends(-2.0) == (-8.0, -0.5)


def test_rows_of_one_s_own_come_beside_the_defaults_and_in_their_place():
    given = {
        "robot.thickness_m": {"absolute": 1e-6},
        "environment.mu": {"relative": 0.1},
        "contact.distance_m": None,
        "contact": {"members": ["penalty", "logbarrier"]},
    }
    found = checked(given)
    assert found["robot.thickness_m"] == Tolerance("absolute", 1e-6)
    assert found["environment.mu"] == Tolerance("relative", 0.1)
    assert found["contact"] == Choice(("penalty", "logbarrier"))
    assert "contact.distance_m" not in found
    assert found["contact.stiffness_N_m"] == Tolerance("factor", 3.0)


def test_inputs_of_other_members_are_known():
    assert checked({"contact.restitution": {"absolute": 0.1}})


@pytest.mark.parametrize(
    ("row", "key", "words"),
    [
        ({"robot.thicknes_m": {"relative": 0.1}}, KEY, ["robot.thicknes_m", "robot.thickness_m"]),
        ({"robot.thicknes_m": None}, KEY, ["robot.thicknes_m"]),
        ({"integrator": {"members": ["bdf2"]}}, KEY, ["integrator", "contact"]),
        ({3: {"relative": 0.1}}, KEY, ["3"]),
        ({"robot.thickness_m": 0.1}, f"{KEY}.robot.thickness_m", ["0.1", "{relative: ...}"]),
        ({"robot.thickness_m": {}}, f"{KEY}.robot.thickness_m", ["{}"]),
        ({"robot.thickness_m": {"percent": 2}}, f"{KEY}.robot.thickness_m", ["percent"]),
        ({"robot.thickness_m": {"members": ["a"]}}, f"{KEY}.robot.thickness_m", ["members"]),
        (
            {"robot.thickness_m": {"relative": 0.1, "absolute": 1e-6}},
            f"{KEY}.robot.thickness_m",
            ["one of"],
        ),
        (
            {"robot.thickness_m": {"relative": 1.0}},
            f"{KEY}.robot.thickness_m.relative",
            ["(0, 0.99]"],
        ),
        ({"robot.width_m": {"factor": 1.0}}, f"{KEY}.robot.width_m.factor", ["(1, 1e+06]"]),
        ({"robot.width_m": {"absolute": "wide"}}, f"{KEY}.robot.width_m.absolute", ["'wide'"]),
        ({"contact": {"factor": 2.0}}, f"{KEY}.contact", ["{members: [...]}"]),
        ({"contact": {"members": ["soft"]}}, f"{KEY}.contact.members", ["soft", "penalty"]),
        ({"contact": {"members": []}}, f"{KEY}.contact.members", ["penalty"]),
        ({"contact": {"members": "penalty"}}, f"{KEY}.contact.members", ["a list of"]),
    ],
)
def test_what_is_no_row_is_told_in_one_line(row, key, words):
    with refused(key, *words):
        checked(row)
