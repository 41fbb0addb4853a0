"""The benchmark of inverse design on two targets of coarse jumps, and its table."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from cells import COARSE, GIVEN, run_study
from made_up_maps import RANGES
from refusals import refused
from small_datasets import CONFIG, generated, silent, small

from experiments.inverse_benchmark import region
from experiments.inverse_benchmark.compute import make_problems
from experiments.inverse_benchmark.figure import draw_benchmark
from experiments.inverse_benchmark.methods import METHODS, PAPER, SOLVED_MM
from experiments.inverse_benchmark.study import InverseBenchmark, chosen, stretches
from experiments.inverse_benchmark.table import readme_block, summary_row, unsolved
from snapjump.dataset.read import load_dataset
from snapjump.declare.members import member_class, member_names
from snapjump.learning.data import JumpData
from snapjump.learning.learn import learn
from snapjump.learning.training import Training
from snapjump.simulation import build


@pytest.fixture(scope="module")
def checkpoint(tmp_path_factory) -> Path:
    """An interpolation between 250 coarse jumps."""
    path: Path = tmp_path_factory.mktemp("coarse")
    generated(path / "jumps", small(250, 250))
    data = JumpData(load_dataset(path / "jumps"), Training(), 0)
    return learn(data, member_class("surrogate", "rbf")(), silent, place=path).file


def configured(**task: Any) -> dict[str, Any]:
    given = {"problems": 2, "environments": 0, "methods": ["gauss_newton", "physics"]}
    given |= {"name": "inverse_benchmark", "checkpoint": None}
    return {**COARSE, "task": {**given, **task}, **GIVEN}


def rows(*misses: float | None, **changes: Any) -> list[dict[str, Any]]:
    ones = ("target_x_bar", "target_y_bar", "mass_bar", "mu", "epsilon")
    tenths = ("hidden_delta_alpha_rad", "hidden_epsilon", "delta_alpha_rad")
    same = dict.fromkeys(ones, 1.0) | dict.fromkeys(tenths, 0.1)
    same |= {"finished_at": "own", "reachable": True, "seconds": 0.5, "simulations": 24}
    return [
        {
            "problem": k, "miss_own_mm": miss, "miss_standard_mm": miss,
            "miss_reference_mm": None if miss is None else 2.0 * miss, **same, **changes,
        }
        for k, miss in enumerate(misses)
    ]  # fmt: skip


def test_problems_are_the_same_whichever_are_asked_for():
    base = build(CONFIG)
    both, second = (make_problems(base, RANGES, 3, first, 2) for first in (0, 1))
    assert np.array_equal(both.hidden[1:], second.hidden)
    assert np.array_equal(both.targets[1:], second.targets)
    low, high = np.array(RANGES).T
    assert ((both.hidden >= low) & (both.hidden <= high)).all()
    other = make_problems(base, RANGES, 4, 0, 1)
    assert not np.array_equal(other.hidden, both.hidden[:1])


def test_physics_hits_what_the_forward_model_misses(checkpoint, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    study = InverseBenchmark()
    study.prepare(configured(checkpoint=str(checkpoint)))
    names = [f"{method}: targets 0 to 1" for method in ("gauss_newton", "physics")]
    assert [cell.name for cell in study.cells] == names
    found = {cell.inputs["method"]: study.compute(cell) for cell in study.cells}
    for row in found["physics"]:
        assert 0.01 <= row["delta_alpha_rad"] <= 0.19
        assert 0.1 <= row["epsilon"] <= 0.3
        assert row["simulations"] >= 8
    assert all(row["simulations"] > 0 for row in found["gauss_newton"])  # its answers are judged
    own = {name: np.mean([row["miss_own_mm"] for row in all_]) for name, all_ in found.items()}
    assert own["physics"] < SOLVED_MM
    assert own["physics"] < 0.1 * own["gauss_newton"]


def test_the_study_concludes_and_replaces_readme_s_table(checkpoint, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    config = configured(checkpoint=str(checkpoint), methods=["gauss_newton"], problems=1)
    outcome, folder = run_study(InverseBenchmark(), config, tmp_path / "run")
    assert outcome.status == "ok"
    assert (folder.path / "misses.png").stat().st_size > 10_000
    assert "`gauss_newton`" in (folder.path / "inverse.block.md").read_text()


@pytest.mark.slow
def test_the_region_is_held_against_simulation(checkpoint, monkeypatch):
    monkeypatch.setattr(region, "POINTS", 9)
    monkeypatch.setattr(region, "TARGETS", 8)
    inputs = {"checkpoint": str(checkpoint), "groups": COARSE, "seed": 0}
    (row,) = region.region_rows({**inputs, "first": 0, "last": 1})
    assert 2 <= row["reachable"] <= 7
    # The truth is a grid of triangles, and what ends within 0.03 L is reached.
    assert row["false_rejects"] <= 1 and row["false_accepts"] <= 1


def test_a_summary_is_of_the_misses_that_are_known():
    row = summary_row("physics", rows(0.01, 0.03, None, 0.5))
    assert row["mean_mm_standard"] == pytest.approx(0.18)
    assert row["max_mm_reference"] == pytest.approx(1.0)
    assert row["failed_standard"] == 1
    assert row["solved"] == 2
    assert row["simulations_mean"] == 24.0
    row = summary_row("bayesian", rows(None, None))
    assert np.isnan(row["mean_mm_standard"]) and row["failed_standard"] == 2


def test_solved_is_what_is_reachable_and_reached_where_the_method_finished():
    assert summary_row("physics", rows(0.06))["solved"] == 1
    assert summary_row("physics", rows(0.06, finished_at="reference"))["solved"] == 0
    row = summary_row("physics", rows(0.01, 0.02, reachable=False))
    assert (row["solved"], row["called_unreachable"]) == (0, 2)


def test_every_miss_of_a_method_with_a_simulator_is_listed():
    missed = unsolved({"physics": rows(0.01, None, 0.2), "adam": rows(5.0)})
    assert [row["problem"] for row in missed] == [1, 2]


def test_every_member_is_compared_and_in_the_block_beside_the_paper_s_numbers():
    assert {group["name"] for group in METHODS.values()} == set(member_names("inverse"))
    assert chosen(None).keys() == METHODS.keys()
    text = readme_block([summary_row(name, rows(0.01, 0.02)) for name in METHODS], 2)
    assert "`physics`, finishing at reference" in text
    assert all(str(row["mean_mm"]) in text for row in PAPER)


def test_the_figure_is_drawn_with_misses_that_are_unknown(tmp_path):
    draw_benchmark({"adam": rows(1.0, None), "physics": rows(0.01, 0.02)}, tmp_path / "m.png")
    assert (tmp_path / "m.png").stat().st_size > 10_000


def test_stretches_cover_everything_once():
    assert stretches(25, 10) == [(0, 10), (10, 20), (20, 25)]
    assert stretches(0, 10) == []


BAD_INPUT = (
    ("problems", 0), ("environments", -1), ("methods", ["magic"]), ("methods", []),
    ("methods", [["adam"]]), ("checkpoint", "nowhere.safetensors"),
)  # fmt: skip


@pytest.mark.parametrize(("name", "value"), BAD_INPUT)
def test_bad_input_is_named(name, value):
    with refused(name if name == "checkpoint" else f"task.{name}"):
        InverseBenchmark().prepare(configured(**{name: value}))
