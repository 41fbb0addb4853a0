"""Numbers of others that the static parts are compared with: the exact elastica's, and fits."""

import json
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from numpy.polynomial import Polynomial

DATA = Path(__file__).parents[1] / "data"
COMPARED = (0.1, 0.2, 0.3)  # epsilon, at which there are exact numbers of every kind
SYMMETRIC = (0.01, 0.03, 0.05, *COMPARED)  # of clamps that turn alike


@cache
def _entries(name: str) -> dict[str, Any]:
    return dict(json.loads((DATA / f"{name}.json").read_text()))


def flat(epsilon: float) -> dict[str, float]:
    """The inextensible arch between flat clamps: ``ymid`` (L), ``E`` (EI/L)."""
    return dict(_entries("exact_arch")[f"S4_postbuckled_eps{epsilon:g}"])


def symmetric(epsilon: float) -> dict[str, float]:
    """The inextensible arch whose clamps turn alike: ``alpha_asym``, ``alpha_fold`` (rad), heights
    ``ymid_*`` and ``ymin_*`` (L) and energies ``E_*`` (EI/L) at either, before and after."""
    return dict(_entries("exact_arch")[f"S5_snap_sym_eps{epsilon:g}"])


def stretching(epsilon: float) -> dict[str, float]:
    """``alpha_pitchfork``, ``alpha_fold`` (rad) of the paper's beam, which stretches."""
    return dict(_entries("exact_arch")[f"S7_sym_lam5.2e-07_eps{epsilon:g}"])


def mismatched(epsilon: float, delta_alpha: float, stretches: bool) -> dict[str, float]:
    """The fold with mismatched clamps: ``aL`` (rad), ``before_*`` and ``after_*``.

    ``delta_alpha``: 0.1 or, for an inextensible arch, 0.19 rad.
    """
    ratio = "5.2e-07" if stretches else "0.0e+00"
    return dict(_entries("exact_arch")[f"S7_mismatch_eps{epsilon:g}_d{delta_alpha:g}_lam{ratio}"])


def shallow() -> dict[str, float]:
    """Energies over epsilon (EI/L) in the limit of shallow arches."""
    return dict(_entries("exact_arch")["S6_energies_over_eps"])


def released_height(name: str, epsilon: Any) -> Any:
    """The released program's polynomial for ``h1`` or ``h2`` (L), without its factor of 1.01."""
    return Polynomial(_entries("released_heights")[name])(np.asarray(epsilon, float))


def released_factor() -> float:
    """What the released program multiplies h1 by."""
    return float(_entries("released_heights")["h1_factor"])
