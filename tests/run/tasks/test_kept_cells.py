"""Cells of a sweep that is started again: kept where all that they are made of is as it was."""

import contextlib
import json
import os
import shutil
import time
from pathlib import Path

import pytest
from command_line import begun
from forward_models import about, network
from small_datasets import OVERRIDES, small, smooth_dataset

from snapjump.learning.checkpoint import write_checkpoint

pytestmark = pytest.mark.processes

OFF = ("tracking=off", "figures=false")
RBF = ("surrogate=rbf", "surrogate.neighbours=5", "seed=0,1")


def measured(folder: Path) -> list[float]:
    found = sorted(folder.glob("outputs/sweeps/*/*/result.json"))
    return [json.loads(file.read_text())["mae_bar"] for file in found]


def test_training_is_done_again_on_another_dataset(command, tmp_path):
    data = tmp_path / "data"
    sweep = ("-m", "task=train", *RBF, *OFF, f"dataset.path={data}")
    smooth_dataset(data, small(200, 200))
    command(*sweep)
    first = measured(tmp_path)
    assert command(*sweep).stdout.count("(kept)") == 2
    shutil.rmtree(data)
    smooth_dataset(data, small(150, 150))
    assert "(kept)" not in command(*sweep).stdout
    assert len(first) == 2 and not set(measured(tmp_path)) & set(first)


def test_an_inverse_design_is_done_again_with_another_model(command, process, tmp_path):
    model = tmp_path / "model.safetensors"
    sweep = ("-m", "task=export", f"checkpoint={model}", "seed=0,1", *OFF)
    for seed in (0, 1):
        write_checkpoint(model, network(seed=seed), about())
        assert "(kept)" not in command(*sweep).stdout
        assert command(*sweep).stdout.count("(kept)") == 2
    model.write_bytes(os.urandom(1000))
    done = command(*sweep, code=2)
    assert "(kept)" not in done.stdout and "2 bad_input" in done.stdout


def test_a_dataset_that_has_gone_is_made_again(command, tmp_path):
    data = tmp_path / "data"
    sweep = ("-m", *OVERRIDES, "plan=sobol", "plan.count=16", f"dataset.path={data}", *OFF)
    parts = ("dataset.parts=2", "dataset.part=1,2", "dataset.shard_size=4")
    command(*sweep, *parts)
    assert command(*sweep, *parts).stdout.count("(kept)") == 2
    (data / "shards" / "shard-00001.parquet").unlink()  # of the second part
    assert command(*sweep, *parts).stdout.count("(kept)") == 1
    shutil.rmtree(data)
    assert "(kept)" not in command(*sweep, *parts).stdout
    assert len(list(data.glob("shards/*.parquet"))) == 4


def test_cells_that_a_user_calls_otherwise_are_found(command, tmp_path):
    sweep = ("-m", "sim=cantilever", "sim.load_bar=1,2", "hydra.sweep.dir=s", *OFF)
    first = command(*sweep, "hydra.sweep.subdir=${hydra.job.num}")
    assert "2 cells: 2 ok" in first.stdout and "not_started" not in first.stdout
    again = command(*sweep, "hydra.sweep.subdir=${hydra.job.num}")
    assert again.stdout.count("(kept)") == 2
    assert {file.parent.name for file in (tmp_path / "s").glob("*/result.json")} == {"0", "1"}
    # Two in one folder would replace each other.
    shared = command(*sweep, "hydra.sweep.subdir=same", "hydra.sweep.dir=t", code=3)
    assert "hydra.sweep.subdir = 'same' is not allowed: one for each cell" in shared.stderr
    assert "1 ok, 1 not_started" in shared.stdout


def children_of(parent: int) -> list[int]:
    """The processes that a process has started."""
    found = []
    for stat in Path("/proc").glob("[0-9]*/stat"):
        with contextlib.suppress(OSError):
            if int(stat.read_text().rpartition(")")[2].split()[1]) == parent:
                found.append(int(stat.parent.name))
    return found


def is_running(process: int) -> bool:
    try:
        state = Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[0]
    except OSError:
        return False
    return state != "Z"


def test_workers_end_with_their_sweep(tmp_path):
    cells = "design.epsilon=0.1,0.12,0.14,0.16,0.18,0.2,0.22,0.24"
    sweep = ("-m", cells, "accuracy=reference", "hydra/launcher=joblib", *OFF)
    many = ("hydra.launcher.n_jobs=2", "hydra.launcher.pre_dispatch=8")
    process = begun(tmp_path, *sweep, *many, until="outputs/sweeps/*/*/config.yaml")
    workers = children_of(process.pid)
    process.kill()
    process.wait()
    deadline = time.monotonic() + 15.0
    while any(map(is_running, workers)) and time.monotonic() < deadline:
        time.sleep(0.1)
    assert workers and not any(map(is_running, workers))
    done = len(list(tmp_path.glob("outputs/sweeps/*/*/result.json")))
    assert done < 8
