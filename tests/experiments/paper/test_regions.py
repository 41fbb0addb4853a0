"""Achievable regions: outlines, their cells, and both verdicts with regions that are made up."""

from typing import Any

import numpy as np
import pytest
from cells import STANDARD, all_done, check_figures

from experiments.compositions import described
from experiments.paper.base import CONFIRMED, LIMITED, NOT_CONFIRMED
from experiments.paper.cells import shipped_forward, shipped_inputs
from experiments.paper.regions.part import (
    EXTREMES,
    POINTS,
    Regions,
    grid,
    mass_exponent,
    region_of,
    row_of,
    shrinks,
    widens,
)
from experiments.paper.settings import NAMES
from snapjump.checks import ParameterError
from snapjump.composition import with_tier
from snapjump.inverse.base import Problem
from snapjump.run.studies.base import Cell
from snapjump.targets.region import AchievableRegion, SimulatedRegion

LEVELS = (4.0, 6.0, 8.0)
NEAR = 405, 0.1, 0.1  # designs, and percents, at reference


def rectangle(
    width: float, low: float, high: float, mass_bar: float = 1.0, mu: float = 0.3
) -> SimulatedRegion:
    """A region that is one."""
    x, y = np.meshgrid(np.linspace(0.0, width, 5), np.linspace(low, high, 5), indexing="ij")
    apexes = np.stack([x, y], axis=-1)
    return SimulatedRegion(mass_bar, mu, apexes, apexes)


@pytest.fixture(scope="module")
def cells() -> list[Cell]:
    return list(Regions().plan(STANDARD, 0))


def test_a_line_of_the_table():
    row = row_of(rectangle(3.0, 2.0, 6.0), LEVELS)
    assert row["area by every 2nd design"] == row["area by the forward model"] == row["area"]
    assert row["width at y = 4"] == pytest.approx(3.0) and row["width at y = 8"] == 0.0


def test_a_cell_at_draft_is_the_region_that_inverse_design_knows():
    mass_bar, mu = 0.768, 0.3
    draft = described(with_tier("draft"))
    inputs = {"kind": "jumps", "groups": draft, "designs": grid((mass_bar, mu), 3)}
    region = region_of(Regions().compute(inputs))
    assert (region.mass_bar, region.mu) == (mass_bar, mu)
    # The forward model's apexes are within a percent or two of a coarse simulation's.
    assert np.abs(region.apexes / region.predicted - 1.0).max() < 0.1
    forward = shipped_forward()
    low, high = np.array(forward.ranges[:2]).T
    simulator: Any = None
    problem = Problem(np.zeros(2), mass_bar, mu, low, high, forward, simulator)
    known = AchievableRegion.of(problem, forward, 3)
    assert known.apexes == pytest.approx(region.predicted, rel=1e-9)


def test_the_forward_model_must_be_that_of_the_physical_model():
    with pytest.raises(ParameterError, match="trained with"):
        shipped_inputs(described(with_tier("paper")))


def test_cells_of_all_tiers(cells):
    tiers = [cell.name.split(",")[0] for cell in cells]
    assert {tier: tiers.count(tier) for tier in POINTS} == {
        "standard": 9,
        "paper": len(EXTREMES),
        "reference": len(EXTREMES),
    }
    assert len({cell.name for cell in cells}) == len(cells)


def test_heavier_robots_have_smaller_regions_or_not():
    shrinking = [rectangle(6.0 / m, 2.0 / m, 20.0 / m, mass_bar=m) for m in (0.5, 1.0, 2.0)]
    found = shrinks(shrinking, shrinking, NEAR)
    assert found.verdict == CONFIRMED
    assert mass_exponent(shrinking) == pytest.approx(-2.0)
    assert "to the power -2.00" in found.found
    assert shrinks(shrinking[::-1], shrinking, NEAR).verdict == NOT_CONFIRMED
    assert shrinks(shrinking, shrinking[::-1], NEAR).verdict == NOT_CONFIRMED
    narrow_then_low = [rectangle(6.0, 2.0, 8.0), rectangle(2.0, 2.0, 9.0, 2.0)]
    assert shrinks(narrow_then_low, narrow_then_low, NEAR).verdict == LIMITED


def test_friction_widens_regions_or_not():
    frictions = (0.1, 0.3, 0.6)

    def regions(widths: Any, highs: Any) -> list[SimulatedRegion]:
        return [
            rectangle(w, 2.0, high, mu=mu)
            for w, high, mu in zip(widths, highs, frictions, strict=True)
        ]

    saturated, same = (2.0, 9.5, 10.0), (10.0, 10.0, 10.0)

    def verdict(widths: Any, highs: Any) -> str:
        found = regions(widths, highs)
        return widens(found, found, LEVELS, NEAR).verdict

    assert verdict(saturated, same) == CONFIRMED
    assert verdict(saturated, (10.0, 9.4, 9.0)) == LIMITED  # heights move by a tenth
    assert verdict(saturated, (10.0, 9.0, 7.0)) == NOT_CONFIRMED
    assert verdict((2.0, 5.0, 10.0), same) == NOT_CONFIRMED  # never saturates
    assert verdict((9.0, 5.0, 4.0), same) == NOT_CONFIRMED  # narrower


def test_conclusion_and_figures_of_made_up_regions(tmp_path):
    def rows_of(cell: Cell) -> Any:
        designs = np.array(cell.inputs["designs"])
        off = 0.98 if cell.name.startswith("reference") else 1.0
        return [
            {
                **dict(zip(NAMES, design, strict=True)),
                "status": "ok",
                "x_bar": off * (40.0 * design[0] * design[3] ** 0.2 / design[2]),
                "y_bar": 80.0 * design[1] / design[2],
            }
            for design in designs.tolist()
        ]

    found = Regions().conclude(all_done(Regions(), STANDARD, rows_of))
    assert found.statements[0].verdict == CONFIRMED
    assert "95 % of x within 2 %, of y within" in found.statements[0].accuracy
    assert found.summary["region_area_mass_exponent"] == pytest.approx(-2.0)
    check_figures(found, tmp_path)
