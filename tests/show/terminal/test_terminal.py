"""Closing blocks, in lengths and millimetres, of scenes and inverse designs; the progress bar."""

import io
from typing import Any

from reported import DRAFT_JUMP

from snapjump.show.terminal.block import block, markdown_table, number, table
from snapjump.show.terminal.inverse_report import inverse_report
from snapjump.show.terminal.progress import ProgressBar
from snapjump.show.terminal.scene_report import scene_report


def test_a_block_has_a_title_and_aligned_lines_without_empty_ones():
    lines = [("jump", "epsilon 0.2"), ("apex", "x 5 L"), ("tracking", ""), ("lift-off", "v_x 1")]
    assert block(lines) == "jump  epsilon 0.2\n  apex      x 5 L\n  lift-off  v_x 1"


def test_tables():
    assert table(["a", "bb"], [["10", "x"]]).splitlines() == ["a   bb", "--  --", "10  x"]
    assert markdown_table(["a"], [["x|y"]]).splitlines() == ["| a |", "| --- |", "| x\\|y |"]


def test_numbers_are_short_and_what_is_missing_is_empty():
    assert [number(v) for v in (1.23456, 7, None, True)] == ["1.235", "7", "", "true"]


def test_a_jump_is_reported_in_lengths_and_millimetres():
    summary = {"x_bar": 5.0, "y_bar": 14.0, "apex_time_s": 0.25, "steps": 700,
               "error_estimate_percent": 0.7, "within_tier": True}  # fmt: skip
    lines = dict(scene_report(DRAFT_JUMP, summary))
    assert lines["apex"] == "x 5 L (100 mm), y 14 L (280 mm), 250 ms after the clamps begin to turn"
    assert lines["cost"] == "700 steps"
    assert lines["accuracy"] == "draft: 3 %"
    assert "lift-off" not in lines


def test_a_changed_tier_claims_no_error():
    stepping = {"name": "adaptive", "tolerance": 1e-3}
    lines = dict(scene_report({**DRAFT_JUMP, "stepping": stepping}, {}))
    assert lines["accuracy"] == (
        "draft, but for stepping.tolerance: numerical error not known here"
    )


def test_other_scenes_show_every_output_by_name_with_its_unit():
    config = {**DRAFT_JUMP, "sim": {"name": "static"}, "accuracy": {"name": "standard"}}
    summary = {"alpha_critical_rad": 0.9117, "h1_bar": 0.08, "wall_seconds": 2.5}
    lines = dict(scene_report(config, summary))
    assert lines["alpha_critical_rad"] == "0.9117 rad"
    assert lines["h1_bar"] == "0.08 L (1.6 mm)"
    assert lines["cost"] == "2.5 s wall"


STANDARD = {"name": "standard", "known_error": "x within 1 %"}
CONFIG = {**DRAFT_JUMP, "inverse": {"name": "gauss_newton"}, "accuracy": STANDARD}
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
    assert lines["inverse"] == "target x 5 L, y 14 L, mu 0.3, mass_bar 0.768, by gauss_newton"
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


def test_costs_below_the_numerical_error_are_names():
    costs = {"one_percent_thickness_m_bar": 0.3, "one_percent_thickness_m_m": 0.006}
    lines = told(numerical_error_bar=0.15, **costs)
    assert lines["1 % of"] == (
        "thickness_m 0.3 L (6 mm); less than the numerical error, 0.15 L (3 mm): "
        "delta_alpha, epsilon, mass_bar, mu"
    )
    unknown = told(one_percent_unknown_because="robot.mount_height = 3 is not allowed: so")
    assert unknown["1 % of"] == "not known: robot.mount_height = 3 is not allowed: so"


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


def drawn(bar: ProgressBar, stream: io.StringIO) -> str:
    bar(0.5, "striking")
    text = stream.getvalue()
    bar.close()
    return text


def test_it_shows_share_and_word_where_asked_to(monkeypatch):
    monkeypatch.setenv("SNAPJUMP_PROGRESS", "1")
    stream = io.StringIO()
    text = drawn(ProgressBar(stream, show_after_s=0.0), stream)
    assert " 50 % striking" in text
    assert stream.getvalue().endswith("\r")


def test_it_is_silent_before_two_seconds_off_a_terminal_and_when_hidden(monkeypatch):
    stream = io.StringIO()
    monkeypatch.delenv("SNAPJUMP_PROGRESS", raising=False)
    assert drawn(ProgressBar(stream, show_after_s=0.0), stream) == ""
    monkeypatch.setenv("SNAPJUMP_PROGRESS", "1")
    assert drawn(ProgressBar(stream), stream) == ""
    assert drawn(ProgressBar(stream, show_after_s=0.0, visible=False), stream) == ""
