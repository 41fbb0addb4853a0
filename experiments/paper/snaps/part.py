"""The dynamic snap with equal clamps and with a mismatch, and what a tiny mismatch does."""

from collections.abc import Mapping, Sequence
from typing import Any

from experiments.paper.base import Found, Part
from experiments.paper.snap_settings import RATE_RAD_S, SETTINGS, snap_groups
from experiments.paper.snaps.agreement import agreement, exact_snaps, largest_percent
from experiments.paper.snaps.compute import imperfection_rows, motion_rows
from experiments.paper.snaps.judge import symmetric_until, symmetry_statement, tilt
from experiments.paper.snaps.section import TITLE, make_section
from experiments.paper.snaps.setting import EPSILON, MISMATCH
from experiments.paper.unfinished import unfinished
from snapjump.studies.base import Cell, Done, Row

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
