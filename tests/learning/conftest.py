"""A dataset that follows a smooth law, and the jumps of it."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from small_datasets import small, smooth_dataset

from snapjump.dataset.read import Dataset, open_dataset
from snapjump.learning.data import JumpData
from snapjump.learning.training import Training

QUICK = {"epochs": 6, "patience": 6, "batch_first": 16, "batch_last": 64}


@pytest.fixture(scope="session")
def smooth(tmp_path_factory) -> Dataset:
    """400 jumps, all ok, without derivatives."""
    path: Path = tmp_path_factory.mktemp("smooth")
    smooth_dataset(path, small(400, 200))
    return open_dataset(path)


@pytest.fixture
def data(smooth) -> Callable[..., JumpData]:
    """The jumps of that dataset, split by a training with some values changed."""

    def of(seed: int = 0, **changes: Any) -> JumpData:
        return JumpData(smooth, Training(**{**QUICK, **changes}), seed)

    return of
