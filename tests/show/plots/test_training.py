"""The figure of a training: with and without epochs, of a grid and of random designs."""

from pathlib import Path

import numpy as np
import pytest
from pictures import count, picture

from snapjump.show.plots import palette
from snapjump.show.plots.training import draw_training

CURVES = [
    {
        "epoch": n, "train_loss": 1.0 / n, "validation_mae_bar": 2.0 / n, "learning_rate": 1e-3,
        "batch_size": 64,
    }
    for n in range(1, 20)
]  # fmt: skip


def drawn(path: Path, curves: list, designs: np.ndarray, error: float) -> Path:
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
    pixels = picture(drawn(tmp_path, curves, designs, 0.05))
    assert count(pixels, palette.BEAM) > 500 and count(pixels, palette.FORCE) > 500
    assert (count(pixels, palette.CENTRE) > 200) == bool(curves)


def test_a_model_without_errors_is_drawn(tmp_path):
    designs = np.random.default_rng(0).random((50, 4))
    assert drawn(tmp_path, [], designs, 0.0).stat().st_size > 10_000
