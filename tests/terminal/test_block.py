from snapjump.terminal.block import block, markdown_table, number, table
from snapjump.terminal.scene_report import scene_report


def test_a_block_has_a_title_and_aligned_lines_without_empty_ones():
    lines = [("jump", "epsilon 0.2"), ("apex", "x 5 L"), ("tracking", ""), ("lift-off", "v_x 1")]
    assert block(lines) == "jump  epsilon 0.2\n  apex      x 5 L\n  lift-off  v_x 1"


def test_tables():
    assert table(["a", "bb"], [["10", "x"]]).splitlines() == ["a   bb", "--  --", "10  x"]
    assert markdown_table(["a"], [["x|y"]]).splitlines() == ["| a |", "| --- |", "| x\\|y |"]


def test_numbers_are_short_and_what_is_missing_is_empty():
    assert [number(v) for v in (1.23456, 7, None, True)] == ["1.235", "7", "", "true"]


def test_a_jump_is_reported_in_lengths_and_millimetres():
    config = {
        "sim": {"name": "jump"},
        "design": {"epsilon": 0.2, "delta_alpha": 0.1},
        "environment": {"mu": 0.3, "mass_bar": 0.768},
        "robot": {"length_m": 0.02},
        "accuracy": {"name": "draft", "known_error": "3 %"},
    }
    summary = {"x_bar": 5.0, "y_bar": 14.0, "apex_time_s": 0.25, "steps": 700}
    lines = dict(scene_report(config, summary))
    assert lines["apex"] == "x 5 L (100 mm), y 14 L (280 mm), 250 ms after the clamps begin to turn"
    assert lines["cost"] == "700 steps"
    assert lines["accuracy"] == "draft: 3 %"
    assert "lift-off" not in lines


def test_a_changed_tier_claims_no_error():
    config = {
        "sim": {"name": "jump"},
        "design": {"epsilon": 0.2, "delta_alpha": 0.1},
        "environment": {"mu": 0.3, "mass_bar": 0.768},
        "robot": {"length_m": 0.02},
        "accuracy": {"name": "draft", "known_error": "3 %"},
        "stepping": {"name": "adaptive", "tolerance": 1e-3},
    }
    lines = dict(scene_report(config, {}))
    assert lines["accuracy"] == "draft, but for stepping.tolerance: its error is not known"


def test_other_scenes_show_every_output_by_name_with_its_unit():
    config = {
        "sim": {"name": "static"},
        "design": {"epsilon": 0.2, "delta_alpha": 0.1},
        "robot": {"length_m": 0.02},
        "accuracy": {"name": "standard"},
    }
    summary = {"alpha_critical_rad": 0.9117, "h1_bar": 0.08, "wall_seconds": 2.5}
    lines = dict(scene_report(config, summary))
    assert lines["alpha_critical_rad"] == "0.9117 rad"
    assert lines["h1_bar"] == "0.08 L (1.6 mm)"
    assert lines["cost"] == "2.5 s wall"
