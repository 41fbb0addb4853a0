"""``figure=trajectories``: flights, what the mismatch does to them, and how oblique they can be."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np

from snapjump.run.studies.base import Cell, Done, Row, column

from ...compositions import groups_at
from ...designs import spread_designs
from ...trends import counter_step
from ..base import LIMITED, Found, Part, Statement, failed, unfinished, weakest
from ..cells import apart, jumps, path, varied
from ..limits import LIMITS, judged
from ..settings import BASELINE, RANGES, TIERS
from ..words import Words
from . import figure

WORDS = Words(__file__)
FAMILIES: dict[str, tuple[float, ...]] = {
    "delta_alpha_rad": (0.0, 0.01, 0.05, 0.1, 0.19),
    "epsilon": (0.1, 0.2, 0.3),
    "mass_bar": (0.4, 0.768, 1.5),
}
DRAWN = ("standard", "paper")
FOLLOWED = (0.0, 0.05, 0.1, 0.19)  # mismatches of paths until nothing touches the ground
# Mismatches from nothing to the end of the paper's range; every STRIDE-th at reference.
MISMATCHES, STRIDE = np.linspace(0.0, RANGES["delta_alpha_rad"][1], 41).tolist(), 4
DESIGNS = 256  # over the paper's ranges, for how oblique a jump can be
RANGE = "ranges"
RISES = 0.01, 0.03  # L, of the centre of mass: between them the beam slides in every flight


@dataclass(frozen=True)
class Slant:
    """Of a sweep of the mismatch from zero: how far off the apex is at no mismatch (share of its
    height), the ratio x_c/y_c at the end, its largest way back as a share of its growth, where it
    first goes back (rad; NaN if never), and the largest lean (degrees from the vertical)."""

    off_vertical: float
    ratio: float
    back: float
    grows_until_rad: float
    lean_deg: float


def leans_deg(rows: Sequence[Row]) -> Any:
    """Angles of the velocity at lift-off, from the vertical."""
    return np.degrees(np.arctan2(column(rows, "liftoff_vx_m_s"), column(rows, "liftoff_vy_m_s")))


def ratios(rows: Sequence[Row]) -> Any:
    """x_c/y_c."""
    return column(rows, "x_bar") / column(rows, "y_bar")


def slant(rows: Sequence[Row]) -> Slant:
    """The slant of a sweep; its first row has no mismatch."""
    ratio, places = ratios(rows), column(rows, "delta_alpha_rad")
    falling = places[:-1][np.diff(ratio) < 0.0]
    return Slant(
        abs(float(ratio[0])),
        float(ratio[-1]),
        counter_step(ratio, rising=True),
        float(falling[0]) if len(falling) else float("nan"),
        float(np.nanmax(leans_deg(rows))),
    )


def tuned(found: Slant, most_lean_deg: float) -> str:
    """The verdict, from a sweep and from the largest lean over all of the ranges."""
    return weakest(
        judged("trajectories.types.vertical", found.off_vertical),
        judged("trajectories.tuned.back", found.back),
        judged("trajectories.tuned.horizontal", most_lean_deg),
        judged("trajectories.tuned.oblique", found.lean_deg),
    )


def tuning(own: Slant, papers: Slant, spread: Sequence[Row], near: Mapping[str, Any]) -> Statement:
    """How the mismatch tunes the jump; ``papers``: the slant at the paper's settings; ``spread``:
    designs over all ranges; ``near``: values of the accuracy."""
    leans, lost = leans_deg(spread), len(failed(spread))
    steepest = float(np.nanmax(leans))
    came, low = tuned(own, steepest), steepest < LIMITS["trajectories.tuned.horizontal"].confirmed
    limit = "Oblique, not near horizontal. " if low else "Not throughout. "
    grows = "grows throughout" if np.isnan(own.grows_until_rad) else "grows to and fro"
    return WORDS.statement(
        "tuned", came, own=own, papers=papers, limit=limit if came == LIMITED else "",
        grows=WORDS(grows, until_rad=own.grows_until_rad, back=100 * own.back),
        largest_rad=RANGES["delta_alpha_rad"][1], count=len(spread), steepest_deg=steepest,
        most=spread[int(np.nanargmax(leans))], lost=f"; {lost} failed" if lost else "",
        why=": friction is all that drives it sideways" if low else "", **near,
    )  # fmt: skip


def types(own: Slant, aside: Any, near: Mapping[str, Any]) -> Statement:
    """Vertical or inclined; ``aside``: x_c/y_c over the paper's ranges, all with a mismatch."""
    least = float(np.nanmin(aside))
    came = weakest(
        judged("trajectories.types.vertical", own.off_vertical),
        judged("trajectories.types.inclined", least),
    )
    told = {"own": own, "count": len(aside), "least": least, "most": np.nanmax(aside), **near}
    return WORDS.statement("types", came, **told)


