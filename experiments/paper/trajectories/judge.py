"""Whether the mismatch alone tunes a jump between vertical and oblique."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from experiments.paper.base import failed
from experiments.paper.jumps import furthest, numbers
from experiments.paper.statement import LIMITED, Statement, verdict
from experiments.trends import counter_step
from snapjump.run.studies.base import Row

# A jump is vertical if its apex is off by no more than a hundredth of its height.
VERTICAL = 0.01
# Half-way between vertical and horizontal: what may be called more than a slant.
OBLIQUE_DEG = 45.0
# A slant that is seen, and that carries the robot over half its own length and more.
SLANTED_DEG = 5.0
# Of a ratio that grows throughout; the curves' own numerical error is below it.
MONOTONE = 0.02


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
    return np.degrees(np.arctan2(numbers(rows, "liftoff_vx_m_s"), numbers(rows, "liftoff_vy_m_s")))


def ratios(rows: Sequence[Row]) -> Any:
    """x_c/y_c."""
    return numbers(rows, "x_bar") / numbers(rows, "y_bar")


def slant(rows: Sequence[Row]) -> Slant:
    """The slant of a sweep; its first row has no mismatch."""
    ratio = ratios(rows)
    falling = np.flatnonzero(np.diff(ratio) < 0.0)
    places = numbers(rows, "delta_alpha_rad")
    return Slant(
        abs(float(ratio[0])),
        float(ratio[-1]),
        counter_step(ratio, rising=True),
        float(places[falling[0]]) if len(falling) else float("nan"),
        float(np.nanmax(leans_deg(rows))),
    )


def tuned(found: Slant, most_lean_deg: float) -> str:
    """The verdict, from a sweep and from the largest lean over all of the ranges."""
    vertical = found.off_vertical <= VERTICAL
    return verdict(
        vertical and found.back <= MONOTONE and most_lean_deg >= OBLIQUE_DEG,
        vertical and found.lean_deg >= SLANTED_DEG,
    )


def limit(came: str, most_lean_deg: float) -> str:
    """What a limited verdict is limited to, in front of what is found."""
    if came != LIMITED:
        return ""
    if most_lean_deg < OBLIQUE_DEG:
        return "Oblique, not near horizontal. "
    return "Not throughout. "


def trajectory_statement(
    sweeps: Mapping[str, Sequence[Row]], spread: Sequence[Row]
) -> tuple[Statement, dict[str, float]]:
    """The statement, and its numbers."""
    own, papers = slant(sweeps["standard"]), slant(sweeps["paper"])
    leans, lost = leans_deg(spread), failed(spread)
    most = int(np.nanargmax(leans))
    steepest = float(leans[most])
    grows = (
        "throughout"
        if np.isnan(own.grows_until_rad)
        else f"up to {own.grows_until_rad:.2g} rad, then to and fro (the largest way back is "
        f"{100 * own.back:.0f} % of the growth)"
    )
    came = tuned(own, steepest)
    found = (
        f"{limit(came, steepest)}Without a mismatch the apex is {own.off_vertical:.1g} of its "
        f"height off the vertical. x_c/y_c grows with the mismatch {grows}, to {own.ratio:.2g} at "
        f"{numbers(sweeps['standard'], 'delta_alpha_rad')[-1]:.2g} rad. The baseline leaves the "
        f"ground at most {own.lean_deg:.0f}° from the vertical (the paper's settings: "
        f"{papers.lean_deg:.0f}°, x_c/y_c up to {papers.ratio:.2g}); over {len(spread)} designs "
        f"of the paper's ranges at most {steepest:.0f}° (Δα "
        f"{spread[most]['delta_alpha_rad']:.2g} rad, ε {spread[most]['epsilon']:.2g}, "
        f"m̄ {spread[most]['mass_bar']:.2g}, μ {spread[most]['mu']:.2g}"
        + (f"; {len(lost)} failed)" if lost else ")")
        + (": friction is all that drives it sideways." if steepest < OBLIQUE_DEG else ".")
    )
    reference = sweeps["reference"]
    off = [
        furthest(sweeps["standard"], reference, k, "delta_alpha_rad") for k in ("x_bar", "y_bar")
    ]
    statement = Statement(
        "The mismatch Δα tunes the trajectory from vertical, for a symmetric snap, to oblique and "
        "near horizontal.",
        came,
        found,
        f"`standard`, within {off[0]:.1g} L in x and {off[1]:.1g} L in y of `reference` at "
        f"{len(reference)} mismatches",
        "task=paper figure=trajectories",
    )
    return statement, {
        "trajectories_ratio_at_most_mismatch": own.ratio,
        "trajectories_lean_baseline_deg": own.lean_deg,
        "trajectories_lean_most_deg": steepest,
        "trajectories_off_vertical": own.off_vertical,
    }
