"""Our equilibria beside the exact elastica's, and verdicts on where and how the arch gives way."""

from collections.abc import Mapping, Sequence

import numpy as np

from experiments.order import fitted_order
from experiments.paper import exact
from experiments.paper.bifurcation.compute import MISMATCH_RAD
from experiments.paper.statement import Statement, verdict
from snapjump.run.studies.base import Row

STRETCHES, RIGID = "stretches", "does not stretch"
# The meshes whose errors an order is fitted to, coarsest first.
LADDER = ("draft", "standard", "reference")
# Key of our rows: what it is, and of which exact beam there is a number.
NAMES = {
    "alpha_critical_rad": ("critical angle", STRETCHES),
    "alpha_fold_rad": ("angle of the symmetric fold", STRETCHES),
    "mismatched_alpha_critical_rad": ("critical angle, Δα = 0.1", STRETCHES),
    "mismatched_midpoint_before_bar": ("middle before the snap, Δα = 0.1", STRETCHES),
    "mismatched_energy_before_bar": ("energy before the snap, Δα = 0.1", STRETCHES),
    "mismatched_midpoint_after_bar": ("middle after the snap, Δα = 0.1", STRETCHES),
    "mismatched_energy_after_bar": ("energy after the snap, Δα = 0.1", STRETCHES),
    "midpoint_flat_bar": ("middle, flat clamps", RIGID),
    "energy_flat_bar": ("energy, flat clamps", RIGID),
    "midpoint_before_bar": ("middle before the snap", RIGID),
    "lowest_before_bar": ("lowest point before the snap", RIGID),
    "energy_before_bar": ("energy before the snap", RIGID),
    "midpoint_after_bar": ("middle after the snap", RIGID),
    "energy_after_bar": ("energy after the snap", RIGID),
    "midpoint_fold_bar": ("middle at the symmetric fold", RIGID),
    "energy_fold_bar": ("energy at the symmetric fold", RIGID),
}


def exact_row(epsilon: float) -> dict[str, float]:
    """The exact number for each key of NAMES."""
    flat, alike = exact.flat(epsilon), exact.symmetric(epsilon)
    angles = exact.stretching(epsilon)
    lagging = exact.mismatched(epsilon, MISMATCH_RAD, stretches=True)
    return {
        "alpha_critical_rad": angles["alpha_pitchfork"],
        "alpha_fold_rad": angles["alpha_fold"],
        "mismatched_alpha_critical_rad": lagging["aL"],
        "mismatched_midpoint_before_bar": lagging["before_ymid"],
        "mismatched_energy_before_bar": lagging["before_E"],
        "mismatched_midpoint_after_bar": lagging["after_ymid"],
        "mismatched_energy_after_bar": lagging["after_E"],
        "midpoint_flat_bar": flat["ymid"],
        "energy_flat_bar": flat["E"],
        "midpoint_before_bar": alike["ymid_before_asym"],
        "lowest_before_bar": alike["ymin_before_asym"],
        "energy_before_bar": alike["E_before_asym"],
        "midpoint_after_bar": alike["ymid_after_asym"],
        "energy_after_bar": alike["E_after_asym"],
        "midpoint_fold_bar": alike["ymid_before_fold"],
        "energy_fold_bar": alike["E_before_fold"],
    }


def largest_difference(rows: Sequence[Row], key: str) -> float:
    """Of one number from the exact one, over all pre-compressions (%)."""
    return max(100.0 * abs(row[key] / exact_row(row["epsilon"])[key] - 1.0) for row in rows)


def overall(rows: Sequence[Row], beam: str) -> tuple[float, str]:
    """The largest difference (%) of all numbers for that exact beam, and what it is of."""
    keys = [key for key, (_, kind) in NAMES.items() if kind == beam]
    return max((largest_difference(rows, key), NAMES[key][0]) for key in keys)


def order(tiers: Mapping[str, Sequence[Row]], key: str) -> float:
    """Of convergence to the exact beam that stretches like ours, on the half-element clamps."""
    sizes = [1.0 / tiers[tier][0]["elements"] for tier in LADDER]
    return fitted_order(sizes, [largest_difference(tiers[tier], key) for tier in LADDER])


def orders(tiers: Mapping[str, Sequence[Row]]) -> np.ndarray:
    """All that can be observed."""
    return np.array([order(tiers, k) for k, (_, beam) in NAMES.items() if beam == STRETCHES])


def comparison(tiers: Mapping[str, Sequence[Row]]) -> list[Row]:
    """A row for each number: its largest difference at every tier, and the order."""
    return [
        {
            "number": name,
            "exact beam": beam,
            **{f"{tier} (%)": largest_difference(rows, key) for tier, rows in tiers.items()},
            "order": order(tiers, key) if beam == STRETCHES else None,
        }
        for key, (name, beam) in NAMES.items()
    ]


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
