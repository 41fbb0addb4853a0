"""Sweeps: what they and their cells are called, what is told of them, and how they end."""

import csv
import io
from pathlib import Path

import numpy as np
import pytest

from snapjump.composition import Simulation
from snapjump.declare.inputs import inputs_of
from snapjump.files.result_folder import ResultFolder
from snapjump.run.tasks.base import exit_code, sweep_exit_code
from snapjump.run.tasks.names import FIXED, SWEPT_KEYS, cell_name, sweep_name
from snapjump.run.tasks.sweep_cells import Cell, swept_inputs
from snapjump.run.tasks.sweep_figure import input_label, output_label
from snapjump.run.tasks.sweep_summary import full_csv, summary_table
from snapjump.show.plots.sweep import Axis, Swept, draw_sweep


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


def test_words_get_places_on_an_axis_and_geometric_numbers_logarithms():
    assert Axis.of("", ["0.1", "2e-3"]).places.tolist() == [0.1, 0.002]
    words = Axis.of("", ["draft", "paper", "draft"])
    assert words.places.tolist() == [0.0, 1.0, 0.0] and words.words == ["draft", "paper"]
    assert Axis.of("", ["1e-4", "1e-3", "1e-2"]).logarithmic
    assert not Axis.of("", ["1", "5", "9"]).logarithmic
    assert not Axis.of("", ["0", "1e-3", "1e-2"]).logarithmic


@pytest.mark.parametrize("fine", [2, 6])
def test_the_figure_is_drawn(tmp_path, fine):
    pairs = [(f"{k / 10}", f"{j}") for k in range(3 * fine) for j in range(fine)]
    values = np.arange(float(len(pairs)))
    values[3] = np.nan
    swept = Swept(
        "sweep",
        {"ε": [one for one, _ in pairs], "Δα (rad)": [other for _, other in pairs]},
        {"x / L": values, "y / L": 2.0 * values},
        ["no_jump" if k == 3 else "" for k in range(len(pairs))],
        {"x / L": 0.1 + 0.0 * values},
    )
    draw_sweep(swept, tmp_path / "summary.png")
    assert (tmp_path / "summary.png").stat().st_size > 5000


def test_labels_have_symbols_and_units():
    simulation = Simulation()
    inputs = inputs_of(simulation)
    outputs = {one.name: one for one in simulation.sim.outputs.declared()}
    assert input_label("design.delta_alpha", inputs) == "mismatch, Δα (rad)"
    assert input_label("accuracy", inputs) == "accuracy"
    assert output_label("x_bar", outputs) == "x / L"
    assert output_label("liftoff_vx_m_s", outputs) == "liftoff_vx_m_s (m/s)"


def test_a_cell_is_called_by_what_varies(monkeypatch):
    overrides = ["design.epsilon=0.12000000000000001", "sim=jump"]
    assert cell_name(["design.epsilon=0.1", "sim=jump"]) == "design.epsilon=0.1,sim=jump"
    assert cell_name([]) == "defaults"
    monkeypatch.setenv(SWEPT_KEYS, "design.epsilon")
    assert cell_name(overrides) == "epsilon=0.12"
    monkeypatch.setenv(FIXED, "0123abcd")
    assert cell_name(overrides) == "epsilon=0.12-0123abcd"
    monkeypatch.setenv(SWEPT_KEYS, "contact.damping_s,other.damping_s")
    assert cell_name(["contact.damping_s=0", "other.damping_s=1"]).startswith(
        "contact.damping_s=0,"
    )


def test_names_are_fit_for_folders_and_differ_where_the_overrides_do():
    first, second = cell_name(["robot.mount_height=a/b"]), cell_name(["robot.mount_height=a?b"])
    assert first != second
    assert "/" not in first and "?" not in second
    long = [f"design.epsilon={i / 1000}" for i in range(100)]
    assert len(cell_name(long)) < 120


def test_a_sweep_is_known_by_what_varies_and_what_else_was_said():
    assert sweep_name(["a=1,2", "b=3"], ["a"]) == sweep_name(["b=3", "a=1,2"], ["a"])
    assert sweep_name(["a=1,2"], ["a"]) == sweep_name(["a=1,3"], ["a"])
    assert sweep_name(["a=1,2", "b=3"], ["a"]) != sweep_name(["a=1,2", "b=4"], ["a"])
    assert sweep_name(["a=1,2", "b=3,4"], ["a", "b"]) != sweep_name(["a=1,2", "b=3"], ["a"])


def test_where_a_sweep_is_recorded_does_not_matter():
    assert sweep_name(["a=1,2", "tracking=off"], ["a"]) == sweep_name(["a=1,2"], ["a"])
    assert sweep_name(["a=1,2", "tracking.path=x.db"], ["a"]) == sweep_name(["a=1,2"], ["a"])


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
