"""Verdicts on dataset, forward model and inverse design; a small dataset by a cell of the study."""

from typing import Any

from cells import STANDARD

from experiments.compositions import described
from experiments.paper.forward_model import judge
from experiments.paper.forward_model.compute import DATA_DRIVEN, METHODS, dataset_rows
from experiments.paper.forward_model.figure import draw_forward_model
from experiments.paper.forward_model.part import ForwardModels, snake_case
from experiments.paper.statement import CONFIRMED, LIMITED, NOT_CONFIRMED
from snapjump.simulation import build


def made(**changes: Any) -> dict[str, Any]:
    row = {"jumps": 50625, "ok": 50625, "kernel_core_seconds": 600.0, "wall_seconds": 300.0}
    return {**row, "cores": 2, **changes}


def method(seconds: float, mean: float = 1.0) -> dict[str, Any]:
    keys = ("mean_mm_standard", "std_mm_standard", "mean_mm_reference")
    return {**dict.fromkeys(keys, mean), "seconds_median": seconds, "problems": 10,
            "simulations_mean": 33.0}  # fmt: skip


def methods(mean: float = 1.0, search: float = 1000.0) -> dict[str, dict[str, Any]]:
    times = {DATA_DRIVEN: 0.5, "gauss_newton": 0.01, "physics": 0.4}
    found = {name: method(seconds, mean) for name, seconds in times.items()}
    return found | {name: method(search) for name in ("bayesian", "finite_difference")}


def test_the_dataset_s_cost():
    told = judge.dataset_statement(made())
    assert told.verdict == CONFIRMED and "480 times fewer" in told.found
    assert "300 s by the clock on 2 cores" in told.found
    assert judge.dataset_statement(made(ok=50_000)).verdict == LIMITED
    assert judge.dataset_statement(made(kernel_core_seconds=4e5)).verdict == LIMITED
    assert judge.dataset_statement(made(kernel_core_seconds=9e5)).verdict == NOT_CONFIRMED
    assert "clock" not in judge.dataset_statement(made(wall_seconds=None)).found


def test_the_forward_model_s_error():
    def verdict(mae: float) -> str:
        row = {"mae_bar": mae, "rows_train": 36450, "rows_test": 10125}
        return judge.error_statement(row).verdict

    assert [verdict(mae) for mae in (0.03, 0.1, 0.2)] == [CONFIRMED, LIMITED, NOT_CONFIRMED]


def test_the_misses_and_the_times_of_designs():
    assert judge.accuracy_statement(methods(2.0)).verdict == CONFIRMED
    assert judge.accuracy_statement(methods(4.0)).verdict == LIMITED
    assert judge.accuracy_statement(methods(9.0)).verdict == NOT_CONFIRMED
    assert judge.speed_statement(methods(search=2000.0)).verdict == CONFIRMED
    assert judge.speed_statement(methods(search=1000.0)).verdict == LIMITED
    told = judge.speed_statement(methods(search=5.0))
    assert told.verdict == NOT_CONFIRMED
    assert "1,555 times as long" in told.says and "optimisation 10 times as long" in told.found


def test_the_plan_has_the_paper_s_size():
    cells = ForwardModels().plan(STANDARD, 0)
    assert cells[0].inputs["plan"]["points"] ** 4 == 50_625
    assert cells[1].inputs["surrogate"]["name"] == "mlp"
    assert len(cells) == 2 + 3 * 10 + 2
    assert snake_case(DATA_DRIVEN) == "adam_the_paper_s_network"


def test_a_dataset_is_made_once(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    plan = {"name": "sobol", "count": 16}
    groups = described(build({"accuracy": {"name": "draft"}}))
    inputs = {"groups": groups, "plan": plan, "shard_size": 8}
    first, second = dataset_rows(inputs)[0], dataset_rows(inputs)[0]
    assert first["jumps"] == 16 and first["kernel_core_seconds"] > 0.0 and first["wall_seconds"] > 0
    assert second["wall_seconds"] is None and second["dataset_sha256"] == first["dataset_sha256"]


def test_the_figure(tmp_path):
    predictions = [
        {"x_bar": x, "y_bar": 10.0, "predicted_x_bar": x, "predicted_y_bar": 9.9}
        for x in (1.0, 2.0)
    ]
    rows = {name: [{"miss_standard_mm": 0.1}, {"miss_standard_mm": None}] for name in METHODS}
    draw_forward_model(predictions, rows, tmp_path / "forward_model.png")
    assert (tmp_path / "forward_model.png").stat().st_size > 10_000
