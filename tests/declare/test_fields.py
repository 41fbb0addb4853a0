"""Declared fields: defaults, ranges as data, one line for what is not allowed."""

from dataclasses import FrozenInstanceError, fields, replace

import pytest

from snapjump.checks import ParameterError
from snapjump.declare.fields import Part, choice, flag, integer, number


class Spring(Part):
    """A spring."""

    group = "contact"

    stiffness_N_m: float = number(1e5, above=0.0, unit="N/m")
    share: float = number(0.5, least=0.0, most=1.0)
    elements: int = integer(8, least=3, most=10)
    kind: str = choice("linear", ("linear", "hertz"))
    loud: bool = flag(False)


class Damped(Spring):
    """A spring with a damper."""

    damping_s: float = number(0.0, least=0.0, unit="s")


def test_defaults_and_equality():
    assert Spring() == Spring(1e5, 0.5, 8, "linear", False)
    assert replace(Spring(), share=1.0).share == 1.0
    assert [f.name for f in fields(Damped)][-1] == "damping_s"
    with pytest.raises(FrozenInstanceError):
        Spring().share = 0.1  # type: ignore[misc]


@pytest.mark.parametrize(
    ("values", "line"),
    [
        (
            {"stiffness_N_m": 0.0},
            "contact.stiffness_N_m = 0.0 is not allowed: a number in (0, inf) N/m",
        ),
        ({"share": 1.5}, "contact.share = 1.5 is not allowed: a number in [0, 1]"),
        ({"share": "much"}, "contact.share = 'much' is not allowed: a number in [0, 1]"),
        ({"elements": 2}, "contact.elements = 2 is not allowed: an integer in [3, 10]"),
        ({"elements": True}, "contact.elements = True is not allowed: an integer in [3, 10]"),
        ({"kind": "soft"}, "contact.kind = 'soft' is not allowed: one of linear, hertz"),
        ({"loud": 1}, "contact.loud = 1 is not allowed: true or false"),
        ({"damping_s": -1.0}, "contact.damping_s = -1.0 is not allowed: a number in [0, inf) s"),
    ],
)
def test_what_is_not_allowed_is_one_line(values, line):
    with pytest.raises(ParameterError) as raised:
        Damped(**values)
    assert str(raised.value) == line


def test_ranges_are_data():
    allowed = {f.name: f.metadata["allowed"] for f in fields(Spring)}
    assert allowed["share"][:3] == (0.0, 1.0, False)
    assert allowed["stiffness_N_m"].unit == "N/m" and allowed["stiffness_N_m"].above
    assert allowed["kind"].words == ("linear", "hertz")
