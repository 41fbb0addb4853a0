"""``figure=snaps``: the snap with equal clamps and with a mismatch, also with a tiny one."""

import math
from collections.abc import Mapping, Sequence
from functools import partial
from typing import Any

import numpy as np

from snapjump.run.studies.base import Cell, Done, Row, column
from snapjump.scenes.swing import Swing, crossing, follow, outcome, sinking

from ...arches.exact_snap import agreement, compared, exact_snaps, largest_percent
from ...arches.swings import RATE_RAD_S, SETTINGS, snap_groups, snap_of
from ..base import Found, Part, Statement, weakest
from ..limits import LIMITS, judged
from ..words import Words
from . import figure

WORDS = Words(__file__)
EPSILON, MISMATCH = 0.1, 0.1  # the paper's; the mismatch in rad
TINY_RAD = (0.0, *(10.0**k for k in range(-8, 0)))
TINY = (  # setting, rate in rad/s
    ("standard", 200.0),
    ("standard", RATE_RAD_S),
    ("standard", 2.0),
    ("standard", 0.2),
    ("undamped", RATE_RAD_S),
    ("paper", RATE_RAD_S),
)
INSTANTS = 7  # shapes of a snap, between which the midpoint sinks by equal steps
BEFORE_MS, AFTER_MS = 4.0, 2.5  # of the crossing, what is kept of the midpoint's motion
VISIBLE_RAD = LIMITS["snaps.symmetry.mismatched"].confirmed
SHOWN = (
    "delta_alpha_rad",
    "theta_max_rad",
    "theta_later_rad",
    "alpha_snap_rad",
    "snap_time_ms",
    "snap_duration_ms",
    "midpoint_velocity_m_s",
)


def swings(inputs: Mapping[str, Any]) -> list[tuple[float, Swing]]:
    """The cell's snaps by their mismatches."""
    groups, epsilon, rate = (inputs[key] for key in ("groups", "epsilon", "rate_rad_s"))
    return [(lag, follow(snap_of(groups, epsilon, lag, rate))) for lag in inputs["mismatches_rad"]]


def outcome_rows(inputs: Mapping[str, Any]) -> list[Row]:
    """A row for each mismatch: :func:`snapjump.scenes.swing.outcome`."""
    return [{"delta_alpha_rad": lag, **outcome(swing)} for lag, swing in swings(inputs)]


def motion_rows(inputs: Mapping[str, Any]) -> list[Row]:
    """Of each mismatch a row of numbers, rows of shapes, and rows of the midpoint's motion."""
    rows = []
    for lag, swing in swings(inputs):
        found = [{"kind": "outcome", **outcome(swing), **compared(swing)}]
        k = crossing(swing)
        if k is not None:
            found += [*shapes(swing, k), *samples(swing, k)]
        rows += [{"delta_alpha_rad": lag, **row} for row in found]
    return rows


def shapes(swing: Swing, crossed: int) -> list[Row]:
    """The nodes at the instants."""
    return [
        {
            "kind": "shape",
            "time_ms": 1e3 * float(swing.time_s[k]),
            "x_bar": swing.x[k].tolist(),
            "y_bar": swing.y[k].tolist(),
        }
        for k in sinking(swing, crossed, INSTANTS)
    ]


def samples(swing: Swing, crossed: int) -> list[Row]:
    """The midpoint about the crossing."""
    time = 1e3 * (swing.time_s - swing.time_s[crossed])
    near = (time >= -BEFORE_MS) & (time <= AFTER_MS)
    columns = {
        "time_ms": 1e3 * swing.time_s[near],
        "height_bar": swing.height[near],
        "tangent_rad": swing.tangent_rad[near],
    }
    table = np.stack([*columns.values()], axis=1).tolist()
    return [{"kind": "sample", **dict(zip(columns, row, strict=True))} for row in table]


def tilt(rows: Sequence[Row], delta_alpha: float) -> float:
    """The largest tilt of the midpoint at a mismatch; NaN if there is no such snap."""
    found = [row["theta_max_rad"] for row in rows if row["delta_alpha_rad"] == delta_alpha]
    return float(found[0]) if found and found[0] is not None else math.nan


def symmetric_until(rows: Sequence[Row]) -> float:
    """The mismatch (rad) at which the tilt becomes visible; 0 if it is with equal clamps, infinity
    if it is with none of these."""
    snapped = [row for row in rows if row["theta_max_rad"] is not None]
    snapped.sort(key=lambda row: float(row["delta_alpha_rad"]))
    lags, tilts = column(snapped, "delta_alpha_rad"), column(snapped, "theta_max_rad")
    seen = np.flatnonzero(tilts >= VISIBLE_RAD)
    if len(seen) == 0:
        return math.inf
    k = int(seen[0])
    if k == 0 or lags[k - 1] == 0.0:
        # The tilt is proportional to so small a mismatch.
        return 0.0 if lags[k] == 0.0 else float(lags[k] * VISIBLE_RAD / tilts[k])
    about = slice(k - 1, k + 1)
    return math.exp(np.interp(math.log(VISIBLE_RAD), np.log(tilts[about]), np.log(lags[about])))


