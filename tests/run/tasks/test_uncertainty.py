"""``uncertainty=model``: what closing block, result and table say, and what is refused."""

import csv

import pytest
from command_line import result_in
from hydra_config import hydra_config
from refusals import refused

from snapjump.run.tasks.simulate import Simulate
from snapjump.uncertainty.parts.tolerances import DEFAULTS, LAWS

JUMP = ("accuracy=draft", "figures=false", "tracking=off")
# Other members of families are other programs.
NUMBERS = ",".join(f"{name}: null" for name in DEFAULTS if name in LAWS)


def test_the_model_s_uncertainty_stands_beside_the_numerical_error(command, tmp_path):
    done = command(*JUMP, "uncertainty=model", f"uncertainty.tolerances={{{NUMBERS}}}")
    folder, result = result_in(tmp_path)
    lines = [line.split(None, 2) for line in done.stdout.splitlines()]
    (off_by,) = [line[2] for line in lines if line[:2] == ["off", "by"]]
    assert off_by.startswith("model x +- ") and "; numerical x +- " in off_by
    assert f"{result['model_spread_y_bar']:.2g} L" in off_by
    assert "  most by " in done.stdout and result["model_spread_largest"] in done.stdout
    assert 0.0 < result["numerical_error_y_bar"] < result["model_spread_y_bar"]
    rows = list(csv.DictReader((folder / "uncertainty.csv").open()))
    assert float(rows[0]["change_y_bar"]) == result["model_robot_thickness_m_less_y_bar"]
    assert "uncertainty.csv" in done.stdout


def test_nothing_more_is_simulated_unless_asked_for(command, tmp_path):
    done = command(*JUMP)
    folder, result = result_in(tmp_path)
    assert "off by" not in done.stdout and not (folder / "uncertainty.csv").exists()
    assert not any(key.startswith("model_") for key in result)


@pytest.mark.parametrize(
    ("words", "key"),
    [
        (("sim=snap",), "uncertainty"),
        (("uncertainty.tolerances={robot.thicknes_m: null}",), "uncertainty.tolerances"),
        (("uncertainty.tolerances=3",), "uncertainty.tolerances"),
    ],
)
def test_bad_input_is_one_line_before_any_work(words, key):
    with refused(key):
        Simulate().prepare(hydra_config("uncertainty=model", *words))
