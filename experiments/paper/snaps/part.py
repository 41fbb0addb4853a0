"""The dynamic snap with equal clamps and with a mismatch, and what a tiny mismatch does."""

import math
from collections.abc import Mapping, Sequence
from functools import partial
from typing import Any

from experiments.paper.base import Found, Part, unfinished
from experiments.paper.settings import RATE_RAD_S, SETTINGS, snap_groups
from experiments.paper.snaps.compute import imperfection_rows, motion_rows
from experiments.paper.snaps.figure import draw_imperfections, draw_snaps
from experiments.paper.snaps.judge import (
    EPSILON,
    MISMATCH,
    VISIBLE_RAD,
    agreement,
    exact_snaps,
    largest_percent,
    symmetric_until,
    symmetry_statement,
    tilt,
)
from snapjump.run.studies.base import Cell, Done, Figure, Row, Section, Table

IMPERFECTIONS = (0.0, *(10.0**k for k in range(-8, 0)))  # rad
TINY = (  # setting, rate in rad/s
    ("standard", 200.0),
    ("standard", RATE_RAD_S),
    ("standard", 2.0),
    ("standard", 0.2),
    ("undamped", RATE_RAD_S),
    ("paper", RATE_RAD_S),
)


class Snaps(Part):
    """Two snaps at every setting, then many with hardly any mismatch, at several rates."""

    name = "snaps"
    sources = ("experiments.paper.snaps.compute",)

    def plan(self, groups: Mapping[str, Any], seed: int) -> list[Cell]:
        """A cell for each setting, and one for each rate."""
        settings = {name: snap_groups(groups, name) for name in SETTINGS}
        pair = {"epsilon": EPSILON, "rate_rad_s": RATE_RAD_S, "delta_alpha_rad": [0.0, MISMATCH]}
        return [Cell(motion_name(s), {"groups": g, **pair}) for s, g in settings.items()] + [
            Cell(
                tiny_name(setting, rate),
                {
                    "groups": settings[setting],
                    "epsilon": EPSILON,
                    "rate_rad_s": rate,
                    "imperfections_rad": list(IMPERFECTIONS),
                },
            )
            for setting, rate in TINY
        ]

    def compute(self, inputs: Mapping[str, Any]) -> list[Row]:
        """Motions of two snaps, or tilts of many."""
        return imperfection_rows(inputs) if "imperfections_rad" in inputs else motion_rows(inputs)

    def conclude(self, done: Mapping[str, Done]) -> Found:
        """One statement; none if a cell failed."""
        missing = unfinished(TITLE, done)
        if missing:
            return missing
        motions = {name: done[motion_name(name)].rows for name in SETTINGS}
        numbers = {
            name: [row for row in rows if row["kind"] == "outcome"]
            for name, rows in motions.items()
        }
        tiny = {(name, rate): done[tiny_name(name, rate)].rows for name, rate in TINY}
        by_rate = {rate: rows for (name, rate), rows in tiny.items() if name == "standard"}
        exact = exact_snaps()
        against = agreement(numbers, exact)
        return Found(
            make_section(motions, numbers, tiny, against, exact),
            [symmetry_statement(numbers, by_rate, MISMATCH)],
            summary(numbers["standard"], by_rate, against),
        )


def motion_name(setting: str) -> str:
    """The cell of the two snaps at a setting."""
    return f"two snaps at {setting}"


def tiny_name(setting: str, rate: float) -> str:
    """The cell of tiny mismatches at a setting and a rate (rad/s)."""
    return f"tiny mismatches at {setting}, {rate:g} rad per s"


def summary(
    rows: Sequence[Row], by_rate: Mapping[float, Sequence[Row]], against: Sequence[Row]
) -> Row:
    """Flat numbers for result.json."""
    found: Row = {
        "snap_theta_max_equal_rad": tilt(rows, 0.0),
        "snap_theta_max_mismatched_rad": tilt(rows, MISMATCH),
        "snap_off_independent_percent": largest_percent(against, "undamped reference"),
    }
    for rate, snaps in by_rate.items():
        key = f"{rate:g}".replace(".", "_")
        found[f"snap_one_degree_at_rad_{key}_rad_s"] = symmetric_until(snaps)
    return found


TITLE = "Symmetric and asymmetric snaps"
SHOWN = (
    "delta_alpha_rad",
    "theta_max_rad",
    "theta_later_rad",
    "alpha_snap_rad",
    "snap_time_ms",
    "snap_duration_ms",
    "midpoint_velocity_m_s",
)


def make_section(
    motions: Mapping[str, Sequence[Row]],
    numbers: Mapping[str, Sequence[Row]],
    tiny: Mapping[tuple[str, float], Sequence[Row]],
    against: Sequence[Row],
    exact: Sequence[Row],
) -> Section:
    """``motions``: all rows by setting, ``numbers``: of these the outcomes; ``tiny``: snaps with
    tiny mismatches by setting and rate."""
    return Section(
        TITLE,
        [
            "The beam alone in a frame that is held still, without gravity or ground, at "
            f"ε = {EPSILON:g}; both clamps turn at {RATE_RAD_S:g} rad/s from flat. The tilt is the "
            "tangent angle at the midpoint; θ_max is the largest one of the snap, which ends "
            "where the midpoint first comes to rest below the clamps (`theta_later_rad`: with the "
            "vibration after that, which without damping goes on and whose details are chaotic).",
            "Without damping, the snaps are those of an independent solution within "
            f"{largest_percent(against, 'undamped reference'):.1g} %; that solution's own "
            f"uncertainty is {largest_percent(against, 'own'):.1g} %.",
            "The arch always becomes unstable asymmetrically first, at equal clamps too, and "
            "symmetrically a little later. A snap is symmetric if the asymmetric mode "
            "has nothing to grow from, or no time before the symmetric one has taken over. So it "
            "depends on how fast the clamps turn: the slower, the smaller the mismatch that "
            "suffices. Material damping holds the growth back; the paper's time step does not: "
            "implicit Euler damps what oscillates, not what buckles.",
        ],
        figures={
            "snaps": Figure(
                "Shapes between which the midpoint sinks by equal steps, and the midpoint's height "
                "and tilt; dots with numbers: the instants of the shapes; squares: the independent "
                "solution, which has no damping",
                partial(draw_snaps, motions, exact),
            ),
            "snap_imperfections": Figure(
                "The largest tilt against the mismatch at several rates of the clamps; at the left "
                "edge equal clamps, which rounding errors alone disturb",
                partial(draw_imperfections, tiny),
            ),
        },
        tables={
            "snap_numbers": Table(
                "The two snaps at all settings",
                [
                    {"setting": name, **{key: row[key] for key in SHOWN}}
                    for name, rows in numbers.items()
                    for row in rows
                ],
            ),
            "snap_agreement": Table(
                "Differences from the independent solution, which has no damping (%)", against
            ),
            "snap_limits": Table(
                f"Mismatch that tilts the midpoint by {math.degrees(VISIBLE_RAD):g}°, and tilt "
                "with equal clamps",
                [
                    {
                        "setting": name,
                        "rate_rad_s": rate,
                        "one_degree_at_rad": symmetric_until(rows),
                        "theta_max_equal_clamps_rad": rows[0]["theta_max_rad"],
                    }
                    for (name, rate), rows in tiny.items()
                ],
                digits={"one_degree_at_rad": 2, "theta_max_equal_clamps_rad": 2},
            ),
        },
    )
