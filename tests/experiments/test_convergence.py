"""The ladders of tiny compositions, from the command line to the record."""

import re
from collections import Counter
from typing import Any

import pytest
from command_line import result_in
from families import FAMILIES
from records import database_in, runs_in

from experiments.compositions import changed, composed, described, groups_of
from experiments.convergence.ladders import ladders
from experiments.convergence.study import Convergence
from snapjump.checks import ParameterError
from snapjump.composition import with_tier

TINY = (
    "task=convergence", "task.levels=3", "discretization.elements=16", "stepping.tolerance=1e-5",
)  # fmt: skip


def base(**parts: Any) -> dict[str, Any]:
    return described(with_tier("standard", **parts))


def test_a_description_builds_the_same_simulation():
    for tier in ("draft", "paper"):
        simulation = with_tier(tier)
        assert composed(described(simulation)) == simulation


def test_another_member_drops_the_values_of_the_old_one():
    groups = changed(base(), {"stepping": {"name": "fixed", "step_s": 1e-6}})
    assert groups["stepping"] == {"name": "fixed", "step_s": 1e-6}
    assert changed(base(), {"contact": {"distance_m": 1.0}})["contact"]["stiffness_N_m"] == 1e4


@pytest.mark.parametrize("integrator", FAMILIES["integrator"])
@pytest.mark.parametrize("stepping", ["adaptive", "fixed"])
def test_the_reference_in_time_is_another_and_much_tighter_method(integrator, stepping):
    groups = changed(base(), {"integrator": {"name": integrator}, "stepping": {"name": stepping}})
    groups["stepping"] |= {"tolerance": 1e-6} if stepping == "adaptive" else {"step_s": 1e-5}
    time, *others = ladders(groups, 4)
    tight = time.references["time reference tight"]
    assert tight["integrator"]["name"] != integrator
    if stepping == "adaptive":
        finest = min(level["stepping"]["tolerance"] for level in time.levels.values())
        assert tight["stepping"]["tolerance"] <= finest / 99
    for ladder in others:
        for level in ladder.levels.values():
            assert level["stepping"]["tolerance"] <= 1e-9


def test_only_what_the_composition_has_is_refined():
    names = [ladder.name for ladder in ladders(changed(base(), {"friction": {"name": "none"}}), 3)]
    assert names == ["time", "nodes", "barrier", "stiffness"]


def test_other_scenes_are_refused():
    config = {**base(), "task": {"name": "convergence", "levels": None}, "effort": "quick"}
    with pytest.raises(ParameterError, match="sim = 'snap'"):
        Convergence().prepare({**config, "sim": {"name": "snap"}})
    with pytest.raises(ParameterError, match=r"task.levels = 2 .* \[3, 10\]"):
        Convergence().prepare({**config, "task": {"name": "convergence", "levels": 2}})
    assert groups_of(config)["integrator"]["name"] == "generalized_alpha"


@pytest.mark.slow
def test_from_the_command_line_to_record_and_documentation(command, database, tmp_path):
    (tmp_path / "docs").mkdir()
    done = command(*TINY, "publish=docs/studies")
    assert "convergence" in done.stdout and "finding" in done.stdout
    folder, summary = result_in(tmp_path)
    assert summary["status"] == "ok" and summary["cells_kept"] == 0
    # So coarse that there is no order; but the mesh's limit is near the usual one, 0.0507 s.
    assert abs(summary["nodes_snap_time_s_limit"] - 0.0507) < 0.002
    names = {file.name for file in folder.iterdir()}
    assert {"orders.csv", "orders.md", "levels.csv", "ladders.png", "report.md"} <= names
    page = (tmp_path / "docs/studies/convergence.md").read_text()
    assert "`python run.py task=convergence task.levels=3" in page
    (picture,) = re.findall(r"\((convergence-.*\.png)\)", page)
    assert (tmp_path / "docs/studies" / picture).stat().st_size > 10_000
    runs, _ = runs_in(database_in(tmp_path))
    parents = Counter(run.data.tags.get("mlflow.parentRunId") for run in runs)
    assert parents.pop(None) == 1 and list(parents.values()) == [summary["cells"]]
    again = command(*TINY, "tracking=off", "figures=false")
    assert f"{summary['cells']} kept" in again.stdout


@pytest.mark.slow
def test_a_sweep_of_studies(command, tmp_path):
    command("-m", *TINY, "figures=false", "tracking=off", "integrator=tr_bdf2,sdirk2")
    assert len(list(tmp_path.glob("outputs/studies/convergence-*"))) == 2
    assert len(list(tmp_path.glob("outputs/sweeps/*/*/orders.csv"))) == 2
    refused = command("-m", *TINY, "tracking=off", "publish=docs", "seed=1,2", code=2)
    assert "publish = 'docs' is not allowed" in refused.stdout
