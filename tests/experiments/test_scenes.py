"""Savings and changes of made-up comparisons."""

import pytest
from cells import done

from experiments.scenes.jumps import compared
from experiments.scenes.study import finding, saving


def jump(x: float, y: float = 10.0, iterations: float = 100.0) -> dict:
    return {"status": "ok", "x_bar": x, "y_bar": y, "newton_iterations": iterations}


def test_a_saving_compares_with_everything_that_is_left_out():
    rows = compared([jump(2.0), jump(4.0)], [jump(2.02), jump(4.0)], 4.0, 1.0)
    row = saving("start", done("start", rows))
    assert row["saved_percent"] == pytest.approx(75.0)
    assert row["full_ms"] == pytest.approx(2000.0)
    assert row["x_change_max_percent"] == pytest.approx(1.0)
    assert row["y_change_max_percent"] == 0.0 and row["designs"] == 2
    assert "75 % of the time saved" in finding(row)


def test_a_member_that_is_not_there_is_said():
    row = saving("frame", done("frame", [], "refused", "frame = 'elastic' is not allowed"))
    assert "saved_percent" not in row
    assert "not compared (refused: frame = 'elastic'" in finding(row)
