"""``python run.py task=dataset``: what it leaves, continues, records, refuses and survives."""

import json
from pathlib import Path
from typing import Any

import pyarrow.parquet as pq
import pytest
from command_line import begun, interrupted, result_in
from records import only_run
from refusals import refused
from small_datasets import OVERRIDES

from snapjump.checks import ParameterError
from snapjump.dataset.options import SharedDataset
from snapjump.dataset.read import load_dataset
from snapjump.files.lock import FileLock
from snapjump.run.tasks.complete import whole

PLAN = ("plan=sobol", "plan.count=16", "dataset.shard_size=8")
KEYS: dict[str, Any] = {
    "path": None, "sensitivities": False, "outputs": [], "shard_size": 8, "part": 1,
    "parts": 1,
}  # fmt: skip


def results(folder: Path) -> list[dict[str, Any]]:
    """Results of all runs, in the order of their ends."""
    files = sorted(folder.glob("outputs/20*/*/result.json"), key=lambda f: f.stat().st_mtime_ns)
    return [json.loads(file.read_text()) for file in files]


def test_a_dataset_its_record_and_its_continuation(command, refusal, database, tmp_path):
    done = command(*OVERRIDES, *PLAN)
    folder, result = result_in(tmp_path)
    (path,) = tmp_path.glob("outputs/datasets/sobol-draft-*")
    dataset = load_dataset(path)
    assert result["status"] == "ok" and result["complete"]
    assert result["rows"] == result["rows_made"] == result["designs"] == 16
    assert result["dataset_sha256"] == dataset.sha256 and result["dataset_path"] == str(path)
    assert sum(result[f"rows_{status}"] for status in dataset.statuses) == 16
    assert result["jumps_per_second"] >= result["jumps_per_second_core"] > 0.0
    for word in (dataset.sha256, "16 now, 0 before", "jumps/s", "outputs/datasets/sobol-draft-"):
        assert word in done.stdout
    assert {"dataset.png", "status.png", "config.yaml"} <= {f.name for f in folder.iterdir()}
    check_record(tmp_path, dataset.sha256)

    shard = path / "shards" / "shard-00001.parquet"
    shard.write_bytes(shard.read_bytes()[:-1])
    again = command(*OVERRIDES, *PLAN, "tracking=off", "figures=false")
    assert again.stderr.splitlines()[-1].startswith("made again: shard-00001.parquet has ")
    assert "8 now, 8 before" in again.stdout and dataset.sha256 in again.stdout
    last = results(tmp_path)[-1]
    assert last["shards_damaged"] == 1 and last["dataset_sha256"] == dataset.sha256

    for change in ("plan.count=17", "accuracy=standard", "stepping.tolerance=2e-5"):
        line = refusal(*OVERRIDES, *PLAN, f"dataset.path={path}", "tracking=off", change)
        assert f"to go on with {path}" in line


def check_record(folder: Path, sha256: str) -> None:
    """The run has the dataset as its input, by the hash, and the numbers of the result."""
    run, given, files = only_run(folder)
    assert run.data.tags["dataset_sha256"] == sha256
    assert run.data.metrics["rows"] == 16.0 and run.data.params["plan.count"] == "16"
    assert given.dataset.digest == sha256[:36]
    assert json.loads(given.dataset.profile) == {"num_rows": 16, "dataset_sha256": sha256}
    assert [tag.value for tag in given.tags] == ["generated"]
    assert {"dataset.png", "status.png"} <= files


@pytest.mark.processes
def test_parts_of_a_sweep_share_a_folder(process, tmp_path):
    sweep = ("-m", *OVERRIDES, *PLAN, "figures=false", "tracking=off", "dataset.path=shared")
    process(
        *sweep, "dataset.parts=2", "dataset.part=1,2",
        "hydra/launcher=joblib", "hydra.launcher.n_jobs=2",
    )  # fmt: skip
    assert load_dataset(tmp_path / "shared").rows == 16


def test_a_folder_that_another_process_writes_to_is_refused(refusal, tmp_path):
    with FileLock(tmp_path / "d" / ".lock"):
        line = refusal(*OVERRIDES, *PLAN, "dataset.path=d", "tracking=off")
    assert "no other process" in line
    assert not [file for file in tmp_path.rglob("*") if file.is_file() and file.name != ".lock"]


@pytest.mark.processes
def test_ctrl_c_keeps_what_is_done_and_says_how_to_go_on(tmp_path):
    # Enough designs that it does not end by itself.
    many = ("plan=latin_hypercube", "plan.count=20000", "dataset.shard_size=16")
    where = ("dataset.path=d", "tracking=off")
    process = begun(tmp_path, *OVERRIDES, *many, *where, until="d/shards/_shard-00001.json")
    assert "the same command continues what is in d" in interrupted(process)
    (result,) = results(tmp_path)
    assert result["status"] == "interrupted"
    manifest = json.loads((tmp_path / "d" / "manifest.json").read_text())
    assert not manifest["complete"] and len(manifest["shards"]) >= 2
    assert pq.read_table(tmp_path / "d" / "shards" / "shard-00000.parquet").num_rows == 16
    assert not list((tmp_path / "d" / "shards").glob(".*"))


BAD_KEYS = (
    {"path": ""}, {"path": 3}, {"parts": 0}, {"parts": 10_001}, {"part": 0}, {"speed": 3},
    {"part": 3, "parts": 2},
)  # fmt: skip


@pytest.mark.parametrize("change", BAD_KEYS)
def test_bad_keys(change):
    with refused(f"dataset.{min(change)}"):
        whole(SharedDataset, {**KEYS, **change})


@pytest.mark.parametrize("key", KEYS)
def test_keys_that_were_left_out(key):
    with pytest.raises(ParameterError, match=f"dataset.{key}"):
        whole(SharedDataset, {other: v for other, v in KEYS.items() if other != key})
