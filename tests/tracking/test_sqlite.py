"""Records in a database file: a sweep on a fresh one, a restart, failures, and what it costs."""

import json
import time
from pathlib import Path

from .conftest import LAGS, SWEEP, TWO_AT_A_TIME

JUMP = ("sim=jump", "accuracy=draft", "figures=false")


def uri_in(folder: Path) -> str:
    return f"sqlite:///{folder / 'mlruns.db'}"


def results(folder: Path) -> dict[Path, int]:
    """Result files of all cells, with the time each was written (ns)."""
    return {path: path.stat().st_mtime_ns for path in folder.glob("outputs/sweeps/*/*/result.json")}


def test_a_sweep_on_a_fresh_file_and_its_restart(
    command, check_sweep, runs_of, tmp_path: Path
) -> None:
    done = command(*SWEEP, *TWO_AT_A_TIME)
    assert done.returncode == 0, done.stderr + done.stdout
    check_sweep(uri_in(tmp_path), tmp_path)
    before = results(tmp_path)
    again = command(*SWEEP)
    assert again.returncode == 0, again.stderr
    assert again.stdout.count("(kept)") == len(LAGS)
    assert results(tmp_path) == before
    # The same parent, and no second record of any cell.
    check_sweep(uri_in(tmp_path), tmp_path)


def test_a_restart_does_what_is_missing(command, tmp_path: Path) -> None:
    assert command(*SWEEP, "tracking=off").returncode == 0
    before = results(tmp_path)
    lost, changed = sorted(before)[:2]
    lost.unlink()
    changed.write_text(json.dumps({"status": "interrupted"}))
    again = command(*SWEEP, "tracking=off")
    assert again.returncode == 0
    assert again.stdout.count("(kept)") == len(LAGS) - 2
    after = results(tmp_path)
    assert {path for path in before if after[path] != before[path]} == {lost, changed}


def test_a_failed_cell_does_not_stop_the_others(command, runs_of, tmp_path: Path) -> None:
    limits = ("1e-4", "0.2", "-1")
    done = command("-m", *JUMP, f"sim.time_limit_s={','.join(limits)}")
    assert done.returncode == 3
    table = {
        line.split()[0]: line
        for line in done.stdout.splitlines()
        if line[:1].isdigit() or line[:1] == "-"
    }
    statuses = {limit: table[limit].split()[1] for limit in limits}
    assert statuses["0.2"] == "ok" and statuses["-1"] == "bad_input"
    assert statuses["1e-4"] not in ("ok", "no_jump", "bad_input", "error")
    (parent,), children, _ = runs_of(uri_in(tmp_path))
    assert parent.info.status == "FAILED"
    recorded = {run.data.tags["status"]: run.info.status for run in children}
    assert recorded == {
        "ok": "FINISHED",
        "bad_input": "FAILED",
        statuses["1e-4"]: "FAILED",
    }


def test_a_cell_that_is_done_again_keeps_its_record(command, runs_of, tmp_path: Path) -> None:
    sweep = ("-m", *JUMP, "design.delta_alpha=0.05,0.1")
    assert command(*sweep).returncode == 0
    first = sorted(results(tmp_path))[0]
    first.write_text(json.dumps({"status": "interrupted"}))
    assert command(*sweep).returncode == 0
    parents, children, _ = runs_of(uri_in(tmp_path))
    assert len(parents) == 1
    assert [run.data.tags["status"] for run in children] == ["ok", "ok"]


def test_bad_input_in_a_cell_gives_exit_code_2(command, tmp_path: Path) -> None:
    done = command("-m", *JUMP, "tracking=off", "design.epsilon=0.2,0.9")
    assert done.returncode == 2
    assert "design.epsilon = 0.9 is not allowed" in done.stdout


def test_bad_input_of_a_sweep_is_one_line(command) -> None:
    done = command("-m", "tracking=off", "contact=logbarrier,foo")
    assert done.returncode == 2
    assert done.stderr.startswith("contact = 'foo' is not allowed") and done.stderr.count("\n") == 1


def test_one_jump_on_an_existing_database_is_recorded_in_three_seconds(
    command, runs_of, tmp_path: Path
) -> None:
    assert command(*JUMP).returncode == 0
    untracked, tracked = [], []
    for times, tracking in [(untracked, "off"), (tracked, "sqlite")] * 2:
        started = time.monotonic()
        assert command(*JUMP, f"tracking={tracking}").returncode == 0
        times.append(time.monotonic() - started)
    assert min(tracked) - min(untracked) < 3.0
    runs, children, _ = runs_of(uri_in(tmp_path))
    assert len(runs) == 3 and not children
    assert not (tmp_path / "mlruns").exists()
