"""Records nested below a job's own, made from the file that the job left."""

import dataclasses
import math
from functools import cached_property
from pathlib import Path

from snapjump.files.result_folder import ResultFolder
from snapjump.tracking.base import Record
from snapjump.tracking.off import Off
from snapjump.tracking.parts.tracked import read_curves, record_folder, write_children, write_curves


class Memory(Off):
    place = "memory"

    @cached_property
    def records(self) -> dict[str, Record]:
        return {}

    def open(self, record: Record, run_id: str | None) -> str:
        run_id = run_id or f"run {len(self.records)}"
        self.records[run_id] = record
        return run_id


def job(path: Path) -> ResultFolder:
    folder = ResultFolder(path)
    folder.begin()
    folder.write_config({"seed": 0})
    folder.write_result({"status": "ok"})
    child = {
        "name": "a cell", "status": "refused", "message": "why",
        "started_at": "2026-01-01T00:00:00+00:00", "finished_at": "2026-01-01T00:00:01+00:00",
        "params": {"integrator": {"name": "sdirk2"}}, "metrics": {"error": 0.5},
    }  # fmt: skip
    write_children(folder, [child, {**child, "name": "another", "status": "ok"}])
    return folder


def test_children_are_recorded_below_their_job_and_once(tmp_path):
    store, folder = Memory(), job(tmp_path)
    for time in ("1", "1", "2"):
        folder.write_provenance({"finished_at": f"2026-01-01T00:00:0{time}+00:00"})
        record_folder(store, folder, "study", None)
    parent, first, second = store.records.values()
    assert parent.parent_id is None and "children.json" not in {f.name for f in parent.files}
    assert {first.parent_id, second.parent_id} == {"run 0"}
    assert (first.state, second.state) == ("FAILED", "FINISHED")
    assert first.params == {"integrator.name": "sdirk2"} and first.metrics == {"error": 0.5}
    assert dataclasses.asdict(first)["ended_ms"] - first.started_ms == 1000


def test_without_tracking_nothing_is_recorded(tmp_path):
    assert record_folder(Off(), job(tmp_path), "study", None) == ""
    assert not (tmp_path / "tracking.json").exists()


def test_curves_are_recorded_against_their_steps(tmp_path):
    store, folder = Memory(), job(tmp_path)
    rows = [{"epoch": 1, "loss": 0.5, "rate": 1e-3}, {"epoch": 2, "loss": math.nan, "rate": 1e-4}]
    write_curves(folder, rows)
    record_folder(store, folder, "training", None)
    record = store.records["run 0"]
    assert record.curves == {"loss": [(1, 0.5)], "rate": [(1, 1e-3), (2, 1e-4)]}
    # They are a result as well.
    assert "curves.csv" in {file.name for file in record.files}
    assert "nan" not in (tmp_path / "curves.csv").read_text()


def test_without_curves_there_is_no_file(tmp_path):
    folder = job(tmp_path)
    write_curves(folder, [])
    assert not (tmp_path / "curves.csv").exists() and read_curves(folder) == {}
