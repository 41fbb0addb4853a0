"""A folder that is used again: what is in it belongs to the last run, or to nobody's."""

import json
from pathlib import Path

import pytest
from command_line import begun, interrupted
from records import database_in, runs_in

pytestmark = pytest.mark.processes

SCENE = ("sim=cantilever",)


def artifacts(folder: Path) -> list[set[str]]:
    """The files of each record, the last first."""
    runs, client = runs_in(database_in(folder))
    return [{file.path for file in client.list_artifacts(run.info.run_id)} for run in runs]


def test_a_second_run_has_only_its_own_files(command, database, tmp_path):
    command(*SCENE, "hydra.run.dir=out", "figures=true")
    assert (tmp_path / "out" / "cantilever.png").exists()
    done = command(*SCENE, "hydra.run.dir=out", "figures=false", "sim.load_bar=2")
    assert "png" not in done.stdout and not list((tmp_path / "out").glob("*.png"))
    last, first = artifacts(tmp_path)
    assert "cantilever.png" in first
    assert last == {"config.yaml", "provenance.json", "result.json", "trajectory.npz"}


def test_the_same_run_again_is_another_record(command, database, tmp_path):
    for _ in range(2):
        command(*SCENE, "hydra.run.dir=out", "figures=false")
    assert len(artifacts(tmp_path)) == 2


def test_files_of_others_are_neither_told_nor_recorded_nor_touched(command, database, tmp_path):
    (tmp_path / "secret.txt").write_text("mine")
    done = command(*SCENE, "hydra.run.dir=.", "figures=false")
    assert "secret" not in done.stdout and "mlruns" not in done.stdout.split("tracking")[0]
    (files,) = artifacts(tmp_path)
    assert files == {"config.yaml", "provenance.json", "result.json", "trajectory.npz"}
    assert (tmp_path / "secret.txt").read_text() == "mine"


@pytest.mark.parametrize("name", ["config.yaml", "result.json", "provenance.json"])
def test_a_file_of_somebody_else_is_not_replaced(refusal, tmp_path, name):
    (tmp_path / name).write_text("mine: 1\n")
    assert f"a folder without a {name} of something else" in refusal(*SCENE, "hydra.run.dir=.")
    assert (tmp_path / name).read_text() == "mine: 1\n"


def test_a_refused_run_leaves_the_earlier_one(command, refusal, tmp_path):
    command(*SCENE, "hydra.run.dir=out", "tracking=off")
    before = {file.name: file.read_bytes() for file in (tmp_path / "out").iterdir()}
    refusal(*SCENE, "hydra.run.dir=out", "sim.load_bar=1e9", "tracking=off")
    assert {file.name: file.read_bytes() for file in (tmp_path / "out").iterdir()} == before


def test_two_at_once_are_not(refusal, tmp_path):
    run = ("accuracy=reference", "tracking=off", "hydra.run.dir=out", "figures=false")
    process = begun(tmp_path, *run, until="out/config.yaml")
    assert "hydra.run.dir" in refusal(*run)
    interrupted(process)
    assert json.loads((tmp_path / "out" / "result.json").read_text())["status"] == "interrupted"


def test_a_refused_run_leaves_no_folder_of_the_day(refusal, tmp_path):
    refusal("design.epsilon=9", "tracking=off")
    assert not list((tmp_path / "outputs").iterdir())


def test_paths_are_relative_to_where_the_command_is_run(command, database, tmp_path):
    command(*SCENE, "hydra.job.chdir=true", "figures=false")
    assert len(artifacts(tmp_path)) == 1 and len(list(tmp_path.rglob("*.db"))) == 1
