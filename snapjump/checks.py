"""Checks of what users pass in: one clear error that names the key, the value and the range."""

import math
from collections.abc import Sequence
from typing import Any


class ParameterError(ValueError):
    """A parameter has a wrong type or lies outside its range; the message is one line."""

    def __init__(self, key: str, value: Any, allowed: str):
        self.key, self.value, self.allowed = key, value, allowed
        super().__init__(f"{key} = {value!r} is not allowed: {allowed}")


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
    if isinstance(value, bool) or not isinstance(value, (int, float)) or not math.isfinite(value):
        raise ParameterError(key, value, allowed)
    if value < low or value > high or (above and value == low):
        raise ParameterError(key, value, allowed)


def check_integer(key: str, value: Any, low: int, high: int) -> None:
    """Require an integer in [low, high]."""
    if isinstance(value, bool) or not isinstance(value, int) or not low <= value <= high:
        raise ParameterError(key, value, f"an integer in [{low}, {high}]")


def check_choice(key: str, value: Any, choices: Sequence[str]) -> None:
    """Require one of the given words."""
    if value not in choices:
        raise ParameterError(key, value, "one of " + ", ".join(choices))
