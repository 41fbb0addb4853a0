"""Every verdict's limit: what decides on a statement, up to where, and whose limit that is.

They stand in ``limits.yaml``, which says what its words mean.
"""

import math
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


ROWS = yaml.safe_load(Path(__file__).with_name("limits.yaml").read_text(encoding="utf-8"))
LIMITS = {key: Limit(**row) for key, row in ROWS.items()}


def judged(key: str, *values: float) -> str:
    """The verdict by one limit, on the worst of the values: what is not within it is not confirmed,
    also where any value would do for the rest."""
    limit = LIMITS[key]
    within = all(limit.holds(value, limit.within) for value in values)
    return verdict(within and all(limit.holds(value, limit.confirmed) for value in values), within)


def limit_rows() -> list[Row]:
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
        for key, limit in LIMITS.items()
    ]
