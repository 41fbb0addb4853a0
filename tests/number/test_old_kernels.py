"""Old folders of kernels are removed, and nothing else beside them."""

import os
import subprocess
import sys
import time

from snapjump.number import compile_cache
from snapjump.number.compile_cache import cache_folder, use_cache_folder
from snapjump.number.old_kernels import OLD_S, remove_old, use

OLD, YOUNG = (f"kernels-{k:016x}" for k in (1, 2))


def aged(folder, seconds):
    (folder / "contact").mkdir(parents=True, exist_ok=True)
    (folder / "contact" / "kernel.nbc").write_text("")
    then = time.time() - seconds
    os.utime(folder, (then, then))
    return folder


def test_only_old_folders_of_kernels_go(tmp_path):
    kept = {YOUNG, "kernels-0", "kernels-" + "F" * 16, OLD + "-mine", "data", "kernels-" + "b" * 16}
    for name in (OLD, *kept):
        aged(tmp_path / name, OLD_S + (60.0 if name != YOUNG else -60.0))
    (tmp_path / "source_hashes.json").write_text("{}")
    remove_old(tmp_path / ("kernels-" + "b" * 16))
    assert {path.name for path in tmp_path.iterdir()} == {*kept, "source_hashes.json"}


def test_use_makes_a_folder_young(tmp_path):
    use(aged(tmp_path / OLD, OLD_S + 60.0))
    remove_old(tmp_path / YOUNG)
    assert (tmp_path / OLD / "contact" / "kernel.nbc").exists()


def test_a_process_keeps_its_folder_however_long_it_runs(tmp_path):
    folder = aged(tmp_path / OLD, 0.0)
    script = "import sys; from pathlib import Path; from snapjump.number.old_kernels import use\n"
    script += "use(Path(sys.argv[1])); print(flush=True); sys.stdin.read()"
    command = [sys.executable, "-c", script, str(folder)]
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE) as process:
        process.stdout.readline()
        aged(folder, OLD_S + 60.0)
        remove_old(tmp_path / YOUNG)
        assert folder.exists()
        process.stdin.close()
        process.wait()
    remove_old(tmp_path / YOUNG)
    assert not folder.exists()


def test_a_new_folder_takes_the_place_of_old_ones(tmp_path, monkeypatch):
    monkeypatch.setattr(compile_cache, "_place", [])
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path))
    aged(tmp_path / OLD, OLD_S + 60.0)
    use_cache_folder()
    assert cache_folder().exists() and not (tmp_path / OLD).exists()
    aged(tmp_path / OLD, OLD_S + 60.0)
    use_cache_folder()
    assert (tmp_path / OLD).exists()


def test_a_cache_that_cannot_be_written_is_left_alone(tmp_path):
    (tmp_path / "file").write_text("")
    use(tmp_path / "file" / YOUNG)
    remove_old(tmp_path / "file" / YOUNG)
    remove_old(tmp_path / "nowhere" / YOUNG)
