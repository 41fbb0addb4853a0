"""The folder of a job: what belongs to it, when it counts as done, what is never in it."""

from pathlib import Path

import numpy as np
import pytest

from snapjump.files.atomic import write_text
from snapjump.files.json_file import write_json
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


def test_half_drawn_pictures_of_a_killed_job_go(tmp_path):
    (tmp_path / ".figures.abc").mkdir()
    (tmp_path / ".figures.abc" / "jump.png").write_text("")
    ResultFolder(tmp_path).begin()
    assert not list(tmp_path.iterdir())


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
