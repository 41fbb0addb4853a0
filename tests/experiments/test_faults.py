"""Kills at random moments, on a dataset of a few seconds."""

import pytest
from small_datasets import OVERRIDES

from experiments.faults import faults

SMALL = ("plan=sobol", "plan.count=192", "dataset.shard_size=8", *OVERRIDES)


@pytest.mark.processes
def test_killed_runs_end_in_the_same_dataset(tmp_path):
    found = faults(tmp_path, 3, SMALL, seed=1)
    assert found["manifests_identical"]
    assert found["kills"] == 3 and found["kills_before_the_end"] >= 2
    assert found["shards_not_whole_after_kills"] == 0
    assert found["half_written_files_left"] == 0
    assert found["designs"] == 192 and found["shards"] == 24
