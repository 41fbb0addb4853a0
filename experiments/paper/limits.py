"""Every verdict's limit: what decides on a statement, up to where, and whose limit that is.

They stand in ``limits.yaml``, which says what its words mean.
"""

import math
from collections.abc import Mapping
from pathlib import Path
from typing import NamedTuple

import yaml

from .base import Row, verdict


class Limit(NamedTuple):
    """``confirmed``: the most (with ``at_least`` the least) that what is measured may be if the
    statement is confirmed, ``within``: if it is confirmed within a limit; ``of``: what is measured,
    and its unit; ``source``: the paper's words, or why it is ours."""

    confirmed: float
    within: float
    of: str
    source: str
    at_least: bool = False

    def holds(self, value: float, limit: float) -> bool:
        """Whether a value keeps one of the two; NaN keeps none."""
        return value >= limit if self.at_least else value <= limit


def read_limits(module: str) -> dict[str, Limit]:
    """The limits in ``limits.yaml`` beside a module, given by its ``__file__``."""
    rows = yaml.safe_load(Path(module).with_name("limits.yaml").read_text(encoding="utf-8"))
    return {key: Limit(**row) for key, row in rows.items()}


LIMITS = read_limits(__file__)


def judged(key: str, *values: float) -> str:
    """The verdict by one of the paper's limits."""
    return verdict_by(LIMITS[key], *values)


def verdict_by(limit: Limit, *values: float) -> str:
    """The verdict by a limit, on the worst of the values: what is not within it is not confirmed,
    also where any value would do for the rest."""
    within = all(limit.holds(value, limit.within) for value in values)
    return verdict(within and all(limit.holds(value, limit.confirmed) for value in values), within)


def limit_rows(limits: Mapping[str, Limit] = LIMITS) -> list[Row]:
    """The table of limits."""

    def told(limit: Limit, value: float) -> str:
        words = "at least" if limit.at_least else "at most"
        return f"{words} {value:.4g}" if math.isfinite(value) else "any"

    return [
        {
            "of": f"`{key}`",
            "what is measured": limit.of,
            "confirmed": told(limit, limit.confirmed),
            "within a limit": told(limit, limit.within),
            "source": limit.source,
        }
        for key, limit in limits.items()
    ]