def symmetry_verdict(equal: float, mismatched: float, limits: Sequence[float]) -> str:
    """``equal``, ``mismatched``: tilts (rad) with equal clamps and with the paper's mismatch;
    ``limits``: :func:`symmetric_until` of the snaps at several rates."""
    return weakest(
        judged("snaps.symmetry.equal", equal / mismatched),
        judged("snaps.symmetry.mismatched", mismatched),
        judged("snaps.symmetry.mismatch", *limits),
    )


def limit_in_words(rate: float, limit: float, equal: float) -> str:
    """At which mismatch the tilt is seen when the clamps turn at this rate (rad/s); ``equal``: the
    tilt with equal clamps."""
    heading = "seen at once" if limit == 0.0 else "seen at none" if math.isinf(limit) else "seen"
    return WORDS(heading, rate=rate, limit=limit, equal=equal)


def symmetry(
    numbers: Mapping[str, Sequence[Row]], by_rate: Mapping[float, tuple[float, float]]
) -> Statement:
    """The statement; ``numbers``: of the two snaps, by setting; ``by_rate``: the mismatch that is
    seen, and the tilt with equal clamps."""
    equal, tilted = numbers["standard"]
    tilts = {name: tilt(rows, MISMATCH) for name, rows in numbers.items()}
    seen = [limit for limit, _ in by_rate.values()]
    return WORDS.statement(
        "symmetry", symmetry_verdict(tilt(numbers["standard"], 0.0), tilts["standard"], seen),
        rate=RATE_RAD_S, epsilon=EPSILON, equal=equal, tilted=tilted, tilts=tilts,
        tilt_deg=math.degrees(tilts["standard"]), visible_deg=math.degrees(VISIBLE_RAD),
        limits="; ".join(limit_in_words(rate, *by_rate[rate]) for rate in sorted(by_rate)),
        off=100.0 * abs(tilts["standard"] / tilts["reference"] - 1.0),
    )  # fmt: skip


def motion_name(setting: str) -> str:
    """The cell of the two snaps at a setting."""
    return f"two snaps at {setting}"


def tiny_name(setting: str, rate: float) -> str:
    """The cell of tiny mismatches at a setting and a rate (rad/s)."""
    return f"tiny mismatches at {setting}, {rate:g} rad per s"


class Snaps(Part):
    """Two snaps at every setting, then many with hardly any mismatch, at several rates."""

    name = "snaps"
    title = "Symmetric and asymmetric snaps"
    kinds = {"motions": motion_rows, "outcomes": outcome_rows}

    def plan(self, groups: Mapping[str, Any], seed: int) -> list[Cell]:
        """A cell for each setting, and one for each rate."""
        settings = {name: snap_groups(groups, name) for name in SETTINGS}

        def cell(name: str, kind: str, setting: str, rate: float, lags: Sequence[float]) -> Cell:
            inputs = {"epsilon": EPSILON, "rate_rad_s": rate, "mismatches_rad": list(lags)}
            return Cell(name, {"kind": kind, "groups": settings[setting], **inputs})

        pair = (0.0, MISMATCH)
        return [
            *(cell(motion_name(s), "motions", s, RATE_RAD_S, pair) for s in SETTINGS),
            *(cell(tiny_name(*one), "outcomes", *one, TINY_RAD) for one in TINY),
        ]

    def judge(self, done: Mapping[str, Done]) -> Found:
        """One statement; the two snaps, the tiny mismatches, and the independent solution."""
        motions = {name: done[motion_name(name)].rows for name in SETTINGS}
        numbers = {
            name: [row for row in rows if row["kind"] == "outcome"]
            for name, rows in motions.items()
        }
        tiny = {one: done[tiny_name(*one)].rows for one in TINY}
        limits = {one: symmetric_until(rows) for one, rows in tiny.items()}
        by_rate = {rate: (limits[name, rate], tilt(tiny[name, rate], 0.0))
                   for name, rate in TINY if name == "standard"}  # fmt: skip
        exact = exact_snaps()
        against = agreement(numbers, exact)
        off = {name: largest_percent(against, name) for name in ("undamped reference", "own")}
        figures = {
            "snaps": partial(figure.draw_snaps, motions, exact),
            "snap_imperfections": partial(figure.draw_tiny, tiny, EPSILON),
        }
        tables = {
            "snap_numbers": [
                {"setting": name, **{key: row[key] for key in SHOWN}}
                for name, rows in numbers.items()
                for row in rows
            ],
            "snap_agreement": against,
            "snap_limits": [
                {
                    "setting": name,
                    "rate_rad_s": rate,
                    "one_degree_at_rad": limits[name, rate],
                    "theta_max_equal_clamps_rad": rows[0]["theta_max_rad"],
                }
                for (name, rate), rows in tiny.items()
            ],
        }
        digits = {"snap_limits": {"one_degree_at_rad": 2, "theta_max_equal_clamps_rad": 2}}
        summary = {
            "snap_theta_max_equal_rad": tilt(numbers["standard"], 0.0),
            "snap_theta_max_mismatched_rad": tilt(numbers["standard"], MISMATCH),
            "snap_off_independent_percent": off["undamped reference"],
        }
        for rate, (limit, _) in by_rate.items():
            key = f"{rate:g}".replace(".", "_")
            summary[f"snap_one_degree_at_rad_{key}_rad_s"] = limit
        told = {"epsilon": EPSILON, "rate": RATE_RAD_S, "off": off}
        section = WORDS.section(self.title, figures, tables, digits, **told)
        return Found(section, [symmetry(numbers, by_rate)], summary)
