"""Rules for every single run, whatever its numbers: no hang, NaN, negative gap, unmarked error."""

import math
from collections.abc import Mapping, Sequence
from functools import cache
from typing import Any

from snapjump.checks import is_finite_number
from snapjump.declare.members import make_member
from snapjump.robot.robot import Robot
from snapjump.run.studies.base import REFUSED, Row
from snapjump.scenes.jump_outputs import ENDED

from ..errors import scale_of_x

Key = tuple[Any, Any, int]  # across, up, design
LONGEST_S = 120.0  # of a batch
SILENT = 3.0  # times the tier's promise: a larger true error must be flagged
RULES = {
    "hung": "did not end within its bound of iterations and time",
    "not_finite": "a NaN with a status that promises numbers",
    "negative_gap": "a gap that the barrier keeps open became negative",
    "silent": "a wrong answer that is not marked",
}


def with_truth(rows: Sequence[Row], truth: Sequence[Row], own: bool) -> list[Row]:
    """The rows with ``true_error_percent`` (of x and y, the larger), where the truth is known."""
    known = {key(row, own): row for row in truth if row["status"] in ENDED}
    found = []
    for row in rows:
        best = known.get(key(row, own))
        errors = {}
        if best is not None and row["status"] in ENDED:
            x, y = true_errors(row, best)
            errors = {"true_x_percent": x, "true_y_percent": y, "true_error_percent": max(x, y)}
        found.append({**row, **errors})
    return found


def key(row: Row, own: bool) -> Key:
    """The key of a row's truth."""
    return (row["across"], row["up"], row["design"]) if own else (None, None, row["design"])


def true_errors(row: Mapping[str, Any], best: Mapping[str, Any]) -> tuple[float, float]:
    """Errors of x and y (%), those of x relative to max(|x|, 0.1 y).

    A robot that does not jump ends within its own size: its errors are relative to L. To take a
    jump for none, or the reverse, is infinitely wrong.
    """
    if row["status"] != best["status"]:
        return math.inf, math.inf
    x_scale, y_scale = float(scale_of_x(best["x_bar"], best["y_bar"])), best["y_bar"]
    if row["status"] == "no_jump":
        x_scale = y_scale = 1.0
    x = 100.0 * abs(row["x_bar"] - best["x_bar"]) / x_scale
    return x, 100.0 * abs(row["y_bar"] - best["y_bar"]) / y_scale


@cache
def keeps_open(law: str) -> bool:
    """Whether a contact law needs positive gaps."""
    return bool(make_member("contact", {"name": law}).law(Robot().scales).keeps_open())


def broken(row: Row, most_iterations: float, promise_percent: float, law: str) -> list[str]:
    """The rules that a row breaks."""
    if row["status"] == REFUSED:
        return []
    told = ("x_error_estimate_percent",) if row["within_tier"] is not None else ()
    numbers = all(is_finite_number(row.get(k)) for k in ("x_bar", "y_bar", *told))
    wrong = row.get("true_error_percent", 0.0)
    gap = row.get("min_gap_m")
    sunk = gap is not None and -math.inf < gap < 0.0
    breaks = {
        "hung": row["newton_iterations"] > most_iterations or row["seconds"] > LONGEST_S,
        "not_finite": row["status"] in ENDED and not numbers,
        "negative_gap": sunk and keeps_open(law),
        "silent": wrong > SILENT * promise_percent and row["within_tier"],
    }
    return [rule for rule in RULES if breaks[rule]]
