"""Files are whole or not at all, hold no NaN, are locked and tell where they come from."""

import json
import math
import os
import stat
import subprocess
import sys
import threading
import time
from pathlib import Path

import numpy as np
import pytest

from snapjump.files.atomic import atomic_file, write_text
from snapjump.files.json_file import finite, read_json, write_json
from snapjump.files.lock import FileLock
from snapjump.files.provenance import now, provenance
from snapjump.files.result_folder import ResultFolder

CONFIG = {"design": {"epsilon": 0.2}, "tracking": {"name": "off"}, "step_s": 1e-5}
DONE = frozenset({"ok"})


def finished_folder(path: Path) -> ResultFolder:
    return finished_folder_of(ResultFolder(path))


def finished_folder_of(folder: ResultFolder) -> ResultFolder:
    folder.write_config(CONFIG)
    folder.write_provenance({"source_sha256": "abc"})
    folder.write_result({"status": "ok"})
    return folder


def test_a_configuration_comes_back_as_it_was(tmp_path):
    assert finished_folder(tmp_path).config() == CONFIG


def test_finished_means_same_physics_same_code_and_a_good_end(tmp_path):
    folder = finished_folder(tmp_path)
    assert folder.holds(CONFIG, "abc", {}, DONE)
    assert folder.holds({**CONFIG, "tracking": {"name": "sqlite"}}, "abc", {}, DONE)
    assert not folder.holds({**CONFIG, "design": {"epsilon": 0.3}}, "abc", {}, DONE)
    assert not folder.holds(CONFIG, "other code", {}, DONE)
    folder.write_result({"status": "diverged"})
    assert not folder.holds(CONFIG, "abc", {}, DONE)
    folder.begin()
    assert not folder.holds(CONFIG, "abc", {}, DONE)


def test_finished_means_that_what_is_outside_is_as_it_was(tmp_path):
    folder = ResultFolder(tmp_path)
    folder.write_config(CONFIG)
    folder.write_provenance({"source_sha256": "abc", "outside": {"checkpoint": "1"}})
    folder.write_result({"status": "ok"})
    assert folder.holds(CONFIG, "abc", {"checkpoint": "1"}, DONE)
    assert not folder.holds(CONFIG, "abc", {"checkpoint": "2"}, DONE)
    assert not folder.holds(CONFIG, "abc", {}, DONE)


def test_finished_means_that_every_file_is_there(tmp_path):
    folder = ResultFolder(tmp_path)
    folder.begin()
    write_text(tmp_path / "forward_model.safetensors", "")
    finished_folder_of(folder)
    assert folder.holds(CONFIG, "abc", {}, DONE)
    (tmp_path / "forward_model.safetensors").unlink()
    assert not folder.holds(CONFIG, "abc", {}, DONE)


def test_only_what_a_job_wrote_is_its_own(tmp_path):
    (tmp_path / "secret.txt").write_text("not ours")
    (tmp_path / "replaced.png").write_text("not ours yet")
    first = ResultFolder(tmp_path)
    first.begin()
    for name in ("jump.png", "replaced.png"):
        write_text(tmp_path / name, "the first's")
    finished_folder_of(first)
    own = {"config.yaml", "jump.png", "provenance.json", "replaced.png", "result.json"}
    for folder in (first, ResultFolder(tmp_path)):
        assert {file.name for file in folder.files()} == own
    second = ResultFolder(tmp_path)
    second.begin()
    finished_folder_of(second)
    for folder in (second, ResultFolder(tmp_path)):
        assert {file.name for file in folder.files()} == own - {"jump.png", "replaced.png"}
    left = {file.name for file in tmp_path.iterdir()}
    assert left == {"config.yaml", "provenance.json", "result.json", "secret.txt"}


def test_an_edited_list_leads_nowhere_else(tmp_path):
    (tmp_path / "run").mkdir()
    (tmp_path / "outside.txt").write_text("")
    write_json(tmp_path / "run" / "provenance.json", {"files": ["../outside.txt", 3, None]})
    ResultFolder(tmp_path / "run").begin()
    assert (tmp_path / "outside.txt").exists()


def test_a_job_that_was_refused_leaves_the_files_of_others(tmp_path):
    (tmp_path / "notes.txt").write_text("")
    folder = ResultFolder(tmp_path)
    folder.begin()
    folder.write_config(CONFIG)
    folder.withdraw()
    assert [file.name for file in tmp_path.iterdir()] == ["notes.txt"]


def test_arrays_that_are_not_finite_reach_no_file(tmp_path):
    arrays = {"x": np.arange(3.0), "y": np.array([1.0, np.nan]), "n": np.arange(2)}
    assert ResultFolder(tmp_path).write_arrays("trajectory", arrays) == ["y"]
    with np.load(tmp_path / "trajectory.npz") as file:
        assert sorted(file) == ["n", "x"]
        assert np.array_equal(file["x"], arrays["x"])


def test_figures_appear_together_or_not_at_all(tmp_path, capsys):
    def draw_half(folder: Path) -> None:
        (folder / "a.png").write_text("a")
        raise RuntimeError("no ink")

    folder = ResultFolder(tmp_path)
    folder.begin()
    assert not folder.write_figures(draw_half)
    assert capsys.readouterr().err == "figures not drawn: RuntimeError: no ink\n"
    assert not list(tmp_path.iterdir())
    assert folder.write_figures(lambda folder: (folder / "b.png").write_text("b"))
    assert [path.name for path in folder.files()] == ["b.png"]


def test_a_result_of_before_is_read_under_the_names_of_today(tmp_path):
    folder = ResultFolder(tmp_path)
    folder.write_config({"robot": {"length_m": 0.02}})
    folder.write_result({"status": "ok", "mount_height_m": 0.0015})
    assert folder.result() == {"status": "ok", "mount_height_bar": pytest.approx(0.075)}


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


HOLD = """
import sys
from pathlib import Path
from snapjump.files.lock import FileLock
lock = FileLock(Path(sys.argv[1]))
lock.acquire()
print("held", flush=True)
sys.stdin.read()
"""


def test_a_lock_excludes_other_processes_and_ends_with_its_own(tmp_path):
    path = tmp_path / "x.lock"
    holder = subprocess.Popen(
        [sys.executable, "-c", HOLD, str(path)], stdin=subprocess.PIPE, stdout=subprocess.PIPE
    )
    assert holder.stdout is not None
    assert holder.stdout.readline() == b"held\n"
    assert not FileLock(path).acquire(wait=False)
    holder.kill()
    holder.communicate()
    lock = FileLock(path)
    assert lock.acquire(wait=False)
    lock.release()


def test_a_lock_that_was_removed_is_another(tmp_path):
    path = tmp_path / "x.lock"
    first, waiting = FileLock(path), FileLock(path)
    first.acquire()
    waits = threading.Thread(target=waiting.acquire)
    waits.start()
    time.sleep(0.1)  # until it waits for the file that is there now
    first.remove()
    waits.join()
    assert path.exists() and not FileLock(path).acquire(wait=False)
    waiting.remove()
    assert not path.exists()


def test_a_shared_lock_is_shared_with_others_that_share_it(tmp_path):
    path = tmp_path / "lock"
    first, second = FileLock(path, shared=True), FileLock(path, shared=True)
    assert first.acquire(wait=False) and second.acquire(wait=False)
    alone = FileLock(path)
    assert not alone.acquire(wait=False)
    first.release()
    assert not alone.acquire(wait=False)
    second.release()
    assert alone.acquire(wait=False)
    assert not first.acquire(wait=False)
    alone.release()


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
