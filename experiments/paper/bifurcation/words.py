"""What is said of the critical angle and the loop."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from experiments.arches.landmarks import RIGID, STRETCHES, orders, overall
from experiments.paper.base import Said, listed, paragraphs, prose
from snapjump.run.studies.base import Row

TITLE = "The critical angle, and the loop"
BRANCHES = (
    "Height of the middle and elastic energy of all equilibria on these branches, and exact ones"
)
ANGLES = prose("""Critical angle against pre-compression; how much later the symmetric fold comes;
    the largest difference from the exact elastica, of angles, energies and heights, against the
    mesh""")
COMPARED = "Largest differences from the exact elastica at ε = 0.1, 0.2 and 0.3"
Rows = Sequence[Row]
Gaps = Sequence[float]
Tiers = Mapping[str, Rows]


def loop(epsilon: float) -> str:
    """Below the figure of the loop."""
    return prose(f"""Shapes before, at and after the snap (ε = {epsilon:g}); height of the middle
        against the clamp angle, forwards and back; and close by the first instability. Solid:
        stable; dashed: symmetric and unstable; dotted: leaning and unstable; circles: exact""")


def accuracy(tiers: Tiers) -> str:
    """The tiers, and how far off the exact beam they are."""
    own, reference = (overall(tiers[t], STRETCHES)[0] for t in ("standard", "reference"))
    return f"`standard` ({own:.2g} %), `reference` ({reference:.2g} %)"


def snap(tiers: Tiers, held: int, widths: Sequence[float], errors: Mapping[str, float]) -> Said:
    """At standard; ``errors``: of the angle, by tier (%)."""
    rows = tiers["standard"]
    angles = listed([row["alpha_critical_rad"] for row in rows], ".4f")
    mirrored = max(abs(row["alpha_critical_rad"] + row["alpha_back_rad"]) for row in rows)
    return Said(
        """Rotating the clamps makes the arch lose its stability at a critical angle and snap to
        the other side; rotating them back, it snaps back at another angle (the way back,
        hysteresis, is our reading)""",
        f"""critical angles {angles} rad for ε = {listed(r["epsilon"] for r in rows)}; at
        {held} of {len(rows)} the snapped arch is stable, of less energy and stays when its clamps
        turn back. It loses its own stability at the mirrored angle to within {mirrored:.0e} rad:
        the loop is {listed(widths, ".3f")} rad wide. The critical angles are within
        {errors["standard"]:.2g} % of the exact elastica's, {errors["reference"]:.2g} % at
        `reference`; with two fixed nodes a clamp at the paper's mesh they are off by up to
        {errors["paper"]:.2g} %""",
        accuracy(tiers),
    )


def growth(tiers: Tiers, epsilon: Any, alpha: Any, rises: int) -> Said:
    """Along all pre-compressions."""
    ratio = alpha / np.sqrt(epsilon)
    return Said(
        "The critical angle grows with the pre-compression ε (our reading)",
        f"""from {alpha[0]:.2g} rad at ε = {epsilon[0]:g} to {alpha[-1]:.2g} rad at
        ε = {epsilon[-1]:g}, at {rises} of {len(alpha) - 1} steps: as {ratio.min():.2f} to
        {ratio.max():.2f} √ε (2 √ε for shallow arches)""",
        accuracy(tiers),
    )


def fold(tiers: Tiers, angles: Rows, beyond: int, gaps: Gaps, on_paper: Gaps) -> Said:
    """How much later the fold comes (%), at standard and on the paper's mesh."""
    rows = tiers["standard"]
    higher = [100.0 * (r["midpoint_before_bar"] / r["midpoint_fold_bar"] - 1.0) for r in rows]
    energy = max(100.0 * (r["energy_fold_bar"] / r["energy_before_bar"] - 1.0) for r in rows)
    leaning = 100.0 * min(row["leaning"] for row in angles)
    return Said(
        """With equal clamp angles the snap is symmetric: the symmetric arch loses its stability at
        its fold (the fold is our reading)""",
        f"""at {beyond} of {len(gaps)} pre-compressions the arch tips over before it gets
        there ({leaning:.4g} % of the critical mode is antisymmetric): the fold of the symmetric
        branch comes {min(gaps):.2g} to {max(gaps):.2g} % later in the angle than the first
        instability (ε = {angles[0]["epsilon"]:g} to {angles[-1]["epsilon"]:g}; on the paper's mesh
        {min(on_paper):.2g} to {max(on_paper):.2g} % for ε = {rows[0]["epsilon"]:g} to
        {rows[-1]["epsilon"]:g}). There the arch has up to {energy:.2g} % more energy than at the
        first instability, where its middle is {min(higher):.2g} to {max(higher):.2g} % higher""",
        accuracy(tiers),
    )


def nodes(
    worst: tuple[float, str], angle: float, steps: Sequence[Row], late: float, tilted: float
) -> Said:
    """Errors (%) of the paper's mesh, of its critical angle, and what its step does to a snap."""
    coarse, fine = (1e3 * row["step_s"] for row in steps)
    return Said(
        "100 nodes and steps of 1 ms make the static analysis converged and accurate",
        f"""of angles, heights and energies of stable arches at ε = 0.1, 0.2 and 0.3 the
        largest error is {worst[0]:.2g} % ({worst[1]}); the critical angle is off by {angle:.2g} %.
        The cause is the clamps of two fixed nodes, whose error is of first order in the mesh.
        Equilibria know no step; clamps that turn at 20 rad/s, with a mismatch of 0.1 rad, snap at
        an angle {late:+.2g} % from that with {fine:g} ms if the step is {coarse:g} ms, and tilt
        {tilted:+.2g} %: the snap itself lasts {steps[1]["snap_duration_ms"]:.2g} ms""",
        "the paper's settings, 99 elements; exact elastica",
    )


def told(tiers: Tiers) -> list[str]:
    """What is shown, what is found, and how exact it is."""
    observed = orders(tiers)
    (own, what), (reference, _), (paper, where) = (
        overall(tiers[tier], STRETCHES) for tier in ("standard", "reference", "paper")
    )
    rigid = {tier: overall(tiers[tier], RIGID) for tier in ("standard", "reference", "paper")}
    return paragraphs(f"""Both clamps turn alike and slowly. The arch that is buckled up follows its
        branch until this loses its stability, snaps to the branch that is buckled down, and stays
        there when the clamps turn back, beyond the flat ones, until that branch loses its
        stability at the mirrored angle: a loop. Each branch is walked by continuation, also where
        it is unstable, and a point is called stable if its tangent stiffness has no negative
        eigenvalue.

        The symmetric branch does not end in its fold: shortly before, at a subcritical pitchfork,
        a branch of leaning shapes leaves it, which is unstable all the way to the mirrored
        pitchfork of the other side. A symmetric arch beyond the pitchfork tips over at the least
        disturbance.

        Beside the exact elastica of a beam that stretches as the paper's does, `standard` is off
        by at most {own:.2g} % ({what}) and `reference` by {reference:.2g} %, converging with order
        {observed.min():.2f} to {observed.max():.2f}. Beside an inextensible beam, whose heights
        and energies are known at more points, it is {rigid["standard"][0]:.2g} % and
        {rigid["reference"][0]:.2g} %, the beam's own stretching included. The paper's clamps of
        two fixed nodes are off by up to {paper:.2g} % ({where}) and {rigid["paper"][0]:.2g} %
        ({rigid["paper"][1]}): each holds a whole element straight, an error of first order in the
        mesh.""")
