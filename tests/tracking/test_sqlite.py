"""Records in a database file: a sweep on a fresh one, a restart and failures."""

import json
from pathlib import Path

from .conftest import JUMP, LAGS, SWEEP, TWO_AT_A_TIME


def uri_in(folder: Path) -> str:
    return f"sqlite:///{folder / 'mlruns.db'}"


def results(folder: Path) -> dict[Path, int]:
    """Result files of all cells, with the time each was written (ns)."""
    return {path: path.stat().st_mtime_ns for path in folder.glob("outputs/sweeps/*/*/result.json")}


def test_a_sweep_on_a_fresh_file_and_its_restart(command, process, check_sweep, tmp_path):
    done = process(*SWEEP, *TWO_AT_A_TIME)
    assert done.returncode == 0, done.stderr + done.stdout
    check_sweep(uri_in(tmp_path), tmp_path)
    before = results(tmp_path)
    again = command(*SWEEP)
    assert again.returncode == 0, again.stderr
    assert again.stdout.count("(kept)") == len(LAGS)
    assert results(tmp_path) == before
    # The same parent, and no second record of any cell.
    check_sweep(uri_in(tmp_path), tmp_path)


def test_a_restart_does_what_is_missing_and_each_cell_keeps_its_record(
    command, database, runs_of, tmp_path
):
    sweep = ("-m", *JUMP, "design.delta_alpha=0.02,0.05,0.1")
    assert command(*sweep).returncode == 0
    before = results(tmp_path)
    lost, changed, kept = sorted(before)
    lost.unlink()
    changed.write_text(json.dumps({"status": "interrupted"}))
    again = command(*sweep)
    assert again.returncode == 0
    assert again.stdout.count("(kept)") == 1
    after = results(tmp_path)
    assert {path for path in before if after[path] != before[path]} == {lost, changed}
    parents, children, _ = runs_of(uri_in(tmp_path))
    assert len(parents) == 1
    assert [run.data.tags["status"] for run in children] == ["ok"] * 3


def test_a_failed_cell_does_not_stop_the_others(command, database, runs_of, tmp_path):
    # A barrier too thin for any step, the usual one, and one that is not allowed.
    distances = ("1e-09", "0.0005", "-1")
    done = command("-m", *JUMP, f"contact.distance_m={','.join(distances)}")
    assert done.returncode == 3
    rows = [line.split() for line in done.stdout.splitlines()]
    statuses = {row[0]: row[1] for row in rows if row and row[0] in distances}
    assert statuses == {"1e-09": "step_underflow", "0.0005": "ok", "-1": "bad_input"}
    (parent,), children, _ = runs_of(uri_in(tmp_path))
    assert parent.info.status == "FAILED"
    recorded = {run.data.tags["status"]: run.info.status for run in children}
    assert recorded == {"ok": "FINISHED", "bad_input": "FAILED", "step_underflow": "FAILED"}


def test_bad_input_in_a_cell_and_of_a_sweep(command):
    done = command("-m", *JUMP, "tracking=off", "design.epsilon=0.2,0.9")
    assert done.returncode == 2
    assert "design.epsilon = 0.9 is not allowed" in done.stdout
    done = command("-m", "tracking=off", "contact=logbarrier,foo")
    assert done.returncode == 2
    assert done.stderr.startswith("contact = 'foo' is not allowed") and done.stderr.count("\n") == 1


def test_jumps_on_an_existing_database_are_runs_of_their_own(command, database, runs_of, tmp_path):
    for tracking in ("sqlite", "off", "sqlite", "off", "sqlite"):
        assert command(*JUMP, f"tracking={tracking}").returncode == 0
    runs, children, _ = runs_of(uri_in(tmp_path))
    assert len(runs) == 3 and not children
    assert not (tmp_path / "mlruns").exists()
