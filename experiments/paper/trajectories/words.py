"""What is said about trajectories."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from experiments.paper.base import LIMITED, Said, failed
from experiments.paper.limits import LIMITS
from experiments.paper.settings import BASELINE, RANGES
from snapjump.run.studies.base import Row, column

CAPTIONS = {
    "trajectories.png": """Flights of the centre of mass, to scale: lines at standard, dashed with
        the paper's settings, dots at the apexes. One number of the baseline varies in each""",
    "trajectories_angles.png": """x_c/y_c against the mismatch, and the path of the centre of mass
        until the robot has left the ground""",
    "trajectories": "The flights of the figure",
}
HORIZONTAL_DEG = LIMITS["trajectories.tuned.horizontal"].confirmed


def tuning(came: str, own: Any, papers: Any, spread: Sequence[Row], leans: Any, told: str) -> Said:
    """``own``, ``papers``: slants; ``leans``: of the designs over all ranges, in degrees."""
    steepest, lost = float(np.nanmax(leans)), len(failed(spread))
    most, low = spread[int(np.nanargmax(leans))], steepest < HORIZONTAL_DEG
    limit = "Oblique, not near horizontal. " if low else "Not throughout. "
    grows = (
        "throughout"
        if np.isnan(own.grows_until_rad)
        else f"up to {own.grows_until_rad:.2g} rad, then to and fro (the largest way back is "
        f"{100 * own.back:.0f} % of the growth)"
    )
    return Said(
        """The mismatch Δα tunes the trajectory from vertical, for a symmetric snap, to oblique and
        near horizontal.""",
        f"""{limit if came == LIMITED else ""}Without a mismatch the apex is
        {own.off_vertical:.1g} of its height off the vertical. x_c/y_c grows with the mismatch
        {grows}, to {own.ratio:.2g} at {RANGES["delta_alpha_rad"][1]:.2g} rad. The baseline leaves
        the ground at most {own.lean_deg:.0f}° from the vertical (the paper's settings:
        {papers.lean_deg:.0f}°, x_c/y_c up to {papers.ratio:.2g}); over {len(spread)} designs of the
        paper's ranges at most {steepest:.0f}° (Δα {most["delta_alpha_rad"]:.2g} rad,
        ε {most["epsilon"]:.2g}, m̄ {most["mass_bar"]:.2g}, μ {most["mu"]:.2g}{
            f"; {lost} failed" if lost else ""
        }){": friction is all that drives it sideways" if low else ""}.""",
        told,
    )


def types(own: Any, aside: Any, told: str) -> Said:
    """``aside``: x_c/y_c of designs over the paper's ranges, all with a mismatch."""
    return Said(
        "A symmetric snap gives a vertical jump, an asymmetric one an inclined jump.",
        f"""Without a mismatch the apex is {own.off_vertical:.1g} of its height off the vertical.
        With one, over {len(aside)} designs of the paper's ranges, it is off by
        {np.nanmin(aside):.2g} of its height at least and {np.nanmax(aside):.2g} at most.""",
        told,
    )


def accuracy(sweeps: Mapping[str, Sequence[Row]], off: Sequence[float]) -> str:
    """``off``: largest differences in x and in y."""
    return f"""`standard`, within {off[0]:.1g} L in x and {off[1]:.1g} L in y of `reference` at
        {len(sweeps["reference"])} mismatches"""


def text(sweeps: Mapping[str, Sequence[Row]], slopes: Sequence[float]) -> str:
    """What is shown, and how the two settings differ; ``slopes``: of paths while the beam slides,
    dx/dy."""
    own, papers = (column(sweeps[tier], "y_bar") for tier in ("standard", "paper"))
    higher = 100.0 * (papers / own - 1.0)
    aside = column(sweeps["paper"], "x_bar") - column(sweeps["standard"], "x_bar")
    nearer, farther = max(-2.0 * aside.min(), 0.0), max(2.0 * aside.max(), 0.0)
    return f"""Only the mismatch turns the flight aside: a symmetric snap strikes the
        ground under the centre of mass and throws the robot straight up. More pre-compression
        stretches the flight in both directions, more mass shrinks it. Friction is all that drives
        the robot sideways: while the beam slides on the ground, the path of the centre of mass
        leans by the friction coefficient whatever the mismatch (dx/dy = {min(slopes):.2f} to
        {max(slopes):.2f} where μ = {BASELINE[3]:g}; the weight takes a little of the lift). The
        smaller the mismatch, the sooner the sliding turns back, and the path turns up.

        With the paper's settings the same designs jump {higher.min():.1f} to {higher.max():.1f} %
        higher, because no material damping takes part of the energy (see *What causes the
        difference*), and come down up to {nearer:.1f} L nearer or {farther:.1f} L farther."""
