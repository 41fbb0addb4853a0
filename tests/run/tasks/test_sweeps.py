"""Sweeps: what they and their cells are called, what is told of them, and how they end."""

import csv
import io
from pathlib import Path

import pytest

from snapjump.files.result_folder import ResultFolder
from snapjump.run.tasks.base import exit_code, sweep_exit_code
from snapjump.run.tasks.names import cell_name, sweep_name
from snapjump.run.tasks.sweep_summary import (
    Cell,
    full_csv,
    positions,
    summary_table,
    sweep_figure,
    swept_inputs,
)


def cells(path: Path) -> list[Cell]:
    good = {"status": "ok", "steps": 7, "x_bar": 1.25, "y_bar": 10.0, "wall_seconds": 0.5}
    bad = {"status": "not_converged", "message": "at t = 1 ms", "x_bar": None}
    folder = ResultFolder(path)
    return [
        Cell("a", folder, {"design.epsilon": "0.1"}, good),
        Cell("b", folder, {"design.epsilon": "0.2"}, bad),
    ]


def test_inputs_are_the_keys_that_differ():
    found = swept_inputs([["a=1", "+b=2", "c=4"], ["a=1", "+b=3", "c=4"]])
    assert found == [{"b": "2"}, {"b": "3"}]


def test_the_table_shows_every_cell(tmp_path):
    header, rows = summary_table(cells(tmp_path))
    assert header == ["design.epsilon", "status", "x_bar", "y_bar", "seconds", "remark"]
    assert rows[0] == ["0.1", "ok", "1.25", "10", "0.5", ""]
    assert rows[1] == ["0.2", "not_converged", "", "", "", "at t = 1 ms"]


def test_the_csv_holds_every_result(tmp_path):
    first, second = csv.DictReader(io.StringIO(full_csv(cells(tmp_path))))
    assert first["steps"] == "7" and first["folder"] == "a"
    assert second["message"] == "at t = 1 ms" and second["x_bar"] == ""


def test_words_get_places_on_an_axis():
    assert positions(["0.1", "2e-3"]) == ([0.1, 0.002], [])
    assert positions(["draft", "paper", "draft"]) == ([0.0, 1.0, 0.0], ["draft", "paper"])


def test_the_figure_is_drawn(tmp_path):
    inputs = {"design.epsilon": ["0.1", "0.2"], "accuracy": ["draft", "paper"]}
    sweep_figure(tmp_path / "summary.png", inputs, {"x_bar": [1.0, None], "y_bar": [2.0, 3.0]})
    assert (tmp_path / "summary.png").stat().st_size > 5000


def test_a_cell_is_called_by_its_overrides():
    assert cell_name(["design.epsilon=0.1", "sim=jump"]) == "design.epsilon=0.1,sim=jump"
    assert cell_name([]) == "defaults"


def test_names_are_fit_for_folders_and_differ_where_the_overrides_do():
    first, second = cell_name(["robot.mount_height=a/b"]), cell_name(["robot.mount_height=a?b"])
    assert first != second
    assert "/" not in first and "?" not in second
    long = [f"design.epsilon={i / 1000}" for i in range(100)]
    assert len(cell_name(long)) < 120


def test_the_order_of_overrides_does_not_matter_to_a_sweep():
    assert sweep_name(["a=1,2", "b=3"]) == sweep_name(["b=3", "a=1,2"])
    assert sweep_name(["a=1,2"]) != sweep_name(["a=1,3"])


def test_where_a_sweep_is_recorded_does_not_matter():
    assert sweep_name(["a=1,2", "tracking=off"]) == sweep_name(["a=1,2"])
    assert sweep_name(["a=1,2", "tracking.path=x.db"]) == sweep_name(["a=1,2"])


@pytest.mark.parametrize(
    ("status", "code"),
    [
        ("ok", 0),
        ("no_jump", 0),
        ("error", 1),
        ("bad_input", 2),
        ("any_failure_of_a_simulation", 3),
        ("not_finite", 3),
        ("unreachable", 4),
        ("interrupted", 130),
    ],
)
def test_of_one_job(status, code):
    assert exit_code(status) == code


@pytest.mark.parametrize(
    ("statuses", "code"),
    [
        (["ok", "no_jump"], 0),
        (["ok", "unreachable"], 0),
        (["ok", "bad_input"], 2),
        (["ok", "bad_input", "not_converged"], 3),
        (["ok", "not_started"], 3),
    ],
)
def test_of_a_sweep(statuses, code):
    assert sweep_exit_code(statuses) == code
