"""A dataset that follows a smooth law, and the jumps of it."""

from collections.abc import Callable
from typing import Any

import pytest
from small_datasets import small, smooth_dataset

from snapjump.dataset.read import Dataset
from snapjump.learning.data import JumpData
from snapjump.learning.training import Training

QUICK = {"epochs": 6, "patience": 6, "batch_first": 16, "batch_last": 64}


@pytest.fixture(scope="session")
def smooth_jumps(tmp_path_factory) -> Dataset:
    """400 jumps, all ok, without derivatives."""
    return smooth_dataset(tmp_path_factory.mktemp("smooth"), small(400, 200))


@pytest.fixture
def jump_set(smooth_jumps) -> Callable[..., JumpData]:
    """The jumps of that dataset, split by a training with some values changed."""

    def of(seed: int = 0, **changes: Any) -> JumpData:
        return JumpData(smooth_jumps, Training(**{**QUICK, **changes}), seed)

    return of
