"""The figures of a dataset and of a training, whatever became of the jumps."""

from pathlib import Path

import numpy as np
import pytest
from pictures import has, picture
from small_datasets import made_up_dataset, small, smooth_dataset

from snapjump.dataset.read import Dataset
from snapjump.dataset.statistics import gather
from snapjump.show.plots import palette
from snapjump.show.plots.dataset import draw_dataset, draw_status
from snapjump.show.plots.training import draw_training


def drawn_dataset(dataset: Dataset, path: Path) -> dict[str, np.ndarray]:
    statistics = gather(dataset)
    draw_dataset(statistics, "title", path / "dataset.png")
    draw_status(statistics, dataset.statuses, "title", path / "status.png")
    return {name: picture(path / f"{name}.png") for name in ("dataset", "status")}


@pytest.mark.parametrize("plan", ["grid", "latin_hypercube"])
def test_both_pictures(tmp_path, plan):
    options = {"grid": {"points": 4}, "latin_hypercube": {"count": 300}}[plan]
    specification = small(shard_size=64, plan={"name": plan, **options})
    pictures = drawn_dataset(made_up_dataset(tmp_path, specification), tmp_path)
    assert has(pictures["dataset"], palette.BEAM) and has(pictures["dataset"], palette.FORCE)
    # Failed, doubtful, and as promised.
    for colour in (palette.FORCE, palette.CLAMP, palette.CENTRE):
        assert has(pictures["status"], colour)


@pytest.mark.parametrize("inputs", [1, 7])
def test_any_number_of_inputs(tmp_path, inputs):
    names = ("length_m", "width_m", "thickness_m", "density_kg_m3", "frame_height_m")
    paths = ["design.epsilon", "environment.mu", *(f"robot.{name}" for name in names)]
    plan = {"name": "sobol", "count": 64, "inputs": dict.fromkeys(paths[:inputs])}
    pictures = drawn_dataset(made_up_dataset(tmp_path, small(shard_size=64, plan=plan)), tmp_path)
    assert has(pictures["dataset"], palette.BEAM) and has(pictures["status"], palette.CENTRE)


def test_a_dataset_of_nothing_but_failures(tmp_path):
    nothing = {"status": "step_underflow", "x_bar": np.nan, "y_bar": np.nan}
    pictures = drawn_dataset(smooth_dataset(tmp_path, small(16, 16), **nothing), tmp_path)
    assert has(pictures["status"], palette.FORCE)
    assert not has(pictures["status"], palette.CENTRE)
    assert not has(pictures["dataset"], palette.BEAM)


CURVES = [
    {
        "epoch": n, "train_loss": 1.0 / n, "validation_mae_bar": 2.0 / n, "learning_rate": 1e-3,
        "batch_size": 64,
    }
    for n in range(1, 20)
]  # fmt: skip


def drawn_training(path: Path, curves: list, designs: np.ndarray, error: float) -> Path:
    """The figure of a model that is so wrong."""
    apexes, errors = np.random.default_rng(1).normal(size=(2, len(designs), 2))
    file = path / "training.png"
    draw_training(curves, ["a", "b", "c", "d"], designs, apexes, error * errors, "title", file)
    return file


@pytest.mark.parametrize("curves", [CURVES, []])
@pytest.mark.parametrize("points", [5, 0])
def test_it_is_drawn(tmp_path, curves, points):
    designs = np.random.default_rng(0).random((500, 4))
    if points:
        designs = np.round(designs * (points - 1)) / (points - 1)
    pixels = picture(drawn_training(tmp_path, curves, designs, 0.05))
    assert has(pixels, palette.BEAM, 500) and has(pixels, palette.FORCE, 500)
    assert has(pixels, palette.CENTRE) == bool(curves)


def test_a_model_without_errors_is_drawn(tmp_path):
    designs = np.random.default_rng(0).random((50, 4))
    assert drawn_training(tmp_path, [], designs, 0.0).stat().st_size > 10_000
