"""Verdicts on dataset, forward model and inverse design; a small dataset by a cell of the study."""

from typing import Any

from cells import STANDARD

from experiments.compositions import described
from experiments.paper.base import CONFIRMED, LIMITED, NOT_CONFIRMED
from experiments.paper.forward_model import part as judge
from experiments.paper.forward_model.figure import draw_forward_model
from experiments.paper.forward_model.part import (
    DATA_DRIVEN,
    METHODS,
    ForwardModels,
    dataset_rows,
    snake_case,
)
from snapjump.simulation import build


def made(**changes: Any) -> dict[str, Any]:
    row = {"jumps": 50625, "ok": 50625, "kernel_core_seconds": 600.0, "wall_seconds": 300.0}
    return {**row, "cores": 2, **changes}


def method(seconds: float, mean: float = 1.0) -> dict[str, Any]:
    misses = dict.fromkeys(
        ("mean_mm_standard", "std_mm_standard", "max_mm_standard", "mean_mm_reference"), mean
    )
    times = dict.fromkeys(("seconds_mean", "seconds_median", "seconds_max"), seconds)
    return {**misses, **times, "problems": 10, "simulations_mean": 33.0}


def methods(
    mean: float = 1.0, search: float = 1000.0, own: float = 0.5
) -> dict[str, dict[str, Any]]:
    times = {DATA_DRIVEN: own, "gauss_newton": 0.01, "physics": 0.4}
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
    def verdicts(*given: float) -> list[str]:
        return [one.verdict for one in judge.inverse_statements(methods(*given))]

    assert verdicts(2.0, 2000.0, 0.3) == [CONFIRMED] * 4
    assert verdicts(4.0, 1000.0, 0.5) == [LIMITED, LIMITED, CONFIRMED, LIMITED]
    assert verdicts(12.0, 5.0, 0.9) == [NOT_CONFIRMED] * 4
    assert verdicts(9.0, 5.0, 0.6) == [NOT_CONFIRMED, LIMITED, LIMITED, NOT_CONFIRMED]
    *_, told = judge.inverse_statements(methods(search=5.0))
    assert "1,555 times as long" in told.says and "optimisation 10 times as long" in told.found


def test_real_time_or_not():
    def verdict(taken: float) -> str:
        row = {"apex_time_s": 0.3, "liftoff_time_s": 0.05, "kernel_seconds": taken}
        return judge.real_time_statement({"paper": [row], "standard": [row]}).verdict

    assert [verdict(taken) for taken in (0.04, 0.2, 0.4)] == [CONFIRMED, LIMITED, NOT_CONFIRMED]


def test_the_pace_is_of_single_jumps():
    cell = ForwardModels().plan(STANDARD, 0)[-1]
    rows = ForwardModels().compute({**cell.inputs, "designs": cell.inputs["designs"][:2]})
    for row in rows:
        assert row["status"] == "ok" and row["kernel_seconds"] > 0.0
        assert 0.02 < row["liftoff_time_s"] < row["apex_time_s"] < 1.0


def test_the_plan_has_the_paper_s_size():
    cells = ForwardModels().plan(STANDARD, 0)
    assert cells[0].inputs["plan"]["points"] ** 4 == 50_625
    assert cells[1].inputs["surrogate"]["name"] == "mlp"
    assert len(cells) == 2 + 3 * 10 + 2 + 2
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
