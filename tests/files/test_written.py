"""Files are whole or not at all, hold no NaN, and tell where they come from."""

import json
import math
import os
import stat
from pathlib import Path

import numpy as np
import pytest

from snapjump.files.atomic import atomic_file, write_text
from snapjump.files.json_file import finite, read_json, write_json
from snapjump.files.provenance import now, provenance


def test_a_file_appears_whole(tmp_path):
    write_text(tmp_path / "a.txt", "one\n")
    assert (tmp_path / "a.txt").read_text() == "one\n"
    assert [path.name for path in tmp_path.iterdir()] == ["a.txt"]


@pytest.mark.parametrize("stop", [RuntimeError, KeyboardInterrupt])
def test_an_interrupted_write_leaves_the_old_file_and_nothing_else(tmp_path, stop):
    write_text(tmp_path / "a.txt", "old")
    with pytest.raises(stop), atomic_file(tmp_path / "a.txt") as file:
        file.write("half of the ne")
        raise stop
    assert (tmp_path / "a.txt").read_text() == "old"
    assert [path.name for path in tmp_path.iterdir()] == ["a.txt"]


def test_a_file_is_as_readable_as_any_other(tmp_path):
    (tmp_path / "plain").write_text("")
    write_text(tmp_path / "a.txt", "")
    assert (tmp_path / "a.txt").stat().st_mode == (tmp_path / "plain").stat().st_mode


def test_contents_are_on_the_disk_before_the_name_and_the_name_before_anything_else(
    tmp_path, monkeypatch
):
    done: list[str] = []
    fsync, replace = os.fsync, os.replace

    def flushed(handle: int) -> None:
        done.append("folder" if stat.S_ISDIR(os.fstat(handle).st_mode) else "file")
        fsync(handle)

    def renamed(source: str, target: Path) -> None:
        done.append("name")
        replace(source, target)

    monkeypatch.setattr(os, "fsync", flushed)
    monkeypatch.setattr(os, "replace", renamed)
    write_text(tmp_path / "a.txt", "one\n")
    assert done == ["file", "name", "folder"]


def test_nan_becomes_null_and_is_named(tmp_path):
    values = {"a": math.nan, "b": {"c": [1.0, -math.inf]}, "d": np.float64(math.nan), "e": 2}
    assert write_json(tmp_path / "r.json", values) == ["a", "b.c.1", "d"]
    text = (tmp_path / "r.json").read_text()
    assert "NaN" not in text and "Infinity" not in text
    assert json.loads(text) == {"a": None, "b": {"c": [1.0, None]}, "d": None, "e": 2}


def test_numpy_scalars_become_plain_numbers():
    clean, bad = finite({"a": np.float64(0.5), "b": np.int64(3), "c": np.bool_(True)})
    assert clean == {"a": 0.5, "b": 3, "c": True} and not bad
    assert [type(value) for value in clean.values()] == [float, int, bool]


def test_what_cannot_be_read_is_none(tmp_path):
    (tmp_path / "half.json").write_text('{"status": "o')
    assert read_json(tmp_path / "half.json") is None
    assert read_json(tmp_path / "missing.json") is None


def test_a_result_can_be_traced():
    origin = provenance("python run.py seed=3", seed=3, started_at=now())
    assert json.loads(json.dumps(origin)) == origin
    assert origin["command"] == "python run.py seed=3"
    assert origin["seed"] == 3
    assert origin["started_at"] <= origin["finished_at"]
    assert len(origin["source_sha256"]) == 64
    assert {"git_revision", "git_dirty"} <= set(origin)
    assert {"python", "numpy", "numba", "mlflow", "hydra-core"} <= set(origin["versions"])
    assert {"system", "processor", "cores"} <= set(origin["machine"])