def differences(sweeps: Mapping[str, Sequence[Row]]) -> dict[str, float]:
    """How the paper's settings differ: higher (%), and where the jump comes down (L)."""
    own, papers = (column(sweeps[tier], "y_bar") for tier in DRAWN)
    higher = 100.0 * (papers / own - 1.0)
    aside = column(sweeps["paper"], "x_bar") - column(sweeps["standard"], "x_bar")
    return {
        "higher": (higher.min(), higher.max()),
        "nearer": max(-2.0 * aside.min(), 0.0),
        "farther": max(2.0 * aside.max(), 0.0),
    }


def first_slope(rows: Sequence[Row]) -> float:
    """dx/dy of a path while the centre of mass rises through the first of its way."""
    x, y = column(rows, "x_bar"), column(rows, "y_bar")
    low, high = (int(np.flatnonzero(y > y[0] + rise)[0]) for rise in RISES)
    return float((x[high] - x[low]) / (y[high] - y[low]))


def table_rows(flights: Mapping[str, Sequence[Row]]) -> list[Row]:
    """The families' apexes at both tiers."""
    kept = ("x_bar", "y_bar", "liftoff_vx_m_s", "liftoff_vy_m_s")
    return [
        {key: own[key] for key in (*FAMILIES, *kept)} | {f"paper_{key}": other[key] for key in kept}
        for own, other in zip(flights["standard"], flights["paper"], strict=True)
    ]


class Trajectories(Part):
    """Families of jumps, a sweep of the mismatch, and designs of all the ranges."""

    name = "trajectories"
    title = "Trajectories"
    kinds = {"jumps": jumps, "path": path}

    def plan(self, groups: Mapping[str, Any], seed: int) -> list[Cell]:
        """Families and sweeps by tier, then the ranges and the paths at standard."""
        at = {tier: groups_at(groups, tier) for tier in TIERS}

        def cell(name: str, designs: Any, tier: str = "standard", kind: str = "jumps") -> Cell:
            return Cell(name, {"kind": kind, "groups": at[tier], "designs": designs})

        families = [design for name, values in FAMILIES.items() for design in varied(name, values)]
        sweep = varied("delta_alpha_rad", MISMATCHES)
        return [
            *(cell(f"flights, {tier}", families, tier) for tier in DRAWN),
            *(
                cell(f"mismatches, {tier}", sweep[:: 1 if tier in DRAWN else STRIDE], tier)
                for tier in TIERS
            ),
            cell(RANGE, spread_designs(DESIGNS, seed)),
            *(
                cell(f"path to lift-off, {design[0]:g}", [design], kind="path")
                for design in varied("delta_alpha_rad", FOLLOWED)
            ),
        ]

    def conclude(self, done: Mapping[str, Done]) -> Found:
        """Failures among the designs of the ranges are told, and left out."""
        needed = {name: one for name, one in done.items() if name != RANGE}
        return unfinished(self.title, needed, jumps=True) or super().conclude(done)

    def judge(self, done: Mapping[str, Done]) -> Found:
        """Two statements; the families, the angles, and the paths to lift-off."""
        flights = {tier: done[f"flights, {tier}"].rows for tier in DRAWN}
        sweeps = {tier: done[f"mismatches, {tier}"].rows for tier in TIERS}
        paths = {lag: done[f"path to lift-off, {lag:g}"].rows for lag in FOLLOWED}
        own, papers = (slant(sweeps[tier]) for tier in DRAWN)
        spread = done[RANGE].rows
        off = apart(sweeps, "delta_alpha_rad")
        near = {"off": off, "compared": len(sweeps["reference"])}
        slopes = [first_slope(rows) for lag, rows in paths.items() if lag > 0.0]
        by_tier = {tier: ratios(sweeps[tier]) for tier in TIERS}
        figures = {
            "trajectories": partial(figure.draw_flights, FAMILIES, flights),
            "trajectories_angles": partial(figure.draw_angles, sweeps, by_tier, paths),
        }
        tables = {"trajectories": table_rows(flights)}
        told = {"slopes": (min(slopes), max(slopes)), "mu": BASELINE[3], **differences(sweeps)}
        return Found(
            WORDS.section(self.title, figures, tables, **told),
            [tuning(own, papers, spread, near), types(own, ratios(spread), near)],
            {
                "trajectories_ratio_at_most_mismatch": own.ratio,
                "trajectories_lean_baseline_deg": own.lean_deg,
                "trajectories_lean_most_deg": float(np.nanmax(leans_deg(spread))),
                "trajectories_off_vertical": own.off_vertical,
            },
        )
