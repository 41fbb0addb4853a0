"""Outputs: one declaration gives name, unit, meaning and figure, of one or of many."""

from dataclasses import dataclass

import numpy as np

from snapjump.declare.outputs import INTEGER, Outputs, output


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
