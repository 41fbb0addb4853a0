"""Parts of a simulation as users give them: options, names, groups; what is misplaced is told."""

import re
from pathlib import Path

import pytest

import snapjump
from snapjump import Design, Environment, Robot, simulate_jump
from snapjump.checks import ParameterError
from snapjump.composition import Simulation, with_tier
from snapjump.contact.penalty import Penalty

SOFT = Penalty(stiffness_N_m=2e4)


@pytest.mark.parametrize("contact", [SOFT, {"name": "penalty", "stiffness_N_m": 2e4}])
def test_parts_are_options_or_groups(contact):
    assert with_tier("draft", contact=contact) == with_tier("draft", contact=SOFT)


def test_a_group_without_a_name_changes_what_would_be_there():
    found = with_tier("draft", friction={"velocity_threshold_m_s": 1e-4}, robot={"length_m": 0.03})
    assert found.friction.name == "implicit" and found.friction.velocity_threshold_m_s == 1e-4
    assert found.robot == Robot(length_m=0.03)
    # What the group leaves out is the tier's, as of options that leave it out.
    assert with_tier("draft", stepping={"stick_share": 3.0}).stepping.tolerance == 6e-6


@pytest.mark.parametrize(
    ("parts", "told"),
    [
        ({"mu": 0.5}, r"mu = 0\.5 is not allowed: did you mean environment\.mu\?"),
        ({"epsilon": 0.5}, r"did you mean design\.epsilon\?"),
        ({"length": 0.5}, r"did you mean robot\.length_m\?"),
        ({"colour": "red"}, r"colour = 'red' is not allowed: one of sim, robot, design"),
        ({"contact": "penalti"}, r"contact = 'penalti' is not allowed: one of hunt_crossley"),
        ({"contact": Design()}, r"contact = .* the name of a member of contact"),
        ({"contact": 3}, r"contact = 3 is not allowed"),
        ({"robot": Design()}, r"robot = .* a Robot, or a mapping"),
        ({"design": {"eps": 0.1}}, r"design\.eps = 0\.1 is not allowed: design has epsilon"),
        ({"contact": {"name": "penalty", "d": 1}}, r"contact\.d = 1 is not allowed"),
    ],
)
def test_what_is_no_part_is_told_in_one_line(parts, told):
    with pytest.raises(ParameterError, match=told) as refused:
        with_tier("draft", **parts)
    assert "\n" not in str(refused.value)


def test_a_misplaced_design_is_told():
    with pytest.raises(ParameterError, match="robot = .* a Robot"):
        simulate_jump(Design(), environment=Environment())  # type: ignore[arg-type]


def test_members_by_name():
    assert Simulation(contact="penalty").contact == Penalty()


def test_the_front_page_is_whole():
    for name in snapjump.__all__:
        assert getattr(snapjump, name) is not None and name in dir(snapjump)
    typed = re.findall(r"import (\w+) as \1", Path(snapjump.__file__).read_text())
    assert sorted(typed) == sorted(snapjump.__all__)
    with pytest.raises(AttributeError, match="has no attribute 'nothing'"):
        _ = snapjump.nothing


def test_the_version_is_told(command):
    assert command("--version").stdout.strip() == f"snapjump {snapjump.__version__}"
