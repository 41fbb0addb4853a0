"""``python run.py``: help page, bad input in one line, what a run leaves and what it imports."""

import errno
import json
import subprocess
import sys

import numpy as np
import pytest
from command_line import ROOT, RUN, result_in

HEAVY = {"mlflow", "torch", "pytorch_lightning", "pandas", "matplotlib.pyplot"}
JUMP = ("sim=jump", "contact=logbarrier", "accuracy=draft", "figures=false")


@pytest.mark.parametrize(
    ("argument", "names"),
    [
        # What Hydra would complain about in several lines.
        ("contact=foo", ["contact = 'foo'", "logbarrier", "none"]),
        ("design.foo=1", ["design.foo = '1'", "epsilon", "delta_alpha"]),
        ("desing.epsilon=0.1", ["desing = '0.1'", "did you mean design?"]),
        ("mu=0.5", ["mu = '0.5'", "did you mean environment.mu?"]),
        ("design.mu=0.5", ["did you mean environment.mu?", "design has epsilon"]),
        ("thickness=1e-4", ["did you mean robot.thickness_m?"]),
        ("target=3,12", ["target = '3,12'", "a list [3,12]", "--multirun"]),
        ("contct=none", ["contct = 'none'", "did you mean contact?"]),
        ("design.epsilon=0.1,0.2", ["design.epsilon = '0.1,0.2'", "--multirun"]),
        ("design.epsilon=[1", ["design.epsilon=[1", "key=value"]),
        ("design.epsilon", ["'design.epsilon'", "key=value"]),
        ("design.epsilon=${nope}", ["design.epsilon", "nope"]),
        ("hydra/launcher=foo", ["hydra/launcher = 'foo'", "joblib"]),
        ("accuracy=null", ["accuracy=null"]),
        ("--foo", ["--foo", "--help"]),
        ("~sim", ["sim = None"]),
        ("design=3", ["design = 3"]),
        ("+foo=1", ["foo = 1"]),
        # What only the library can know.
        ("+design.foo=1", ["design.foo = 1", "epsilon"]),
        ("+contact.foo=1", ["contact.foo = 1", "stiffness_N_m"]),
        ("~design.epsilon", ["design.epsilon"]),
        ("+checkpoint=/etc/passwd", ["checkpoint = '/etc/passwd'", "task=simulate reads"]),
        ("+dataset.path=/etc", ["dataset = ", "left out"]),
        ("+executor=dask", ["executor = ", "left out"]),
        ("+accuracy.promise_percent=1e9", ["accuracy.promise_percent", "accuracy has name"]),
        ("+task.steps=12", ["task.steps = 12", "task=simulate has no keys"]),
        ("integrator.name=tr_bdf", ["integrator.name = 'tr_bdf'", "integrator=<name>"]),
        ("design=[0.2,0.1]", ["design = '[0.2,0.1]'", "design.<key>=..."]),
        ("environment.mu=1e308", ["environment.mu = 1e+308", "[0, 100]"]),
        ("~tracking", ["tracking = None"]),
        ("~task.name", ["task.name"]),
        ("~accuracy.name", ["accuracy"]),
        (f"tracking.path={'x' * 300}", ["tracking.path", "too long"]),
        (f"{'k' * 5000}=1", ["kkk"]),
        ("linear_solver=banded", ["linear_solver = 'banded'", "one linear solver"]),
        ("sim.incline=0.1", ["sim.incline = '0.1'", "environment.slope_rad"]),
        ("design.epsilon=0", ["design.epsilon = 0", "0.4]"]),
        ("design.epsilon=0.41", ["design.epsilon = 0.41", "0.4]"]),
        ("design.epsilon=nan", ["design.epsilon = nan", "0.4]"]),
        ("design.epsilon=much", ["design.epsilon = 'much'", "0.4]"]),
        ("design.epsilon=null", ["design.epsilon = None", "0.4]"]),
        ("robot.length_m=0", ["robot.length_m = 0", "[1e-15"]),
        ("robot.mount_height=-0.001", ["robot.mount_height = -0.001"]),
        ("robot.mount_height=high", ["robot.mount_height = 'high'", "optimal"]),
        ("environment.mass_bar=0.001", ["environment.mass_bar = 0.001", "beam"]),
        ("environment.mu=-0.1", ["environment.mu = -0.1"]),
        ("stepping.tolerance=0", ["stepping.tolerance = 0"]),
        ("stepping={tolerance: -1}", ["stepping.tolerance = -1"]),
        ("contact.name=foo", ["contact", "'foo'", "logbarrier"]),
        ("discretization.elements=2.5", ["discretization.elements = 2.5"]),
        ("tracking.path=''", ["tracking.path = ''"]),
        ("hydra.run.dir=/proc/nowhere", ["/proc/nowhere"]),
    ],
)
def test_bad_input_is_one_line_and_leaves_nothing(refusal, tmp_path, capfd, argument, names):
    line = refusal(argument)
    for name in names:
        assert name in line
    assert capfd.readouterr() == ("", "")
    assert not [path for path in tmp_path.rglob("*") if path.is_file()]


def test_bad_input_is_found_before_anything_is_compiled(process):
    done = process("design.epsilon=0.9", "tracking=off", options=("-X", "importtime"), code=2)
    assert "design.epsilon = 0.9 is not allowed" in done.stderr.splitlines()[-1]
    assert "compiling" not in done.stderr + done.stdout


