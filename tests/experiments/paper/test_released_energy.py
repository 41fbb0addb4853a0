"""Critical states on a coarse mesh beside exact ones; lines, fits and verdicts on made-up ones."""

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from cells import STANDARD, all_done, check_figures

from experiments.arches import exact
from experiments.arches.critical import critical_rows, exact_value, largest_difference, within
from experiments.compositions import changed
from experiments.paper.base import CONFIRMED, LIMITED, NOT_CONFIRMED
from experiments.paper.released_energy.part import (
    PAPER,
    ReleasedEnergy,
    arches,
    energy_line,
    energy_verdict,
    fit_errors,
    heights_verdict,
    left_by_quadratics,
    linear,
)
from snapjump.run.studies.base import Cell
from snapjump.scenes.jump_start import fitted_mount_height_bar

COARSE = changed(STANDARD, {"discretization": {"elements": 40}})
EPSILONS = tuple(round(0.01 * k, 2) for k in range(1, 31))
Rows = list[dict[str, Any]]


def arch(epsilon: float, delta_alpha: float = 0.0, **changes: float) -> dict[str, Any]:
    """A made-up row: depths as the polynomials have them, energy in proportion."""
    row = {
        "epsilon": epsilon,
        "delta_alpha_rad": delta_alpha,
        "energy_released_bar": 80.0 * epsilon,
        "h1_bar": float(exact.released_height("h1", epsilon)),
        "h2_bar": float(exact.released_height("h2", epsilon)),
    }
    return {**row, **changes}


def bent(curvature: float) -> Rows:
    return [arch(e, energy_released_bar=80.0 * e + curvature * e**2) for e in EPSILONS]


def scaled(h1: float, h2: float, epsilons: Any = EPSILONS) -> Rows:
    rows = [arch(e) for e in epsilons]
    return [{**row, "h1_bar": h1 * row["h1_bar"], "h2_bar": h2 * row["h2_bar"]} for row in rows]


def test_critical_states_are_near_the_exact_ones() -> None:
    rows = critical_rows({"groups": COARSE, "epsilons": (0.1, 0.3), "delta_alphas_rad": (0.0, 0.1)})
    assert [row["delta_alpha_rad"] for row in rows] == [0.0, 0.0, 0.1, 0.1]
    assert 0.05 < largest_difference(rows, ["energy_released_bar"]) < 1.0
    assert 0.05 < largest_difference(rows, ["h1_bar", "h2_bar"]) < 1.5


def test_the_difference_from_exact_numbers_is_the_largest() -> None:
    rows = [
        arch(e, d, energy_released_bar=exact_value(e, d, "energy_released_bar") or 0.0)
        for d in (0.0, 0.1, 0.19)
        for e in exact.COMPARED
    ]
    assert largest_difference(rows, ["energy_released_bar"]) == 0.0
    rows[4]["energy_released_bar"] *= 1.03
    assert largest_difference(rows, ["energy_released_bar"]) == pytest.approx(3.0)
    assert exact_value(0.2, 0.1, "h1_bar") is None


def test_the_range_of_the_paper() -> None:
    assert len(within(bent(0.0))) == 21 and energy_line(bent(25.0)).worst_place == 0.01


def test_the_released_program_s_polynomials() -> None:
    assert exact.released_factor() * exact.released_height("h1", 0.17) == pytest.approx(
        fitted_mount_height_bar(0.17)
    )
    assert exact.released_height("h2", 0.2) == pytest.approx(0.2684)
    assert np.allclose(fit_errors(scaled(0.5, 1.0), "h1"), 100.0)
    assert left_by_quadratics(scaled(1.0, 1.0), "h2") < 1e-9


def test_energy_that_is_more_or_less_linear() -> None:
    verdicts = [energy_verdict(bent(curvature)) for curvature in (1.0, 30.0, 200.0)]
    assert verdicts == [CONFIRMED, LIMITED, NOT_CONFIRMED]

    def told(curvature: float) -> str:
        return linear(bent(curvature), bent(curvature), (0.0, 0.0)).found

    assert "80 ε" in told(0.0) and "by -" in told(-200.0)


def test_polynomials_that_hold_for_an_arch_or_for_a_mesh() -> None:
    def verdict(converged: float, own: float) -> str:
        return heights_verdict(scaled(converged, 1.0), scaled(own, 1.0, exact.COMPARED))

    assert verdict(0.995, 1.0) == CONFIRMED
    assert verdict(0.95, 0.99) == LIMITED
    assert verdict(0.95, 0.97) == NOT_CONFIRMED


def test_the_plan_and_the_conclusion_with_its_figures(tmp_path: Path) -> None:
    part = ReleasedEnergy()
    planned = part.plan(STANDARD, 0)
    assert json.dumps([dict(cell.inputs) for cell in planned])
    groups = arches(STANDARD)[PAPER]["groups"]
    assert groups["discretization"] == {"name": "der", "elements": 66, "clamp": "two_nodes"}

    def rows_of(cell: Cell) -> Rows:
        lags, epsilons = cell.inputs["delta_alphas_rad"], cell.inputs["epsilons"]
        return [arch(e, d) for d in lags for e in epsilons]

    found = part.conclude(all_done(part, STANDARD, rows_of))
    assert len(found.statements) == 2 and np.isfinite(list(found.summary.values())).all()
    assert len(found.section.tables["released_heights_errors"].rows) == 5
    check_figures(found, tmp_path, 20_000)
