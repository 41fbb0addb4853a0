"""The figures of a dataset: drawn from statistics alone, whatever became of the jumps."""

from pathlib import Path

import numpy as np
import pytest
from pictures import count, picture
from small_datasets import made_up, small, smooth_dataset

from snapjump.dataset.read import Dataset, open_dataset
from snapjump.dataset.statistics import gather
from snapjump.show.plots import palette
from snapjump.show.plots.dataset import draw_dataset, draw_status


def drawn(dataset: Dataset, path: Path) -> dict[str, np.ndarray]:
    statistics = gather(dataset)
    draw_dataset(statistics, "title", path / "dataset.png")
    draw_status(statistics, dataset.statuses, "title", path / "status.png")
    return {name: picture(path / f"{name}.png") for name in ("dataset", "status")}


def has(pixels: np.ndarray, colour: str) -> bool:
    """Whether enough of a colour is there for a bar or a line."""
    return count(pixels, colour) > 200


@pytest.mark.parametrize("plan", ["grid", "latin_hypercube"])
def test_both_pictures(tmp_path, plan):
    options = {"grid": {"points": 4}, "latin_hypercube": {"count": 300}}[plan]
    specification = small(shard_size=64, plan={"name": plan, **options})
    made_up(tmp_path, specification)
    pictures = drawn(open_dataset(tmp_path), tmp_path)
    assert has(pictures["dataset"], palette.BEAM) and has(pictures["dataset"], palette.FORCE)
    # Failed, doubtful, and as promised.
    for colour in (palette.FORCE, palette.CLAMP, palette.CENTRE):
        assert has(pictures["status"], colour)


@pytest.mark.parametrize("inputs", [1, 7])
def test_any_number_of_inputs(tmp_path, inputs):
    names = ("length_m", "width_m", "thickness_m", "density_kg_m3", "frame_height_m")
    paths = ["design.epsilon", "environment.mu", *(f"robot.{name}" for name in names)]
    plan = {"name": "sobol", "count": 64, "inputs": dict.fromkeys(paths[:inputs])}
    made_up(tmp_path, small(shard_size=64, plan=plan))
    pictures = drawn(open_dataset(tmp_path), tmp_path)
    assert has(pictures["dataset"], palette.BEAM) and has(pictures["status"], palette.CENTRE)


def test_a_dataset_of_nothing_but_failures(tmp_path):
    nothing = {"status": "step_underflow", "x_bar": np.nan, "y_bar": np.nan}
    smooth_dataset(tmp_path, small(16, 16), **nothing)
    pictures = drawn(open_dataset(tmp_path), tmp_path)
    assert has(pictures["status"], palette.FORCE)
    assert not has(pictures["status"], palette.CENTRE)
    assert not has(pictures["dataset"], palette.BEAM)