def test_the_help_page_tells_every_group_and_member(command):
    page = command("--help").stdout
    for member in (ROOT / "conf").glob("*/*.yaml"):
        assert f"  {member.parent.name}: " in page
        assert f" {member.stem} " in page
    assert page.count("python run.py") >= 4
    assert "design.epsilon=0.2" in page and "(0, 0.4]" in page
    assert max(len(line) for line in page.splitlines()) <= 120


def imported(process, *arguments):
    """Modules that the command imports."""
    done = process(*arguments, options=("-X", "importtime"))
    return {line.split("|")[-1].strip() for line in done.stderr.splitlines() if "|" in line}


def test_heavy_libraries_stay_out_of_what_does_not_need_them(process):
    # Not by the clock: these are what takes a program long to begin.
    assert not imported(process, "--help") & {"numba", "hydra", "scipy", *HEAVY}
    names = imported(process, *JUMP, "tracking=off")
    assert "snapjump.simulation" in names
    assert not names & HEAVY


def test_what_a_run_leaves(command, tmp_path):
    done = command(*JUMP, "tracking=off", "design.epsilon=0.25")
    folder, result = result_in(tmp_path)
    assert result["status"] == "ok"
    for key in (
        "x_bar", "y_bar", "apex_time_s", "liftoff_time_s", "liftoff_vx_m_s", "liftoff_vy_m_s",
        "steps", "newton_iterations", "min_gap_m", "max_residual", "kernel_seconds", "wall_seconds",
    ):  # fmt: skip
        assert isinstance(result[key], (int, float)), key
    text = (folder / "config.yaml").read_text()
    assert "epsilon: 0.25" in text and "${" not in text
    origin = json.loads((folder / "provenance.json").read_text())
    assert origin["command"].startswith("python run.py sim=jump contact=logbarrier")
    with np.load(folder / "trajectory.npz", allow_pickle=False) as arrays:
        assert all(np.isfinite(arrays[name]).all() for name in arrays)
    assert not [path for path in folder.iterdir() if path.name.startswith(".")]
    for word in ("epsilon 0.25", "apex", " L (", "mm", "lift-off", "draft", "Newton", "outputs/"):
        assert word in done.stdout


@pytest.mark.processes
def test_two_runs_never_share_a_folder(tmp_path):
    arguments = [sys.executable, str(RUN), *JUMP, "tracking=off"]
    both = [subprocess.Popen(arguments, cwd=tmp_path) for _ in range(2)]
    assert [process.wait(300) for process in both] == [0, 0]
    assert len(list(tmp_path.glob("outputs/*/*/result.json"))) == 2


def test_a_simulation_that_cannot_finish_says_so(command, tmp_path):
    done = command(*JUMP, "tracking=off", "contact.distance_m=1e-9", code=3)
    _, result = result_in(tmp_path)
    assert result["status"] == "step_underflow"
    assert " ms after the start" in result["message"]
    assert result["x_bar"] is None
    assert done.stderr.splitlines()[-1] == f"{result['status']}: {result['message']}"


def test_a_beam_that_does_not_snap_says_so(command, tmp_path):
    command("sim=snap", "accuracy=draft", "sim.duration_s=0.001", "tracking=off", code=3)
    folder, result = result_in(tmp_path)
    assert result["status"] == "no_snap" and " ms after the start" in result["message"]
    assert result["snap_time_s"] is None and result["theta_max_rad"] > 0.0
    assert (folder / "snap.png").exists()


def test_an_arch_that_stays_stable_says_so(command, tmp_path):
    design = ("design.epsilon=0.006", "design.delta_alpha=-0.4")
    done = command("sim=static", "accuracy=draft", "tracking=off", *design, code=3)
    folder, result = result_in(tmp_path)
    assert result["status"] == "no_snap" and result["alpha_critical_rad"] is None
    assert done.stderr.splitlines()[-1] == f"no_snap: {result['message']}"
    assert not (folder / "traceback.txt").exists()


def test_a_robot_that_does_not_jump_is_no_failure(command, tmp_path):
    done = command(*JUMP, "tracking=off", "environment.mass_bar=200")
    _, result = result_in(tmp_path)
    assert result["status"] == "no_jump" and result["liftoff_time_s"] is None
    assert "no_jump" in done.stdout


def test_a_disk_that_is_full_keeps_the_numbers(command, tmp_path, monkeypatch):
    def full(*given, **named):
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(np, "savez_compressed", full)
    done = command(*JUMP, "tracking=off", code=1)
    _, result = result_in(tmp_path)
    assert result["status"] == "error" and result["x_bar"] == pytest.approx(5.38, abs=0.05)
    assert result["message"] == "No space left on device: the trajectory is not kept"
    assert "apex" in done.stdout and "Traceback" not in done.stderr


def test_an_error_that_is_not_known_is_no_failure(command, tmp_path):
    done = command(*JUMP, "tracking=off", "sim.start_fraction=0.5")
    _, result = result_in(tmp_path)
    assert result["status"] == "ok" and result["x_bar"] > 1.0
    assert result["error_estimate_percent"] is None and result["within_tier"] is None
    assert "not known here" in done.stdout


def test_help_on_a_member_has_its_keys(command, refusal):
    told = command("--help", "task=train", "contact=penalty").stdout
    assert told.startswith("task=train\n# A forward model") and "@package" not in told
    assert "patience: 60" in told and "contact=penalty\n" in told and "N/m" in told
    assert "--help = 'contact=nope'" in refusal("--help", "contact=nope")
