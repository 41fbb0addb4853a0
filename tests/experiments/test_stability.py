"""Rules, maps and coverage on made-up rows; what is refused needs no simulation."""

import math
from itertools import product

import numpy as np
import pytest

from experiments.compositions import composed, described
from experiments.stability.axes import maps
from experiments.stability.calibration import coverage, level_row, overall
from experiments.stability.jumps import alike, jump_rows
from experiments.stability.physics import all_are, spread
from experiments.stability.rules import broken, with_truth
from snapjump.checks import ParameterError
from snapjump.composition import with_tier

BASE = described(with_tier("draft"))
GOOD = {
    "across": 1.0, "up": 2.0, "design": 0, "status": "ok", "x_bar": 5.0, "y_bar": 14.0,
    "min_gap_m": 1e-4, "newton_iterations": 1000.0, "seconds": 0.1, "x_error_estimate_percent": 1.0,
    "y_error_estimate_percent": 0.1, "error_sum_bar": 1e-4, "within_tier": True,
}  # fmt: skip


def rules_of(**changes):
    (row,) = with_truth([{**GOOD, **changes}], [GOOD], own=True)
    return broken(row, 2000.0, 3.0, "logbarrier")


def test_rules():
    assert rules_of() == []
    assert rules_of(newton_iterations=2001.0) == ["hung"]
    assert rules_of(min_gap_m=-1e-9) == ["negative_gap"]
    assert rules_of(x_bar=5.5) == ["silent"]
    assert rules_of(x_bar=5.5, within_tier=False) == []
    assert rules_of(status="no_jump") == ["silent"]
    assert rules_of(status="step_underflow", x_bar=None, y_bar=None, within_tier=False) == []
    assert broken({**GOOD, "x_bar": math.nan}, 2000.0, 3.0, "logbarrier") == ["not_finite"]
    assert broken({**GOOD, "min_gap_m": -1e-3}, 2000.0, 3.0, "penalty") == []


def test_errors_are_those_of_the_same_problem():
    other = {**GOOD, "across": 3.0, "x_bar": 1.0}
    found = with_truth([GOOD, other], [{**GOOD, "x_bar": 4.0}], own=True)
    assert found[0]["true_x_percent"] == pytest.approx(25.0)
    assert "true_x_percent" not in found[1]
    assert "true_x_percent" in with_truth([other], [{**GOOD, "across": ""}], own=False)[0]


@pytest.mark.parametrize("full", [False, True])
def test_every_place_of_every_map_is_composed_or_refused(full):
    for one in maps(full):
        places, refused = list(product(one.across.values, one.up.values)), 0
        for across, up in places:
            try:
                composed(one.groups(BASE, across, up))
            except ParameterError:
                refused += 1
        assert refused <= 0.2 * len(places), one.name


def test_what_is_refused_is_a_row_and_what_differs_in_numbers_is_alike():
    mass = next(one for one in maps(False) if one.name == "mass")
    point = {"across": 0.005, "up": 20.0, "groups": mass.groups(BASE, 0.005, 20.0)}
    (row,) = jump_rows([point], [], 1e3)
    assert row["status"] == "refused" and "environment.mass_bar" in row["message"]
    soft, stiff = ({**BASE, "contact": {**BASE["contact"], "stiffness_N_m": k}} for k in (1.0, 2.0))
    assert alike(composed(soft)) == alike(composed(stiff))
    assert alike(composed(soft)) != alike(composed({**soft, "friction": {"name": "none"}}))


def test_coverage():
    assert coverage(np.array([1.0, 3.0]), np.array([1.0, 1.0])) == 0.5
    rows = with_truth([GOOD, {**GOOD, "x_bar": 5.1}], [{**GOOD, "x_bar": 5.05}], own=True)
    assert level_row("a", "b", rows)["x_covered"] == 1.0
    assert level_row("a", "b", [])["known"] == 0
    more = [{**row, "x_error_estimate_percent": 1.0 + k} for k, row in enumerate(rows)]
    assert overall({"a": more})["calibration_jumps"] == 2


def test_checks_need_something_to_check():
    assert not all_are([], "a", "b", lambda row: True).holds
    assert all_are([GOOD], "a", "b", lambda row: row["status"] == "ok").holds
    assert spread([1.0, 1.1]) == pytest.approx(100.0 * 0.1 / 1.05)
