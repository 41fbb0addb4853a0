"""The figures of a dataset: drawn from statistics alone, whatever became of the jumps."""

from pathlib import Path

import numpy as np
import pytest
from PIL import Image
from small_datasets import made_up, made_up_rows, small

from snapjump.dataset.folder import DatasetFolder
from snapjump.dataset.manifest import write_manifest
from snapjump.dataset.read import Dataset, open_dataset
from snapjump.dataset.shard import write_shard
from snapjump.dataset.statistics import gather
from snapjump.plots import palette
from snapjump.plots.dataset import draw_dataset, draw_status


def drawn(dataset: Dataset, path: Path) -> dict[str, np.ndarray]:
    statistics = gather(dataset)
    draw_dataset(statistics, "title", path / "dataset.png")
    draw_status(statistics, dataset.statuses, "title", path / "status.png")
    return {
        name: np.asarray(Image.open(path / f"{name}.png").convert("RGB"))
        for name in ("dataset", "status")
    }


def has(picture: np.ndarray, colour: str) -> bool:
    """Whether enough of a colour is there for a bar or a line."""
    return int((picture == palette.rgb(colour)).all(axis=2).sum()) > 200


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


@pytest.mark.parametrize("count", [1, 7])
def test_any_number_of_inputs(tmp_path, count):
    names = ("length_m", "width_m", "thickness_m", "density_kg_m3", "frame_height_m")
    paths = ["design.epsilon", "environment.mu", *(f"robot.{name}" for name in names)]
    plan = {"name": "sobol", "count": 64, "inputs": dict.fromkeys(paths[:count])}
    made_up(tmp_path, small(shard_size=64, plan=plan))
    pictures = drawn(open_dataset(tmp_path), tmp_path)
    assert has(pictures["dataset"], palette.BEAM) and has(pictures["status"], palette.CENTRE)


def test_a_dataset_of_nothing_but_failures(tmp_path):
    specification = small(16, 16)
    folder = DatasetFolder(tmp_path)
    folder.open(specification)
    rows = dict(made_up_rows(specification, 0))
    rows["status"] = np.array(["step_underflow"] * 16, dtype=object)
    rows["x_bar"] = rows["y_bar"] = np.full(16, np.nan)
    write_shard(folder, specification, 0, rows)
    write_manifest(folder, specification)
    pictures = drawn(open_dataset(tmp_path), tmp_path)
    assert has(pictures["status"], palette.FORCE)
    assert not has(pictures["status"], palette.CENTRE)
    assert not has(pictures["dataset"], palette.BEAM)
