"""Optuna's sweeper is told an output of each jump, or the worst where one fails."""

import math

import pytest
import yaml

pytestmark = pytest.mark.processes

OPTUNA = ("-m", "hydra/sweeper=optuna", "hydra.sweeper.n_trials=6", "accuracy=draft")
QUIET = ("figures=false", "tracking=off", "hydra.sweeper.sampler.seed=1")


def test_it_finds_the_highest_jump(process, tmp_path):
    span = "design.epsilon=interval(0.1,0.3)"
    told = process(*OPTUNA, span, "objective=y_bar", "hydra.sweeper.direction=maximize", *QUIET)
    assert "6 cells: 6 ok" in told.stdout and "Traceback" not in told.stderr
    (folder,) = (tmp_path / "outputs" / "sweeps").iterdir()
    found = yaml.safe_load((folder / "optimization_results.yaml").read_text())
    assert found["best_value"] > 14.0 and 0.2 < found["best_params"]["design.epsilon"] <= 0.3
    assert len((folder / "summary.csv").read_text().splitlines()) == 7


def test_a_jump_that_fails_is_the_worst(process, tmp_path):
    span = "design.epsilon=interval(0.39,0.5)"  # most of it is refused
    told = process(
        *OPTUNA, span, "objective=y_bar", "hydra.sweeper.direction=minimize", *QUIET, code=2
    )
    assert "bad_input" in told.stdout
    (folder,) = (tmp_path / "outputs" / "sweeps").iterdir()
    found = yaml.safe_load((folder / "optimization_results.yaml").read_text())
    assert math.isinf(found["best_value"]) or found["best_params"]["design.epsilon"] <= 0.4


@pytest.mark.parametrize(
    ("objective", "told"),
    [((), "objective = None"), (("objective=height",), "objective = 'height'")],
)
def test_without_an_output_it_is_refused(process, objective, told):
    refused = process(*OPTUNA, "design.epsilon=interval(0.1,0.3)", *objective, *QUIET, code=2)
    assert told in refused.stderr and refused.stderr.count("is not allowed") == 1
