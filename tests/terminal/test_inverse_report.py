"""The closing block of an inverse design."""

from typing import Any

from snapjump.terminal.inverse_report import inverse_report

CONFIG: dict[str, Any] = {
    "inverse": {"name": "gauss_newton"},
    "environment": {"mu": 0.3, "mass_bar": 0.768},
    "robot": {"length_m": 0.02},
    "sim": {"name": "jump"},
    "accuracy": {"name": "standard", "known_error": "x within 1 %"},
}
COSTS = {f"one_percent_{name}_bar": 0.1 for name in ("delta_alpha", "epsilon", "mass_bar", "mu")}
SUMMARY: dict[str, Any] = {
    "reachable": True, "target_x_bar": 5.0, "target_y_bar": 14.0, "epsilon": 0.1877201,
    "delta_alpha_rad": 0.0970151, "predicted_x_bar": 5.0, "predicted_y_bar": 14.0,
    "simulated_x_bar": 4.983, "simulated_y_bar": 13.991, "error_bar": 0.0192,
    "solve_seconds": 0.0153, "simulations": 0, "solutions": 1, **COSTS,
}  # fmt: skip


def told(**changes: Any) -> dict[str, str]:
    return dict(inverse_report(CONFIG, {**SUMMARY, **changes}))


def test_lengths_in_both_units():
    lines = told()
    assert lines["inverse"] == "target x 5 L, y 14 L, mu 0.3, m_bar 0.768, by gauss_newton"
    assert lines["design"] == "delta_alpha 0.0970151 rad, epsilon 0.18772"
    assert lines["simulated"] == "x 4.983 L (99.66 mm), y 13.99 L (279.8 mm)"
    assert lines["error"] == "0.0192 L (0.384 mm)"
    assert lines["1 % of"].count("0.1 L (2 mm)") == 4
    assert lines["cost"] == "15.3 ms and 0 simulations for the search"
    assert lines["others"] == lines["robust"] == lines["plain"] == ""


def test_what_is_not_known_is_left_out():
    missing = {key: None for key in (*COSTS, "predicted_x_bar", "simulated_x_bar", "error_bar")}
    lines = told(**missing)
    assert lines["predicted"] == lines["simulated"] == lines["error"] == lines["1 % of"] == ""


def test_many_solutions():
    others = {
        f"solution_{k}_{name}": 0.1 * k
        for k in range(2, 8)
        for name in ("epsilon", "delta_alpha_rad")
    }
    lines = told(solutions=7, **others)
    assert lines["others"].count("delta_alpha") == 4 and lines["others"].endswith("and 2 more")


def test_a_robust_design():
    spread = {
        f"{name}_{key}_bar": value
        for name, value in (("robust", 0.2), ("plain", 0.3))
        for key in ("expected_miss", "radius90")
    }
    lines = told(**spread, robust_seconds=0.5, plain_epsilon=0.2, plain_delta_alpha_rad=0.1)
    assert lines["robust"].startswith("expected miss 0.2 L (4 mm) instead of 0.3 L (6 mm)")
    assert lines["plain"] == "delta_alpha 0.1 rad, epsilon 0.2"
    assert lines["cost"].endswith("0.5 s for the robust design")


def test_an_interrupted_run():
    assert inverse_report(CONFIG, {"wall_seconds": 1.0}) == [("inverse", "by gauss_newton")]
