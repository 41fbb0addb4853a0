from typing import Any, NamedTuple

import pytest
from numba import njit
from numba.core.errors import NumbaError

from snapjump.number.dispatch import family_function, member_class


class Circle(NamedTuple):
    radius: float


class Square(NamedTuple):
    side: float
    turn: float


class Point(NamedTuple):
    pass


class Stranger(NamedTuple):
    radius: float


@family_function
def area(shape: Any, scale: Any) -> Any:
    """Area of a shape."""


@area.member(Circle)
def _circle(shape: Circle, scale: Any) -> Any:
    return 3.0 * shape.radius * shape.radius * scale


@area.member(Square)
def _square(shape: Square, scale: Any) -> Any:
    return shape.side * shape.side * scale


@area.member(Point)
def _point(shape: Point, scale: Any) -> Any:
    return 0.0 * scale


@njit
def compiled_area(shape, scale):
    return area(shape, scale)


@pytest.mark.parametrize(
    ("shape", "expected"), [(Circle(2.0), 24.0), (Square(3.0, 1.0), 18.0), (Point(), 0.0)]
)
def test_the_class_chooses_in_python_and_in_numba_alike(shape, expected):
    assert area(shape, 2.0) == compiled_area(shape, 2.0) == expected


def test_members_of_equal_layout_are_told_apart():
    with pytest.raises(KeyError):
        area(Stranger(2.0), 2.0)
    with pytest.raises(NumbaError):
        compiled_area(Stranger(2.0), 2.0)


def test_declaration_keeps_its_name_and_docstring():
    assert area.__name__ == "area"
    assert area.__doc__ == "Area of a shape."
    assert set(area.versions) == {Circle, Square, Point}


def test_member_class_sees_through_numba_types():
    import numba

    assert member_class(numba.typeof(Circle(1.0))) is Circle
    assert member_class(Circle) is Circle
