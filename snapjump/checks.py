"""Checks of what users pass in: one clear error that names the key, the value and the range."""

import math
import numbers
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from typing import Any

LONGEST = 80  # characters of a value that an error shows


class ParameterError(ValueError):
    """A parameter has a wrong type or lies outside its range; the message is one line."""

    def __init__(self, key: str, value: Any, allowed: str):
        self.key, self.value, self.allowed = key, value, allowed
        name = key if len(key) <= LONGEST else f"{key[:LONGEST]} ..."
        super().__init__(f"{name} = {shown(value)} is not allowed: {allowed}")


@contextmanager
def of_ours(refused: Callable[[str], ParameterError]) -> Iterator[None]:
    """Turn whatever a file's content raises in the block into one refusal: it is not ours.
    ``refused``: makes the refusal of a reason in a few words."""
    try:
        yield
    except ParameterError:
        raise
    except Exception as error:
        reason = " ".join(f"{type(error).__name__}: {error}".split())
        raise refused(f"what it says is not of snapjump ({reason[:LONGEST]})") from error


def shown(value: Any) -> str:
    """A value in one line, the middle of a long one left out."""
    try:
        text = " ".join(repr(value).split())
    except ValueError:  # an integer with thousands of digits
        text = f"a huge {type(value).__name__}"
    return text if len(text) <= LONGEST else f"{text[: LONGEST - 20]} ... {text[-15:]}"


def is_finite_number(value: Any) -> bool:
    """Whether it is a number that a float can hold, of Python or numpy; truth values are none."""
    if isinstance(value, bool) or not isinstance(value, numbers.Real):
        return False
    return bool(abs(value) <= sys.float_info.max)  # type: ignore[operator]


def check_number(
    key: str,
    value: Any,
    low: float = -math.inf,
    high: float = math.inf,
    *,
    above: bool = False,
    unit: str = "",
) -> None:
    """Require a finite real number in [low, high], or in (low, high] when ``above``."""
    unit = f" {unit}" if unit else ""
    bracket = "(" if above or low == -math.inf else "["
    closing = ")" if high == math.inf else "]"
    allowed = f"a number in {bracket}{low:g}, {high:g}{closing}{unit}"
    if not is_finite_number(value):
        raise ParameterError(key, value, allowed)
    if value < low or value > high or (above and value == low):
        raise ParameterError(key, value, allowed)


def check_integer(key: str, value: Any, low: int, high: int) -> None:
    """Require an integer in [low, high]."""
    is_integer = isinstance(value, numbers.Integral) and not isinstance(value, bool)
    if not is_integer or not low <= value <= high:
        raise ParameterError(key, value, f"an integer in [{low}, {high}]")


def check_choice(key: str, value: Any, choices: Sequence[str]) -> None:
    """Require one of the given words."""
    if not isinstance(value, str) or value not in choices:
        raise ParameterError(key, value, "one of " + ", ".join(choices))


def check_text(key: str, value: Any, allowed: str) -> None:
    """Require a text that is not empty."""
    if not isinstance(value, str) or not value:
        raise ParameterError(key, value, allowed)


def check_group(key: str, value: Any) -> None:
    """Require a group of values by their names."""
    if not isinstance(value, Mapping):
        raise ParameterError(key, value, "a group of values by their names")
