"""The figure of a training: with and without epochs, of a grid and of random designs."""

import numpy as np
import pytest
from PIL import Image

from snapjump.plots import palette
from snapjump.plots.training import draw_training

CURVES = [
    {
        "epoch": n, "train_loss": 1.0 / n, "validation_mae_bar": 2.0 / n, "learning_rate": 1e-3,
        "batch_size": 64,
    }
    for n in range(1, 20)
]  # fmt: skip


def shares(picture: np.ndarray, colour: str) -> int:
    return int((picture == palette.rgb(colour)).all(axis=2).sum())


@pytest.mark.parametrize("curves", [CURVES, []])
@pytest.mark.parametrize("points", [5, 0])
def test_it_is_drawn(tmp_path, curves, points):
    random = np.random.default_rng(0)
    designs = random.random((500, 4))
    if points:
        designs = np.round(designs * (points - 1)) / (points - 1)
    apexes = random.normal(size=(500, 2))
    errors = 0.05 * random.normal(size=(500, 2))
    draw_training(
        curves, ["a", "b", "c", "d"], designs, apexes, errors, "title", tmp_path / "training.png"
    )
    picture = np.asarray(Image.open(tmp_path / "training.png").convert("RGB"))
    assert shares(picture, palette.BEAM) > 500 and shares(picture, palette.FORCE) > 500
    assert (shares(picture, palette.CENTRE) > 200) == bool(curves)


def test_a_model_without_errors_is_drawn(tmp_path):
    random = np.random.default_rng(0)
    designs, apexes = random.random((50, 4)), random.normal(size=(50, 2))
    draw_training(
        [],
        ["a", "b", "c", "d"],
        designs,
        apexes,
        np.zeros((50, 2)),
        "title",
        tmp_path / "training.png",
    )
    assert (tmp_path / "training.png").stat().st_size > 10_000
