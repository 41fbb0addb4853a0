"""The law of saturation on made-up rows, a small sweep, and verdicts that come out each way."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from cells import STANDARD, all_done, check_figures

from experiments.arches.swings import snap_groups
from experiments.paper.asymmetry.part import (
    EPSILONS,
    SWEEPS,
    Asymmetry,
    largest_difference,
    linear_verdict,
    mismatches,
    saturation,
    saturation_verdict,
)
from experiments.paper.base import CONFIRMED, LIMITED, NOT_CONFIRMED
from experiments.trends import Saturation
from experiments.trends import saturating as law

GOOD = Saturation(
    slope=600.0, level_rad=0.6, threshold_rad=1e-3, other_threshold_rad=1.01e-3, misfit=0.01,
    exponent=1.0, linear_until_rad=3e-4, rise=0.15, rise_untilted=0.03,
)  # fmt: skip


def made_up(slope: float, threshold: float, rest: float = 0.0) -> list[dict[str, Any]]:
    """Rows that obey the law, and the tilt at rest on top of it."""
    return [
        {
            "delta_alpha_rad": lag,
            "theta_max_rad": float(law(np.array(lag), slope, threshold)) + rest * lag,
            "theta_later_rad": 1.0,
            "theta_rest_rad": rest * lag,
        }
        for lag in mismatches("standard")
    ]


def test_the_law_is_found_again():
    one = saturation(made_up(600.0, 1e-3))
    assert one.slope == pytest.approx(600.0) and one.threshold_rad == pytest.approx(1e-3)
    assert one.level_rad == pytest.approx(0.6) and one.misfit < 1e-6
    assert one.other_threshold_rad == pytest.approx(1e-3, rel=0.01)
    assert one.exponent == pytest.approx(1.0, abs=1e-4)
    # 1 / sqrt(1 + d^2) = 0.95 at d = 0.33.
    assert one.linear_until_rad == pytest.approx(0.33e-3, rel=0.05)
    assert 0.0 < one.rise < 0.01


def test_a_tilt_at_rest_is_told_apart():
    one = saturation(made_up(600.0, 1e-3, rest=0.5))
    assert one.rise == pytest.approx(0.5 * 0.19 / 0.6, rel=0.05)
    assert one.rise_untilted < 0.01


def test_what_does_not_saturate_is_misfitted():
    rows = [
        {**row, "theta_max_rad": 10.0 * row["delta_alpha_rad"] ** 0.5}
        for row in made_up(600.0, 1e-3)
    ]
    one = saturation(rows)
    assert one.misfit > 0.3 and one.exponent == pytest.approx(0.5)
    assert linear_verdict({0.1: one}, 1e-6) == NOT_CONFIRMED
    assert saturation_verdict({0.1: one}) == NOT_CONFIRMED


def test_the_verdicts_can_come_out_each_way():
    far = replace(GOOD, linear_until_rad=0.02)
    assert linear_verdict({0.1: far}, 1e-6) == CONFIRMED
    assert linear_verdict({0.1: far, 0.2: GOOD}, 1e-6) == LIMITED
    assert linear_verdict({0.1: GOOD}, 1e-4) == NOT_CONFIRMED
    rises = {0.02: CONFIRMED, 0.15: LIMITED, 0.8: NOT_CONFIRMED}
    assert {r: saturation_verdict({0.1: replace(GOOD, rise=r)}) for r in rises} == rises


def test_statements_section_and_figure(tmp_path):
    cells = all_done(Asymmetry(), STANDARD, lambda cell: made_up(600.0, 1e-3, rest=0.5))
    found = Asymmetry().conclude(cells)
    linear, level = found.statements
    assert linear.verdict == LIMITED and "600, 600, 600" in linear.found
    assert level.verdict == LIMITED and "rises by 16, 16, 16 %" in level.found
    assert len(found.section.tables["saturation"].rows) == len(SWEEPS) * len(EPSILONS)
    assert any("by a factor of 10 at least" in text for text in found.section.paragraphs)
    check_figures(found, tmp_path)


def test_differences_are_of_the_same_mismatch():
    rows = made_up(600.0, 1e-3)
    truth = [{**row, "theta_max_rad": 1.02 * row["theta_max_rad"]} for row in rows[::5]]
    assert largest_difference(rows, truth) == pytest.approx(1.0 - 1.0 / 1.02)


def test_mismatches_are_shared_among_settings():
    for setting in SWEEPS:
        assert len({*mismatches(setting)} & {*mismatches("standard")}) >= 9
    assert len(Asymmetry().plan(STANDARD, 0)) == len(SWEEPS) * len(EPSILONS)


def test_a_sweep_saturates():
    lags = [1e-5, 1e-2, 0.1]
    groups = snap_groups(STANDARD, "standard")
    rows = Asymmetry().compute({"groups": groups, "epsilon": 0.3, "mismatches_rad": lags})
    angles = [row["theta_max_rad"] for row in rows]
    assert angles[0] < 0.02 and angles[2] < 1.2 * angles[1]
