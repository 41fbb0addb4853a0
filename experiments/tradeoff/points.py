"""What one composition at one level came to: error, roughness, cost, failures; the Pareto front."""

import math
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np

from experiments.errors import percentile, relative_errors, roughness
from snapjump.studies.base import OK, Done

NO = math.nan
NO_FIGURES = (NO, NO, NO, NO, NO, NO, NO, NO)  # the figures of a cell without any
KNOWN = ("ok", "no_jump")
# An error of y (%) above which a jump that ended well is no answer, though nothing said so.
ABSURD = 100.0
SILENT = "silently wrong"


@dataclass(frozen=True)
class Point:
    """One level of one curve. Errors in percent of the limit, a failed jump counting as infinite;
    medians over the designs of milliseconds and Newton iterations a jump; ``failed`` of ``jumps``,
    those included that ended well but with an absurd result.
    """

    curve: str
    level: str
    x_median_percent: float
    x_p95_percent: float
    y_median_percent: float
    y_p95_percent: float
    x_roughness_bar: float
    y_roughness_bar: float
    ms: float
    newton_iterations: float
    jumps: int
    failed: int
    remark: str

    @property
    def error(self) -> float:
        """The larger of the 95th percentiles of x and y (%)."""
        return max(self.x_p95_percent, self.y_p95_percent)

    def row(self) -> dict[str, Any]:
        """A line of the table; infinite errors are left out."""
        values = asdict(self)
        return {
            key: None if isinstance(value, float) and not math.isfinite(value) else value
            for key, value in values.items()
        }


def make_point(curve: str, level: str, done: Done, limit: Done) -> Point:
    """The figures of a cell against those of the limit's, which has at least its designs."""
    if done.status != OK:
        return Point(curve, level, *NO_FIGURES, 0, 0, f"{done.status}: {done.message}")
    here, there = split(done), split(limit)
    x, y = here["design"]
    x_limit, y_limit = (column[: len(x)] for column in there["design"])
    x_errors, y_errors = relative_errors(x, y, x_limit, y_limit)
    designs = [k for k, row in enumerate(done.rows) if row["kind"] == "design"]
    x_sweep, y_sweep = here["sweep"]
    x_smooth, y_smooth = (column[: len(x_sweep)] for column in there["sweep"])
    off = [*y_errors, *relative_errors(x_sweep, y_sweep, x_smooth, y_smooth)[1]]
    bad = [row["status"] for row in done.rows if row["status"] not in KNOWN]
    bad += [SILENT for error in off if error > ABSURD]
    counts = ", ".join(f"{bad.count(s)} {s}" for s in dict.fromkeys(bad))
    return Point(
        curve=curve,
        level=level,
        x_median_percent=percentile(x_errors, 50.0),
        x_p95_percent=percentile(x_errors, 95.0),
        y_median_percent=percentile(y_errors, 50.0),
        y_p95_percent=percentile(y_errors, 95.0),
        x_roughness_bar=roughness(x_sweep - x_smooth),
        y_roughness_bar=roughness(y_sweep - y_smooth),
        ms=float(np.median(done.column("ms")[designs])),
        newton_iterations=float(np.median(done.column("newton_iterations")[designs])),
        jumps=len(done.rows),
        failed=len(bad),
        remark=counts,
    )


def split(done: Done) -> dict[str, tuple[Any, Any]]:
    """x_bar and y_bar of the spread designs and of the sweep."""
    kinds = np.array([row["kind"] for row in done.rows])
    x, y = done.column("x_bar"), done.column("y_bar")
    return {kind: (x[kinds == kind], y[kinds == kind]) for kind in ("design", "sweep")}


def pareto(costs: Sequence[float], errors: Sequence[float]) -> list[int]:
    """Places of the points that no other beats in both, cheapest first; infinite ones excluded."""
    order = sorted(
        (k for k in range(len(costs)) if math.isfinite(costs[k]) and math.isfinite(errors[k])),
        key=lambda k: (costs[k], errors[k]),
    )
    front: list[int] = []
    for k in order:
        if not front or errors[k] < errors[front[-1]]:
            front.append(k)
    return front


def cheapest(points: Sequence[Point], wanted_percent: float) -> Point | None:
    """The composition to use for a wanted accuracy: the fastest that keeps it without a failure."""
    good = [p for p in points if p.error <= wanted_percent and p.failed == 0]
    return min(good, key=lambda p: p.ms, default=None)
