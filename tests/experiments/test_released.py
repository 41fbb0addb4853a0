"""The study of the released program's data: its settings, its rows, its differences."""

import numpy as np
import pytest
from hydra_config import hydra_config

from experiments.compositions import changed, composed, groups_of
from experiments.released import data
from experiments.released.settings import WITHOUT, converged, released
from experiments.released.study import draw_comparison


def test_the_study_s_settings_are_those_of_the_experiment_s_file():
    config = hydra_config("+experiment=released")
    assert composed(groups_of(config)) == composed(released())


def test_every_quirk_changes_something_and_can_be_left_out():
    base = composed(released())
    for name, change in WITHOUT.items():
        assert composed(changed(released(), change)) != base, name
    assert composed(converged()).accuracy == "reference"


def test_rows_are_spread_over_the_file_and_its_ranges():
    everything, few = (data.read_rows(count).designs for count in (10_000, 40))
    assert (len(everything), len(few)) == (300, 40)
    assert (few[0], few[-1]) == (everything[0], everything[-1])
    assert (np.min(few, axis=0) <= [0.03, 0.12, 0.5, 0.2]).all()
    assert (np.max(few, axis=0) >= [0.17, 0.28, 1.8, 0.5]).all()
    assert data.ROWS.with_name("README.md").exists()


def test_differences_of_x_are_relative_to_a_tenth_of_y_where_it_is_small():
    ours = np.array([1.1, 0.2, np.nan]), np.array([10.2, 9.0, np.nan])
    x, y = data.differences(*ours, np.array([1.0, 0.1, 1.0]), np.full(3, 10.0))
    assert x[:2] == pytest.approx([10.0, 10.0])
    assert y[:2] == pytest.approx([2.0, -10.0])
    row = data.figures(x, y)
    assert row["failed"] == 1
    assert row["y_median_percent"] == pytest.approx(6.0)
    assert data.share_within(y, 5.0) == pytest.approx(100.0 / 3.0)
    quarters = data.by_quarter(np.array([1.0, 2.0, 3.0]), x, y, "mu")
    assert sum(q["rows"] for q in quarters) == 3


def test_the_figure_is_drawn(tmp_path):
    rng = np.random.default_rng(0)
    rows = [
        {
            "delta_alpha_rad": 0.1 * a, "epsilon": 0.1 + 0.2 * b, "mass_bar": 1.0 + c, "mu": 0.3,
            "x_bar": a, "y_bar": 10.0 * b, "x_released_bar": a + 0.1,
            "y_released_bar": 10.0 * b + 0.1, "x_difference_percent": a, "y_difference_percent": b,
        }
        for a, b, c in rng.uniform(size=(12, 3))
    ]  # fmt: skip
    draw_comparison(rows, tmp_path / "released.png")
    assert (tmp_path / "released.png").stat().st_size > 10_000
