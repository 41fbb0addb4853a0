"""How the answer moves with what is modelled, beside what numerics contribute."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from experiments.compositions import Groups, changed, has_field
from experiments.errors import percentile, relative_errors
from experiments.tradeoff.points import Point, split
from snapjump.studies.base import OK, Done

# Family, key, symbol, and its values: factors of the configured value, or values as such.
FACTORS = (
    ("contact", "distance_m", "d_hat", (0.5, 2.0)),
    ("contact", "stiffness_N_m", "K", (0.1, 10.0)),
)
VALUES = (
    ("damping", "relaxation_time_s", "eta", (0.0, 1e-6, 1e-5, 1e-4), "s"),
    ("friction", "velocity_threshold_m_s", "eps_v", (1e-5, 1e-4, 1e-3), "m/s"),
    ("contact", "damping_s", "contact damping", (0.0, 1e-7, 1e-6, 1e-5), "s"),
)
DEFAULT = "as configured"


def models(base: Groups) -> dict[str, Groups]:
    """The configured model first, then each that differs from it in one number."""
    found = {DEFAULT: base}
    for family, key, symbol, factors in FACTORS:
        if has_field(base, family, key):
            for factor in factors:
                value = float(base[family][key]) * factor
                found[f"{symbol} x {factor:g}"] = changed(base, {family: {key: value}})
    for family, key, symbol, values, unit in VALUES:
        if has_field(base, family, key):
            for value in values:
                if value != base[family].get(key, 0.0):
                    name = f"{symbol} = {value:g} {unit}"
                    found[name] = changed(base, {family: {key: value}})
    return found


def shifts(done: Mapping[str, Done]) -> list[dict[str, Any]]:
    """How far x and y move (%), for each model, from the configured one; failures are infinite."""
    x0, y0 = split(done[DEFAULT])["design"]
    rows = []
    for name, cell in done.items():
        if name == DEFAULT:
            continue
        row: dict[str, Any] = {"source": name, "kind": "model"}
        if cell.status == OK:
            x, y = split(cell)["design"]
            row |= _figures(*relative_errors(x, y, x0, y0))
        rows.append(row)
    return sorted(rows, key=lambda row: -row.get("x_median_percent", 0.0))


def tier_errors(points: Mapping[str, Point]) -> list[dict[str, Any]]:
    """The tiers' numerical errors in the same columns; ``paper`` is another model, too."""
    return [
        {
            "source": f"tier {name}",
            "kind": "numerics" if name != "paper" else "numerics and model",
            "x_median_percent": point.x_median_percent,
            "x_p95_percent": point.x_p95_percent,
            "y_median_percent": point.y_median_percent,
            "y_p95_percent": point.y_p95_percent,
        }
        for name, point in points.items()
    ]


def _figures(x: Any, y: Any) -> dict[str, float]:
    figures = {
        "x_median_percent": percentile(np.asarray(x), 50.0),
        "x_p95_percent": percentile(np.asarray(x), 95.0),
        "y_median_percent": percentile(np.asarray(y), 50.0),
        "y_p95_percent": percentile(np.asarray(y), 95.0),
    }
    return {key: value for key, value in figures.items() if np.isfinite(value)}
