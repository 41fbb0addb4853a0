"""The error estimate against true errors: what its factors are fitted to, and how well it keeps."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from snapjump.arrays import Array
from snapjump.run.studies.base import Row
from snapjump.scenes.jump_outputs import ENDED

from ..compositions import Groups, changed
from ..errors import percentile
from ..tradeoff.tiers import tier_groups

TIERS = ("draft", "standard")
FIXED_STEPS = (1e-6, 3e-6, 1e-5, 3e-5, 1e-4)
TOLERANCES = (1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3)
ADAPTIVE = ("generalized_alpha", "tr_bdf2", "sdirk2")
ELEMENTS = (24, 32, 40, 56, 72, 104, 152)
ESTIMATE = "x_error_estimate_percent"
WITHIN = 2.0  # of the estimate, for COVERED of the designs
COVERED = 0.95
TIGHT = {"name": "adaptive", "tolerance": 2e-9, "contact_steps": 1.0, "stick_share": 1.0}


def levels(base: Groups, integrators: Sequence[str]) -> dict[str, dict[str, Groups]]:
    """Compositions by kind and level: fixed steps, tolerances, meshes with time resolved, tiers."""
    found: dict[str, dict[str, Groups]] = {}
    for name in integrators:
        method = changed(base, {"integrator": {"name": name}})
        found[f"{name}, fixed steps"] = {
            f"dt {dt:g} s": changed(method, {"stepping": {"name": "fixed", "step_s": dt}})
            for dt in FIXED_STEPS
        }
    for name in ADAPTIVE:
        method = changed(base, {"integrator": {"name": name}})
        found[f"{name}, adaptive"] = {
            f"tolerance {tol:g}": changed(method, {"stepping": {"tolerance": tol}})
            for tol in TOLERANCES
        }
    resolved = changed(base, {"stepping": TIGHT})
    found["meshes, time resolved"] = {
        f"{n} elements": changed(resolved, {"discretization": {"elements": n}}) for n in ELEMENTS
    }
    found["tiers"] = {name: tier_groups(base, name) for name in TIERS}
    return found


def columns(rows: Sequence[Row], *keys: str) -> list[Array]:
    """Columns of the rows that have an apex, a truth, and an estimate."""
    good = [r for r in rows if r["status"] in ENDED and "true_x_percent" in r and r[ESTIMATE] > 0.0]
    return [np.array([float(r[k]) for r in good]) for k in keys]


def compared(rows: Sequence[Row], name: str) -> list[Array]:
    """True and estimated errors of x, or of y (%)."""
    return columns(rows, f"true_{name}_percent", f"{name}_error_estimate_percent")


def coverage(true: Array, estimate: Array) -> float:
    """Share of the true errors below twice the estimate."""
    return float(np.mean(true < WITHIN * estimate)) if len(true) else float("nan")


def level_row(kind: str, level: str, rows: Sequence[Row]) -> Row:
    """True and estimated errors of a level."""
    (total,) = columns(rows, "error_sum_bar")
    found: Row = {"composition": kind, "level": level, "jumps": len(rows), "known": len(total)}
    if len(total) == 0:
        return found
    found["error_sum_bar"] = float(np.median(total))
    for name in ("x", "y"):
        true, estimate = compared(rows, name)
        found[f"{name}_true_p95_percent"] = percentile(true, 95.0)
        found[f"{name}_error_estimate_percent"] = float(np.median(estimate))
        found[f"{name}_covered"] = coverage(true, estimate)
    return {**found, "within_tier": float(np.mean([bool(r["within_tier"]) for r in rows]))}


def overall(by_level: Mapping[Any, Sequence[Row]]) -> dict[str, float]:
    """Coverage, correlation of logarithms and caution of the estimate over all levels."""
    rows = [row for some in by_level.values() for row in some]
    (x, ex), (y, ey) = (compared(rows, name) for name in ("x", "y"))
    seen = x > 0.0
    return {
        "calibration_jumps": len(x),
        "x_covered_share": coverage(x, ex),
        "y_covered_share": coverage(y, ey),
        "log_correlation_x": float(np.corrcoef(np.log(x[seen]), np.log(ex[seen]))[0, 1]),
        "x_estimate_over_true_median": float(np.median(ex[seen] / x[seen])),
    }
