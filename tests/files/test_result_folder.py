from pathlib import Path

import numpy as np
import pytest

from snapjump.files.result_folder import ResultFolder

CONFIG = {"design": {"epsilon": 0.2}, "tracking": {"name": "off"}, "step_s": 1e-5}
DONE = frozenset({"ok"})


def finished_folder(path: Path) -> ResultFolder:
    folder = ResultFolder(path)
    folder.write_config(CONFIG)
    folder.write_provenance({"source_sha256": "abc"})
    folder.write_result({"status": "ok"})
    return folder


def test_a_configuration_comes_back_as_it_was(tmp_path):
    assert finished_folder(tmp_path).config() == CONFIG


def test_finished_means_same_physics_same_code_and_a_good_end(tmp_path):
    folder = finished_folder(tmp_path)
    assert folder.holds(CONFIG, "abc", DONE)
    assert folder.holds({**CONFIG, "tracking": {"name": "sqlite"}}, "abc", DONE)
    assert not folder.holds({**CONFIG, "design": {"epsilon": 0.3}}, "abc", DONE)
    assert not folder.holds(CONFIG, "other code", DONE)
    folder.write_result({"status": "diverged"})
    assert not folder.holds(CONFIG, "abc", DONE)
    folder.forget()
    assert not folder.holds(CONFIG, "abc", DONE)


def test_arrays_that_are_not_finite_reach_no_file(tmp_path):
    arrays = {"x": np.arange(3.0), "y": np.array([1.0, np.nan]), "n": np.arange(2)}
    assert ResultFolder(tmp_path).write_arrays("trajectory", arrays) == ["y"]
    with np.load(tmp_path / "trajectory.npz") as file:
        assert sorted(file) == ["n", "x"]
        assert np.array_equal(file["x"], arrays["x"])


def test_figures_appear_together_or_not_at_all(tmp_path):
    def draw_half(folder: Path) -> None:
        (folder / "a.png").write_text("a")
        raise RuntimeError("no ink")

    with pytest.raises(RuntimeError):
        ResultFolder(tmp_path).write_figures(draw_half)
    assert not list(tmp_path.iterdir())
    ResultFolder(tmp_path).write_figures(lambda folder: (folder / "b.png").write_text("b"))
    assert [path.name for path in ResultFolder(tmp_path).files()] == ["b.png"]


def test_a_result_of_before_is_read_under_the_names_of_today(tmp_path):
    folder = ResultFolder(tmp_path)
    folder.write_config({"robot": {"length_m": 0.02}})
    folder.write_result({"status": "ok", "mount_height_m": 0.0015})
    assert folder.result() == {"status": "ok", "mount_height_bar": pytest.approx(0.075)}
