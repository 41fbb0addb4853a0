"""Our equilibria of the arch whose clamps turn alike, beside the exact elastica's."""

from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from snapjump.composition import Simulation
from snapjump.run.studies.base import Row
from snapjump.statics.arch import StaticArch
from snapjump.statics.critical import find_snap
from snapjump.statics.landmarks import find_landmarks

from ..order import fitted_order
from . import exact

MISMATCH_RAD = 0.1  # for which there are exact numbers of a beam that stretches
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


def exact_points(epsilon: float, kind: str) -> Iterator[tuple[float, float]]:
    """Angle and middle (``ymid``) or energy (``E``) of the exact equilibria: flat clamps up and
    down, the pitchfork, the state behind it, the fold, and the mirror images of these."""
    mirror = -1.0 if kind == "ymid" else 1.0
    flat, entry, angles = exact.flat(epsilon), exact.symmetric(epsilon), exact.stretching(epsilon)
    points = [
        (0.0, flat[kind]),
        (angles["alpha_pitchfork"], entry[f"{kind}_before_asym"]),
        (angles["alpha_pitchfork"], entry[f"{kind}_after_asym"]),
        (angles["alpha_fold"], entry[f"{kind}_before_fold"]),
    ]
    for alpha, value in points:
        yield alpha, value
        yield -alpha, mirror * value


def landmark_rows(simulation: Simulation, epsilons: Sequence[float]) -> list[Row]:
    """Angles (rad), heights (L) and energies (EI/L) of the landmarks at each pre-compression."""
    rows = []
    for epsilon in epsilons:
        found = find_landmarks(simulation, epsilon)
        before, after, fold = found.snap.before, found.snap.after, found.fold
        rows.append(
            {
                "epsilon": epsilon,
                "alpha_critical_rad": float(found.snap.alpha_rad),
                "alpha_fold_rad": float(fold.left),
                "alpha_back_rad": float(found.back_rad),
                "leaning": found.leaning,
                "midpoint_before_bar": before.midpoint,
                "lowest_before_bar": before.lowest,
                "energy_before_bar": before.energy,
                "midpoint_after_bar": after.midpoint,
                "energy_after_bar": after.energy,
                "negative_pivots_after": after.negative_pivots,
                "midpoint_fold_bar": fold.midpoint,
                "energy_fold_bar": fold.energy,
            }
        )
    return rows


def all_rows(simulation: Simulation, epsilons: Sequence[float]) -> list[Row]:
    """The same with what else there are exact numbers for: flat clamps and mismatched ones."""
    robot, mesh = simulation.robot, simulation.discretization
    rows = landmark_rows(simulation, epsilons)
    for row in rows:
        arch = StaticArch(robot, mesh, row["epsilon"])
        flat = arch.equilibrium(arch.solve_equilibrium(arch.guess(), 0.0, 0.0), 0.0, 0.0)
        snap = find_snap(robot, mesh, row["epsilon"], MISMATCH_RAD)
        row |= {
            "midpoint_flat_bar": flat.midpoint,
            "energy_flat_bar": flat.energy,
            "mismatched_alpha_critical_rad": float(snap.alpha_rad),
            "mismatched_midpoint_before_bar": snap.before.midpoint,
            "mismatched_energy_before_bar": snap.before.energy,
            "mismatched_midpoint_after_bar": snap.after.midpoint,
            "mismatched_energy_after_bar": snap.after.energy,
            "elements": mesh.elements,
        }
    return rows


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
