"""Error, roughness, cost and failures of a composition at one level; the Pareto front."""

import math
from collections import Counter
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np

from snapjump.run.studies.base import OK, Done
from snapjump.scenes.jump_outputs import ENDED

from ..errors import error_figures, relative_errors, roughness

NO = math.nan
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
    x_median_percent: float = NO
    x_p95_percent: float = NO
    y_median_percent: float = NO
    y_p95_percent: float = NO
    x_roughness_bar: float = NO
    y_roughness_bar: float = NO
    ms: float = NO
    newton_iterations: float = NO
    jumps: int = 0
    failed: int = 0
    remark: str = ""

    @property
    def errors(self) -> dict[str, float]:
        """Medians and 95th percentiles by their names."""
        return {key: value for key, value in asdict(self).items() if key.endswith("_percent")}

    @property
    def error(self) -> float:
        """The larger of the 95th percentiles of x and y (%)."""
        return max(self.x_p95_percent, self.y_p95_percent)

    def row(self) -> dict[str, Any]:
        """A line of the table; infinite errors are left out."""
        return {
            key: None if isinstance(value, float) and not math.isfinite(value) else value
            for key, value in asdict(self).items()
        }


def make_point(curve: str, level: str, done: Done, limit: Done) -> Point:
    """The figures of a cell against those of the limit's, which has at least its designs."""
    if done.status != OK:
        return Point(curve, level, remark=f"{done.status}: {done.message}")
    here, there = split(done), split(limit)
    errors, swept = (
        relative_errors(*here[kind], *(column[: len(here[kind][0])] for column in there[kind]))
        for kind in ("design", "sweep")
    )
    bad = [row["status"] for row in done.rows if row["status"] not in ENDED]
    bad += [SILENT for error in (*errors[1], *swept[1]) if error > ABSURD]
    designs = [k for k, row in enumerate(done.rows) if row["kind"] == "design"]
    figures: dict[str, Any] = error_figures(*errors)
    for k, name in enumerate(("x", "y")):
        values, limits = here["sweep"][k], there["sweep"][k]
        figures[f"{name}_roughness_bar"] = roughness(values - limits[: len(values)])
    for key in ("ms", "newton_iterations"):
        figures[key] = float(np.median(done.column(key)[designs]))
    remark = ", ".join(f"{count} {status}" for status, count in Counter(bad).items())
    return Point(curve, level, **figures, jumps=len(done.rows), failed=len(bad), remark=remark)


def split(done: Done) -> dict[str, tuple[Any, Any]]:
    """x_bar and y_bar of the spread designs and of the sweep."""
    kinds = np.array([row["kind"] for row in done.rows])
    x, y = done.column("x_bar"), done.column("y_bar")
    return {kind: (x[kinds == kind], y[kinds == kind]) for kind in ("design", "sweep")}


def pareto(costs: Sequence[float], errors: Sequence[float]) -> list[int]:
    """Places of the points that no other beats in both, cheapest first; infinite ones excluded."""
    finite = [k for k in range(len(costs)) if math.isfinite(costs[k]) and math.isfinite(errors[k])]
    front: list[int] = []
    for k in sorted(finite, key=lambda k: (costs[k], errors[k])):
        if not front or errors[k] < errors[front[-1]]:
            front.append(k)
    return front


def cheapest(points: Sequence[Point], wanted_percent: float) -> Point | None:
    """The composition to use for a wanted accuracy: the fastest that keeps it without a failure."""
    good = [p for p in points if p.error <= wanted_percent and p.failed == 0]
    return min(good, key=lambda p: p.ms, default=None)
