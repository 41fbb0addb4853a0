"""The study of forward models on a small smooth dataset, its floor, and where errors sit."""

from typing import Any

import numpy as np
import pytest
from cells import GIVEN, run_study
from made_up_maps import RANGES
from refusals import refused
from small_datasets import CONFIG, WIDE_STICK, small, smooth_dataset

from experiments.surrogates import study as module
from experiments.surrogates.compute import BINS, by_input, concentration
from experiments.surrogates.floor import INTERVALS, floor_rows, left_out
from experiments.surrogates.study import CompareSurrogates, training_of
from snapjump.learning.training import Training
from snapjump.plan.parts.axes import default_axes
from snapjump.simulation import build


@pytest.fixture
def datasets(tmp_path) -> dict[str, Any]:
    """Folders of one smooth law, as the study's keys."""
    smooth_dataset(tmp_path / "standard", small(300, 300))
    smooth_dataset(tmp_path / "slopes", small(160, 160, True, friction=WIDE_STICK))
    folders = {name: str(tmp_path / name) for name in ("standard", "slopes")}
    return {**folders, "paper": None}


def configured(**task: Any) -> dict[str, Any]:
    return {**GIVEN, "task": {"name": "compare_surrogates", **task}}


def test_the_study_trains_judges_and_concludes(datasets, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(module, "LONGEST", 3)
    monkeypatch.setattr(module, "SIZES", ((100,), ()))
    monkeypatch.setattr(module, "FLOOR_CELLS", (1, 1))
    monkeypatch.setattr("experiments.surrogates.floor.JUMPS", 64)
    study = CompareSurrogates()
    study.prepare(configured(**datasets))
    names = {cell.name for cell in study.cells}
    assert names >= {f"resnet, {count} jumps" for count in (100, 240)}
    assert "ensemble, 100 jumps" not in names
    assert "gradient_mlp, 128 jumps, slopes left out" in names
    outcome, folder = run_study(study, configured(**datasets), tmp_path / "run")
    assert outcome.status == "ok", (folder.path / "failures.txt").read_text()
    # A cubic law is what an interpolation of 240 points knows best.
    found = outcome.summary
    assert found["mae_bar_rbf_240_jumps"] < found["mae_bar_rbf_100_jumps"]
    assert found["mae_bar_rbf_240_jumps"] < 0.5 * found["mae_bar_mlp_240_jumps"]
    for picture in ("curves.png", "places.png"):
        assert (folder.path / picture).stat().st_size > 10_000


def test_a_cubic_leaves_nothing_of_a_cubic_and_all_of_noise():
    rng = np.random.default_rng(0)
    points = rng.uniform(-1.0, 1.0, (128, 4))
    a, b, c, d = points.T
    cubic = np.stack([1.0 + a * b * c - d**3, a**2 * d - 0.5 * b], axis=1)
    assert np.abs(left_out(points, cubic)).max() < 1e-10
    noise = rng.standard_normal((128, 2))
    # Left out in turn, a fit with 35 coefficients to 128 points errs by this in variance.
    variance = 1.0 / (1.0 - 35.0 / 128.0)
    assert (left_out(points, noise) ** 2).mean() == pytest.approx(variance, rel=0.2)


def test_the_floor_is_measured_in_cells_of_the_grid():
    rows = floor_rows(build(CONFIG), RANGES, 2, 0)
    low, high = np.array(RANGES).T
    corners = np.array([[row[f"{axis.column}_low"] for axis in default_axes()] for row in rows])
    places = (corners - low) / (high - low) * INTERVALS
    assert places == pytest.approx(np.round(places), abs=1e-9)
    assert all(row["jumps"] > 100 and 0.0 < row["x_bar"] < 5.0 for row in rows)


def test_errors_are_where_they_are():
    rng = np.random.default_rng(0)
    low, high = np.array(RANGES).T
    designs = low + (high - low) * rng.random((2000, 4))
    errors = np.where(designs[:, 3:] > 0.5, [0.2, -0.1], [0.01, 0.01])
    rows = by_input(designs, errors, default_axes())
    assert len(rows) == 4 * BINS
    worst = max(rows, key=lambda row: row["mae_x_bar"])
    assert (worst["input"], worst["from"]) == ("mu", pytest.approx(0.5))
    assert worst["mae_y_bar"] == pytest.approx(0.1)
    assert sum(row["designs"] for row in rows if row["input"] == "mu") == 2000


def test_a_concentrated_error_is_said_to_be_one():
    errors = np.full((1000, 2), 0.001)
    errors[:10] = 1.0
    shares = concentration(errors)
    assert shares["share_of_worst_1_percent"] == pytest.approx(10.0 / 10.99)
    assert concentration(np.ones((1000, 2)))["share_of_worst_10_percent"] == pytest.approx(0.1)


def test_fewer_jumps_are_given_more_epochs_of_smaller_batches():
    standard = Training()
    assert training_of(None, 40_500) == standard
    quarter = training_of(10_125, 40_500)
    assert (quarter.epochs, quarter.batch_first) == (2 * standard.epochs, standard.batch_first // 2)
    few = training_of(500, 40_500)
    assert (few.epochs, few.batch_first) == (module.LONGEST, module.SMALLEST_BATCH)
    assert training_of(None, 2000).epochs == training_of(2000, 40_500).epochs


BAD_FOLDERS = (
    ("standard", None), ("standard", "nowhere"), ("paper", "nowhere"), ("slopes", 3),
    ("paper", "slopes"), ("slopes", "standard"),
)  # fmt: skip


@pytest.mark.parametrize(("key", "folder"), BAD_FOLDERS)
def test_bad_input_is_named(datasets, key, folder):
    named = {key: datasets.get(folder, folder)}
    with refused(f"task.{key}"):
        CompareSurrogates().prepare(configured(**{**datasets, **named}))
