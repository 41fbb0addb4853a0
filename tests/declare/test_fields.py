"""What is declared once: fields with defaults and ranges, outputs with unit and meaning."""

from dataclasses import FrozenInstanceError, dataclass, fields, replace

import numpy as np
import pytest

from snapjump.checks import ParameterError
from snapjump.composition import with_tier
from snapjump.declare.fields import Part, choice, flag, integer, number
from snapjump.declare.inputs import inputs_of
from snapjump.declare.outputs import INTEGER, Outputs, output


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
    ("name", "value", "allowed"),
    [
        ("stiffness_N_m", 0.0, "a number in (0, inf) N/m"),
        ("share", 1.5, "a number in [0, 1]"),
        ("share", "much", "a number in [0, 1]"),
        ("elements", 2, "an integer in [3, 10]"),
        ("elements", True, "an integer in [3, 10]"),
        ("kind", "soft", "one of linear, hertz"),
        ("loud", 1, "true or false"),
        ("damping_s", -1.0, "a number in [0, inf) s"),
    ],
)
def test_what_is_not_allowed_is_one_line(name, value, allowed):
    with pytest.raises(ParameterError) as raised:
        Damped(**{name: value})
    assert str(raised.value) == f"contact.{name} = {value!r} is not allowed: {allowed}"


def test_ranges_are_data():
    allowed = {f.name: f.metadata["allowed"] for f in fields(Spring)}
    assert allowed["share"][:3] == (0.0, 1.0, False)
    assert allowed["stiffness_N_m"].unit == "N/m" and allowed["stiffness_N_m"].above
    assert allowed["kind"].words == ("linear", "hertz")


@dataclass(frozen=True)
class Throws(Outputs):
    """Throws of a ball, some of which have failed."""

    speeds: np.ndarray
    how: tuple[str, ...]

    def statuses(self) -> list[str]:
        return list(self.how)

    @output("m", of=("ok",))
    def height_m(self) -> np.ndarray:
        """Height that the ball
        gets to."""
        return self.speeds**2 / 20.0

    @output("1", kind=INTEGER, show="")
    def number(self) -> np.ndarray:
        """Number of the throw."""
        return np.arange(len(self.speeds), dtype=float)


class Spun(Throws):
    @output("rad/s")
    def spin_rad_s(self) -> float:
        """Angular velocity."""
        return 0.5 * self.height_m[0]


def test_a_declaration_says_it_all():
    spin, height, number, status = Spun.declared()
    assert [spin.name, number.name, status.name] == ["spin_rad_s", "number", "status"]
    assert (height.name, height.unit, height.of) == ("height_m", "m", ("ok",))
    assert height.meaning == "Height that the ball gets to"
    assert height.show == "height_m: {}" and number.show == ""


def test_figures_of_many_are_columns_with_nan_where_the_status_has_none():
    throws = Throws(np.array([10.0, 20.0]), ("ok", "lost"))
    columns = throws.columns()
    np.testing.assert_array_equal(columns["height_m"], [5.0, np.nan])
    assert columns["number"].dtype == np.int64
    assert columns["status"].tolist() == ["ok", "lost"]
    assert throws.height_m is throws.height_m  # read once
    assert throws.rows("number", "status")[1] == {"number": 1, "status": "lost"}


def test_figures_of_one_are_plain():
    (figures,) = Spun(np.array([10.0]), ("ok",)).rows()
    assert figures == {"spin_rad_s": 2.5, "height_m": 5.0, "number": 0, "status": "ok"}
    assert [type(figures[key]) for key in ("spin_rad_s", "number", "status")] == [float, int, str]


@pytest.mark.parametrize("path", inputs_of(with_tier("draft")))
def test_many_numbers_are_held_to_the_range_of_one(path):
    allowed = inputs_of(with_tier("draft"))[path].allowed
    ends = [end for end in (allowed.low, allowed.high) if np.isfinite(end)]
    near = [*ends, *np.nextafter(ends, -np.inf), *np.nextafter(ends, np.inf)]
    values = np.array([*near, 0.0, -0.0, 1.0, np.nan, np.inf, -np.inf, -1e300])

    def passes(value):
        try:
            allowed.check(path, value)
        except ParameterError:
            return False
        return True

    assert allowed.allows(values).tolist() == [passes(value) for value in values.tolist()]
