"""Errors of the parameters: cells, straight lines, and the verdict with curves that are made up."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from cells import STANDARD, all_done, check_figures, done

from experiments.compositions import described
from experiments.paper.imperfections import judge
from experiments.paper.imperfections.judge import (
    Changes,
    changes_of,
    largest_elsewhere,
    tangents_of,
)
from experiments.paper.imperfections.part import Imperfections
from experiments.paper.settings import BASELINE, NAMES
from experiments.paper.statement import CONFIRMED, LIMITED, NOT_CONFIRMED
from snapjump.composition import with_tier
from snapjump.run.studies.base import Cell, Row
from snapjump.simulation import simulate_jump

ERRORS = np.linspace(-0.2, 0.2, 41)
Power = Callable[[np.ndarray], np.ndarray]


def curve(power: float) -> Changes:
    """An apex that goes as each parameter to some power."""
    relative = (1.0 + ERRORS) ** power - 1.0
    return Changes(
        ERRORS, np.array([5.0, 14.0]), np.broadcast_to(relative[None, :, None], (4, 41, 2))
    )


def others(change: float) -> list[Row]:
    return [
        {"design": n, "parameter": name, "factor": factor, **dict.fromkeys(
            ("x_change", "y_change", "moved"), change if factor > 1.0 else -0.5 * change)}
        for n in range(3)
        for name in NAMES
        for factor in (0.8, 1.2)
    ]  # fmt: skip


def verdict(power: float, change: float) -> str:
    tiers = dict.fromkeys(("standard", "paper", "reference"), curve(power))
    return judge.robust(tiers, others(change)).verdict


def test_in_proportion_or_not():
    assert verdict(0.5, 0.1) == CONFIRMED
    assert verdict(1.0, 0.1) == CONFIRMED
    assert verdict(-1.0, 0.1) == LIMITED  # 25 % by 20 % less
    assert verdict(0.5, 0.39) == LIMITED  # but not elsewhere
    assert verdict(0.5, 0.41) == NOT_CONFIRMED  # where errors are magnified more than twofold
    assert verdict(2.0, 0.1) == NOT_CONFIRMED


def test_straight_lines():
    square = curve(2.0)
    assert square.secants == pytest.approx(np.full((4, 2), 2.0))
    assert square.trends == pytest.approx(np.full((4, 2), 2.0))
    # (1 + e)^2 is off its tangent by e^2.
    for error in judge.HELD:
        assert square.deviations(np.full((4, 2), 2.0), error) == pytest.approx(error**2)
    assert square.largest.max() == pytest.approx(0.44)


def test_what_does_not_jump_elsewhere_is_no_small_change():
    rows = others(0.1)
    rows[0]["x_change"] = None
    found = largest_elsewhere(rows, "x_change", 0.2)
    assert found.shape == (4, 3)
    assert found[0, 0] == np.inf and found[1:].max() == pytest.approx(0.1)


def test_cells_at_draft():
    draft = described(with_tier("draft"))
    part = Imperfections()
    inputs: dict[str, Any] = {"kind": "curves", "groups": draft, "factors": [0.9, 1.0, 1.1]}
    rows = part.compute(inputs)
    found = changes_of(done(Cell("curves", inputs), rows))
    alone = simulate_jump(accuracy="draft")  # the baseline is the default
    assert found.apex == pytest.approx([alone.x_bar, alone.y_bar], rel=1e-12)
    assert found.at(0.0) == pytest.approx(0.0)
    # More pre-compression is more energy, more mass less height.
    assert (
        found.at(0.1)[NAMES.index("epsilon"), 1] > 0.0 > found.at(0.1)[NAMES.index("mass_bar"), 1]
    )
    elsewhere = part.compute(
        {"kind": "elsewhere", "groups": draft, "seed": 0, "designs": 2, "factors": [0.8, 1.2]}
    )
    assert len(elsewhere) == 2 * 4 * 2
    for name, middle in zip(NAMES, BASELINE, strict=True):
        assert 0.0 < elsewhere[0][name] < 10.0 * middle


def test_exact_slopes_agree_with_secants_where_steps_are_fine():
    part, groups = Imperfections(), described(with_tier("reference"))
    inputs: dict[str, Any] = {"kind": "curves", "groups": groups, "factors": [0.98, 1.0, 1.02]}
    rows = part.compute(inputs)
    curve = changes_of(done(Cell("curves", inputs), rows))
    rows = part.compute({"kind": "slopes", "groups": groups})
    exact = tangents_of(done("slopes", rows))
    assert [row["parameter"] for row in rows] == list(NAMES)
    assert np.abs(exact - curve.secants).max() < 0.1  # of up to 1.3


def test_plan_conclusion_and_figures(tmp_path):
    part = Imperfections()

    def rows_of(cell: Cell) -> list[Row]:
        if cell.inputs["kind"] == "curves":
            return [
                {"parameter": name, "factor": f, "x_bar": 5.0 * f, "y_bar": 14.0 / f**0.5}
                for name in NAMES
                for f in cell.inputs["factors"]
            ]
        if cell.inputs["kind"] == "slopes":
            return [{"parameter": n, "x_elasticity": 1.0, "y_elasticity": -0.5} for n in NAMES]
        return others(0.1)

    cells = all_done(part, STANDARD, rows_of)
    # Every percent, and the eight of the released program's ten points that lie in between.
    assert len(cells["curves, standard"].cell.inputs["factors"]) == 49
    found = part.conclude(cells)
    assert [one.verdict for one in found.statements] == [CONFIRMED]
    assert found.summary["elasticity_epsilon_x_trend"] == pytest.approx(1.0)
    check_figures(found, tmp_path)
