"""What must hold for every single run, whatever its numbers: no hang, NaN, negative gap, or lie."""

import math
from collections.abc import Mapping, Sequence
from typing import Any

from experiments.stability.jumps import KNOWN, REFUSED
from snapjump.studies.base import Row

Key = tuple[Any, Any, int]  # across, up, design
LONGEST_S = 120.0  # of a batch
SILENT = 3.0  # times the tier's promise: a larger true error must be flagged
OPEN_LAWS = ("logbarrier",)

RULES = {
    "hung": "did not end within its bound of iterations and time",
    "not_finite": "a NaN with a status that promises numbers",
    "negative_gap": "a gap that the barrier keeps open became negative",
    "silent": "a wrong answer that is not marked",
}


def with_truth(rows: Sequence[Row], truth: Sequence[Row], own: bool) -> list[Row]:
    """The rows with ``true_error_percent`` (of x and y, the larger), where the truth is known."""
    known = {key(row, own): row for row in truth if row.get("status") in KNOWN}
    found = []
    for row in rows:
        best = known.get(key(row, own))
        errors = {}
        if best is not None and row.get("status") in KNOWN:
            x, y = true_errors(row, best)
            errors = {"true_x_percent": x, "true_y_percent": y, "true_error_percent": max(x, y)}
        found.append({**row, **errors})
    return found


def key(row: Row, own: bool) -> Key:
    """What a row's truth is found by."""
    return (row["across"], row["up"], row["design"]) if own else (None, None, row["design"])


def true_errors(row: Mapping[str, Any], best: Mapping[str, Any]) -> tuple[float, float]:
    """Errors of x and y (%), those of x relative to max(|x|, 0.1 y).

    A robot that does not jump ends within its own size: its errors are relative to L. To take a
    jump for none, or the reverse, is infinitely wrong.
    """
    if row["status"] != best["status"]:
        return math.inf, math.inf
    x_scale, y_scale = max(abs(best["x_bar"]), 0.1 * best["y_bar"]), best["y_bar"]
    if row["status"] == "no_jump":
        x_scale = y_scale = 1.0
    x = 100.0 * abs(row["x_bar"] - best["x_bar"]) / x_scale
    return x, 100.0 * abs(row["y_bar"] - best["y_bar"]) / y_scale


def broken(row: Row, most_iterations: float, promise_percent: float, law: str) -> list[str]:
    """The rules that a row breaks."""
    found: list[str] = []
    if row["status"] == REFUSED:
        return found
    if row["newton_iterations"] > most_iterations or row["seconds"] > LONGEST_S:
        found.append("hung")
    if row["status"] in KNOWN and not all(
        is_number(row.get(k)) for k in ("x_bar", "y_bar", "x_error_estimate_percent")
    ):
        found.append("not_finite")
    if law in OPEN_LAWS and is_number(row.get("min_gap_m")) and row["min_gap_m"] < 0.0:
        found.append("negative_gap")
    wrong = row.get("true_error_percent")
    if wrong is not None and wrong > SILENT * promise_percent and row["within_tier"]:
        found.append("silent")
    return found


def is_number(value: Any) -> bool:
    """Whether it is a finite number."""
    return isinstance(value, (int, float)) and math.isfinite(value)
