"""A job that takes long is recorded while it is under way, and nothing twice when it has ended."""

from functools import cached_property
from pathlib import Path
from typing import Any

import pytest

from snapjump.files.json_file import read_json
from snapjump.files.result_folder import ResultFolder
from snapjump.run.tasks import live
from snapjump.run.tasks.live import SHARE, Live
from snapjump.tracking.base import Record, TrackingError
from snapjump.tracking.off import Off
from snapjump.tracking.parts.tracked import MARK, record_folder, write_curves

COMMAND = "python run.py task=train surrogate=mlp"


class Memory(Off):
    place = "memory"

    @cached_property
    def told(self) -> list[tuple[Any, ...]]:
        return []

    @cached_property
    def fails(self) -> list[str]:
        return []

    def open(self, record: Record, run_id: str | None) -> str:
        self.told.append(("open", record.name, run_id))
        return run_id or "one"

    def add(self, run_id: str, params: Any, curves: Any) -> None:
        if self.fails:
            raise TrackingError("gone")
        self.told.append(("add", run_id, {key: list(curve) for key, curve in curves.items()}))

    def write(self, run_id: str, record: Record) -> None:
        self.told.append(("write", run_id, dict(record.curves)))


@pytest.fixture(autouse=True)
def at_once(monkeypatch):
    monkeypatch.setattr(live, "EVERY_S", 0.0)


def job(path: Path) -> ResultFolder:
    folder = ResultFolder(path)
    folder.begin()
    folder.write_config({"task": {"name": "train"}, "sim": {"name": "jump"}})
    return folder


def test_steps_are_recorded_as_they_come_and_the_rest_at_the_end(tmp_path):
    store, folder = Memory(), job(tmp_path)
    under_way = Live(store, folder, COMMAND)
    rows = [{"epoch": k, "loss": 1.0 / k} for k in (1, 2, 3)]
    for row in rows[:2]:
        under_way.step(row)
    assert store.told == [
        ("open", "train surrogate=mlp", None),
        ("add", "one", {"loss": [(1, 1.0)]}),
        ("add", "one", {"loss": [(2, 0.5)]}),
    ]
    assert (read_json(tmp_path / MARK) or {})["sent"] == {"loss": 2}
    write_curves(folder, rows)
    folder.write_provenance({"finished_at": "2026-01-01T00:00:01+00:00", "command": COMMAND})
    folder.write_result({"status": "ok"})
    record_folder(store, folder)
    assert store.told[3:] == [
        ("open", "train surrogate=mlp", "one"),
        ("write", "one", {"loss": [(3, 1.0 / 3.0)]}),
    ]


def test_how_far_it_is_is_recorded_too(tmp_path):
    store, heard = Memory(), []
    progress = Live(store, job(tmp_path), COMMAND).watched(lambda *told: heard.append(told))
    progress(0.25, "a quarter")
    assert heard == [(0.25, "a quarter")] and store.told[-1][2] == {SHARE: [(0, 25.0)]}


def test_a_store_that_fails_is_left_alone(tmp_path):
    store = Memory()
    under_way = Live(store, job(tmp_path), COMMAND)
    store.fails.append("yes")
    under_way.step({"epoch": 1, "loss": 1.0})
    store.fails.clear()
    under_way.step({"epoch": 2, "loss": 1.0})
    assert [told[0] for told in store.told] == ["open"]


def test_without_a_store_there_is_nothing(tmp_path):
    Live(Off(), job(tmp_path), COMMAND).step({"epoch": 1, "loss": 1.0})
    assert not (tmp_path / MARK).exists()
