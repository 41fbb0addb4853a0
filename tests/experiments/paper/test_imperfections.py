"""Errors of the parameters: cells, straight lines, and the verdict with curves that are made up."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from cells import STANDARD, all_done, check_figures

from experiments.compositions import described
from experiments.paper.base import CONFIRMED, LIMITED, NOT_CONFIRMED
from experiments.paper.imperfections.part import Imperfections, curves_of, elsewhere, robust
from experiments.paper.settings import BASELINE, NAMES
from snapjump.composition import with_tier
from snapjump.run.studies.base import Cell, Row
from snapjump.simulation import simulate_jump
from snapjump.targets.manufacturing import ErrorCurves, alone_off

ERRORS = np.linspace(-0.2, 0.2, 41)


def curve(power: float) -> ErrorCurves:
    """An apex that goes as each parameter to some power."""
    relative = (1.0 + ERRORS) ** power - 1.0
    return ErrorCurves(ERRORS, np.broadcast_to(relative[None, :, None], (4, 41, 2)))


def jump(x: float, y: float, status: str = "ok") -> Row:
    return {"status": status, "x_bar": x, "y_bar": y}


def others(change: float) -> list[Row]:
    """Three designs, and each of their parameters off downwards and upwards."""
    changes = [-0.5 * change, change] * 12
    return [jump(5.0, 14.0)] * 3 + [jump(5.0 * (1.0 + c), 14.0 * (1.0 + c)) for c in changes]


def verdict(power: float, change: float) -> str:
    return robust({"standard": curve(power)}, elsewhere(others(change)))


def test_in_proportion_or_not():
    assert verdict(0.5, 0.1) == CONFIRMED
    assert verdict(1.0, 0.1) == CONFIRMED
    assert verdict(-1.0, 0.1) == LIMITED  # 25 % by 20 % less
    assert verdict(0.5, 0.39) == LIMITED  # but not elsewhere
    assert verdict(0.5, 0.41) == NOT_CONFIRMED  # where errors are magnified more than twofold
    assert verdict(2.0, 0.1) == NOT_CONFIRMED


def test_what_does_not_jump_elsewhere_is_no_small_change():
    rows = others(0.1)
    rows[3] = jump(0.0, 0.4, "no_jump")
    found = elsewhere(rows)["x"]
    assert found.shape == (4, 3)
    assert found[0, 0] == np.inf and found[1:].max() == pytest.approx(0.1)


def curves(tier: str, factors: Any) -> ErrorCurves:
    inputs = {
        "kind": "jumps",
        "groups": described(with_tier(tier)),
        "designs": alone_off(BASELINE, factors),
    }
    return curves_of(Imperfections().compute(inputs), np.array(factors))


def test_cells_at_draft():
    found = curves("draft", [0.9, 1.0, 1.1])
    alone = simulate_jump(accuracy="draft")  # the baseline is the default
    heavy = replace(with_tier("draft").environment, mass_bar=1.1 * BASELINE[2])
    more = simulate_jump(accuracy="draft", environment=heavy)
    mass = NAMES.index("mass_bar")
    assert found.at(0.1)[mass, 1] == pytest.approx(more.y_bar / alone.y_bar - 1.0, rel=1e-9)
    assert found.at(0.0) == pytest.approx(0.0)
    # More pre-compression is more energy, more mass less height.
    assert found.at(0.1)[NAMES.index("epsilon"), 1] > 0.0 > found.at(0.1)[mass, 1]


def test_exact_slopes_agree_with_secants_where_steps_are_fine():
    found = curves("reference", [0.98, 1.0, 1.02])
    rows = Imperfections().compute({"kind": "slopes", "groups": described(with_tier("reference"))})
    assert [row["parameter"] for row in rows] == list(NAMES)
    exact = np.array([[row["x_elasticity"], row["y_elasticity"]] for row in rows])
    assert np.abs(exact - found.secants(0.02)).max() < 0.1  # of up to 1.3


def test_plan_conclusion_and_figures(tmp_path):
    part = Imperfections()

    def rows_of(cell: Cell) -> list[Row]:
        if cell.inputs["kind"] == "slopes":
            return [{"parameter": n, "x_elasticity": 1.0, "y_elasticity": -0.5} for n in NAMES]
        factors = np.array(cell.inputs["designs"]) / BASELINE
        if cell.name == "elsewhere":
            factors = np.vstack(
                [np.ones((64, 4)), np.tile(alone_off(np.ones(4), (0.8, 1.2)), (64, 1))]
            )
        return [jump(5.0 * f, 14.0 / f**0.5) for f in factors.prod(axis=1)]

    cells = all_done(part, STANDARD, rows_of)
    # Every percent, and the eight of the released program's ten points that lie in between.
    assert len(cells["curves, standard"].rows) == 4 * 49
    found = part.conclude(cells)
    assert [one.verdict for one in found.statements] == [CONFIRMED]
    assert found.summary["elasticity_epsilon_x_trend"] == pytest.approx(1.0)
    check_figures(found, tmp_path)
