"""Verdicts on where and how the arch loses its stability."""

from collections.abc import Mapping, Sequence

import numpy as np

from experiments.paper.bifurcation.compare import STRETCHES, largest_difference, overall
from experiments.paper.statement import Statement, verdict
from snapjump.studies.base import Row

COMMAND = "task=paper figure=bifurcation"
# The angle counts as that of the exact beam within the error that the tier promises of a jump.
ANGLE_PERCENT = 0.5
# A difference between two angles is one of the arch if it is this many times their error.
BEYOND_ERROR = 3.0


def snap_statement(tiers: Mapping[str, Sequence[Row]]) -> Statement:
    """Instability at a critical angle, the snap to the other side, and the hysteresis."""
    rows = tiers["standard"]
    error = largest_difference(rows, "alpha_critical_rad")
    held = [snaps(row) for row in rows]
    angles = listed([row["alpha_critical_rad"] for row in rows], ".4f")
    widths = listed([loop_width(row) for row in rows], ".3f")
    mirrored = max(abs(row["alpha_critical_rad"] + row["alpha_back_rad"]) for row in rows)
    return Statement(
        "Rotating the clamps makes the arch lose its stability at a critical angle and snap to "
        "the other side; rotating them back, it snaps back at another angle (hysteresis)",
        verdict(all(held) and error < ANGLE_PERCENT, any(held)),
        f"critical angles {angles} rad for ε = {listed([r['epsilon'] for r in rows], 'g')}; at "
        f"{sum(held)} of {len(held)} the snapped arch is stable, of less energy and stays when its "
        "clamps turn back. It loses its own stability at the mirrored angle to within "
        f"{mirrored:.0e} rad: the loop is {widths} rad wide. The critical angles are "
        f"within {error:.2g} % of the exact elastica's, "
        f"{largest_difference(tiers['reference'], 'alpha_critical_rad'):.2g} % at `reference`; "
        "with two fixed nodes a clamp at the paper's mesh they are off by up to "
        f"{largest_difference(tiers['paper'], 'alpha_critical_rad'):.2g} %",
        accuracy(tiers),
        COMMAND,
    )


def snaps(row: Row) -> bool:
    """Whether the arch gets to a stable state of less energy on the other side, and stays there
    when its clamps turn back to where it snapped."""
    return bool(
        row["midpoint_after_bar"] < 0.0 < row["midpoint_before_bar"]
        and row["negative_pivots_after"] == 0
        and row["energy_after_bar"] < row["energy_before_bar"]
        and loop_width(row) > ANGLE_PERCENT / 100.0 * row["alpha_critical_rad"]
    )


def loop_width(row: Row) -> float:
    """Between the snaps there and back (rad)."""
    return float(row["alpha_critical_rad"] - row["alpha_back_rad"])


def growth_statement(angles: Sequence[Row], tiers: Mapping[str, Sequence[Row]]) -> Statement:
    """The critical angle against the pre-compression."""
    epsilon = np.array([row["epsilon"] for row in angles])
    alpha = np.array([row["alpha_critical_rad"] for row in angles])
    rises = np.diff(alpha) > 0.0
    inside = epsilon[1:] >= min(row["epsilon"] for row in tiers["standard"])
    ratio = alpha / np.sqrt(epsilon)
    return Statement(
        "The critical angle grows with the pre-compression ε",
        verdict(bool(rises.all()), bool(rises[inside].all())),
        f"from {alpha[0]:.2g} rad at ε = {epsilon[0]:g} to {alpha[-1]:.2g} rad at "
        f"ε = {epsilon[-1]:g}, at {rises.sum()} of {len(rises)} steps: as {ratio.min():.2f} to "
        f"{ratio.max():.2f} √ε (2 √ε for shallow arches)",
        accuracy(tiers),
        COMMAND,
    )


def fold_statement(angles: Sequence[Row], tiers: Mapping[str, Sequence[Row]]) -> Statement:
    """Whether the symmetric fold is the first instability."""
    gaps = [gap_percent(row) for row in angles]
    error = largest_difference(tiers["standard"], "alpha_critical_rad")
    at_fold = [gap < BEYOND_ERROR * error for gap in gaps]
    rows = tiers["standard"]
    higher = [100.0 * (r["midpoint_before_bar"] / r["midpoint_fold_bar"] - 1.0) for r in rows]
    energy = max(100.0 * (r["energy_fold_bar"] / r["energy_before_bar"] - 1.0) for r in rows)
    leaning = min(row["leaning"] for row in angles)
    on_paper = [gap_percent(row) for row in tiers["paper"]]
    return Statement(
        "With equal clamp angles the snap is symmetric: the symmetric arch loses its stability at "
        "its fold (our reading)",
        verdict(all(at_fold), any(at_fold)),
        f"at {len(gaps) - sum(at_fold)} of {len(gaps)} pre-compressions the arch tips over before "
        f"it gets there ({100.0 * leaning:.4g} % of the critical mode is antisymmetric): "
        f"the fold of the symmetric branch comes {min(gaps):.2g} to {max(gaps):.2g} % later in the "
        "angle than the first instability "
        f"(ε = {angles[0]['epsilon']:g} to {angles[-1]['epsilon']:g}; on the paper's mesh "
        f"{min(on_paper):.2g} to {max(on_paper):.2g} % for ε = {rows[0]['epsilon']:g} to "
        f"{rows[-1]['epsilon']:g}). There the arch has up to {energy:.2g} % more energy than at "
        f"the first instability, where its middle is {min(higher):.2g} to {max(higher):.2g} % "
        "higher",
        accuracy(tiers),
        COMMAND,
    )


def gap_percent(row: Row) -> float:
    """How much later the fold comes than the first instability (% of the angle)."""
    return float(100.0 * (row["alpha_fold_rad"] / row["alpha_critical_rad"] - 1.0))


def accuracy(tiers: Mapping[str, Sequence[Row]]) -> str:
    """The tiers, and how far off the exact beam they are."""
    return ", ".join(
        f"`{tier}` ({overall(tiers[tier], STRETCHES)[0]:.2g} %)"
        for tier in ("standard", "reference")
    )


def listed(values: Sequence[float], how: str) -> str:
    """Numbers in a sentence."""
    return ", ".join(f"{value:{how}}" for value in values)
