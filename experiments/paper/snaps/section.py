"""The section on snaps: text, figures, tables."""

import math
from collections.abc import Mapping, Sequence
from functools import partial

from experiments.paper.snap_settings import RATE_RAD_S
from experiments.paper.snaps.agreement import largest_percent
from experiments.paper.snaps.figure import draw_snaps
from experiments.paper.snaps.imperfections_figure import draw_imperfections
from experiments.paper.snaps.judge import VISIBLE_RAD, symmetric_until
from experiments.paper.snaps.setting import EPSILON
from snapjump.studies.base import Figure, Row, Section, Table

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
