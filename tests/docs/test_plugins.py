"""The worked example of plug-ins, followed in an empty folder; and plug-ins of other families."""

import json
import os
import re
import shutil
import subprocess
import sys
from math import gamma, pi, sqrt, tan
from pathlib import Path

import numpy as np
import pytest

ROOT = Path(__file__).resolve().parents[2]
PLUGINS = ROOT / "docs" / "plugins"
PAGE = (ROOT / "docs" / "adding_a_contact_law.md").read_text(encoding="utf-8")
FENCE = re.compile(r"^```(\w*)\n(.*?)^```$", re.DOTALL | re.MULTILINE)
REFUSED = "contact = 'cone' is not allowed"
# The command line as it is, without the time that compiling takes.
PLAIN = f"""
import sys
from pathlib import Path
from pytest import MonkeyPatch
sys.path[:0] = [{str(ROOT / "tests" / "support")!r}]
from plain_march import without_compiling
from snapjump.run.tasks.command_line import main
without_compiling(MonkeyPatch())
sys.exit(main(Path({str(ROOT / "conf")!r})))
"""


def blocks(language: str) -> list[str]:
    """The contents of all blocks of a language; of none, those of the shell."""
    return [content for kind, content in FENCE.findall(PAGE) if kind == language]


@pytest.fixture
def place(tmp_path: Path) -> Path:
    """An empty folder but for the page's two files."""
    folder = tmp_path / "mine" / "contact"
    folder.mkdir(parents=True)
    (folder / "cone.py").write_text(blocks("python")[0], encoding="utf-8")
    (folder / "cone.yaml").write_text(blocks("yaml")[0], encoding="utf-8")
    return tmp_path


def run(place: Path, *arguments: str, **variables: str) -> subprocess.CompletedProcess[str]:
    environment = {**os.environ, "PYTHONPATH": str(ROOT), "OMP_NUM_THREADS": "1", **variables}
    return subprocess.run(
        [sys.executable, *arguments], cwd=place, env=environment, capture_output=True, text=True
    )


def plain(place: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
    return run(place, "-c", PLAIN, *arguments)


def table_row(beginning: str) -> list[float]:
    """The numbers of a row of the page's table: closed form, standard, reference."""
    (row,) = (line for line in PAGE.splitlines() if line.startswith(f"| {beginning}"))
    cells = row.strip("|").split("|")[1:]
    return [float(re.findall(r"\d+\.?\d*", cell)[0]) for cell in cells]


def test_the_page_shows_the_files_and_the_law_is_short() -> None:
    law = (PLUGINS / "contact" / "cone.py").read_text(encoding="utf-8")
    assert blocks("python")[0] == law and len(law.splitlines()) <= 40
    assert blocks("yaml")[0] == (PLUGINS / "contact" / "cone.yaml").read_text(encoding="utf-8")


def test_its_numbers_are_those_of_its_command_and_of_the_closed_form(place: Path) -> None:
    command = blocks("")[0].split()
    assert command[:5] == ["python", "run.py", "plugins=mine", "sim=bounce", "contact=cone"]
    stiffness = 2.0 / pi * 1e8 * tan(0.8)
    deepest = (1.5 * 7.6e-7 * 10.0**2 / stiffness) ** (1.0 / 3.0)
    in_contact = 2.0 * sqrt(pi) * gamma(4.0 / 3.0) / gamma(5.0 / 6.0) * deepest / 10.0
    expected = [[1e6 * deepest, 1.0, 1e6 * in_contact]]
    for tier, share in (("standard", 1e-3), ("reference", 1e-4)):
        done = plain(place, *command[2:], f"accuracy={tier}", f"hydra.run.dir={tier}")
        assert done.returncode == 0, done.stderr
        result = json.loads((place / tier / "result.json").read_text())
        last = {name: array[-1] for name, array in np.load(place / tier / "trajectory.npz").items()}
        duration = last["time_s"] - last["node_y_m"][0] / last["node_vy_m_s"][0]
        expected.append([-1e6 * result["min_gap_m"], result["restitution"], 1e6 * duration])
        assert expected[-1] == pytest.approx(expected[0], rel=share)
    rows = [table_row(name) for name in ("deepest", "`restitution`", "time in contact")]
    assert np.transpose(rows) == pytest.approx(np.array(expected), rel=1e-4, abs=5.1e-6)


def test_errors_are_the_lines_that_it_shows(place: Path) -> None:
    shown = [block.splitlines() for block in blocks("") if block.startswith("$")]
    assert len(shown) == 2
    for command, line in shown:
        done = plain(place, *command.split()[3:])
        assert (done.returncode, done.stderr) == (2, line + "\n")


def test_a_tableau_is_a_plugin_by_itself(tmp_path: Path) -> None:
    text = (ROOT / "snapjump" / "integrator" / "sdirk2.yaml").read_text(encoding="utf-8")
    (tmp_path / "mine" / "integrator").mkdir(parents=True)
    file = tmp_path / "mine" / "integrator" / "own.yaml"
    file.write_text(text.replace("name: sdirk2", "name: own"), encoding="utf-8")
    command = ("plugins=mine", "sim=bounce", "integrator=own", "tracking=off", "figures=false")
    assert plain(tmp_path, *command).returncode == 0
    file.write_text(text.replace("[0.0]", "[0.5]"), encoding="utf-8")
    refused = plain(tmp_path, *command)
    assert refused.returncode == 2 and refused.stderr.startswith("plugins = "), refused.stderr


SWEEP = ("-m", "sim=bounce", "contact=cone", "tracking=off", "figures=false")


def test_workers_of_a_sweep_have_it_and_a_cell_is_known_by_it(place: Path) -> None:
    sweep = (*SWEEP, "plugins=mine", "sim.speed_m_s=5,10", "hydra.sweep.dir=sweep")
    first = plain(place, *sweep)
    assert first.returncode == 0 and first.stdout.count("(kept)") == 0, first.stderr
    assert plain(place, *sweep).stdout.count("(kept)") == 2
    law = place / "mine" / "contact" / "cone.py"
    law.write_text(law.read_text().replace("2.0 / pi", "4.0 / pi"), encoding="utf-8")
    edited = plain(place, *sweep)
    assert edited.returncode == 0 and edited.stdout.count("(kept)") == 0


@pytest.mark.parametrize(
    ("edit", "words"),
    [
        (("def force", "def push"), "Law has no method force(self, gap, approach)"),
        (("gap: Any, approach: Any", "gap: Any"), "Law.force takes gap: gap, approach"),
        (("def law(", "def make("), "a member with the methods law, which Cone lacks"),
        (("class Cone(ContactOptions)", "class Cone"), "one class of options of contact"),
        (("from math import pi, tan", "from math import pie"), "ImportError"),
        (("number(0.8,", "number(0.7,"), "half_angle_rad: 0.7"),
        (("half_angle_rad: float", "angle_rad: float"), "the keys name, modulus_Pa, angle_rad"),
    ],
)
def test_what_is_not_complete_is_one_line(place: Path, edit: tuple[str, str], words: str) -> None:
    law = place / "mine" / "contact" / "cone.py"
    text = law.read_text(encoding="utf-8")
    assert edit[0] in text
    law.write_text(text.replace(*edit), encoding="utf-8")
    done = plain(place, "plugins=mine", "sim=bounce", "contact=cone")
    assert done.returncode == 2 and done.stderr.count("\n") == 1
    assert done.stderr.startswith("plugins = ") and words in done.stderr, done.stderr


@pytest.mark.parametrize(
    ("folder", "file", "words"),
    [
        ("nowhere", None, "a folder of plug-ins"),
        ("mine", "contact/penalty.py", "a name that no contact has yet"),
        ("mine", "ground/mud.py", "a folder named like a group"),
    ],
)
def test_folders_that_are_none(place: Path, folder: str, file: str | None, words: str) -> None:
    if file is not None:
        (place / folder / file).parent.mkdir(exist_ok=True)
        (place / folder / file).write_text("")
    done = plain(place, f"plugins={folder}", "sim=bounce", "contact=cone")
    assert done.returncode == 2 and done.stderr.count("\n") == 1
    assert words in done.stderr, done.stderr


# In one process that has the plug-in, the rest in another that has it not.
KEPT = """
import pickle, sys
import snapjump
from pathlib import Path
from snapjump.composition import with_tier
from snapjump.stepping.fixed import FixedStep
snapjump.load_plugins(sys.argv[1])
Path("simulation").write_bytes(pickle.dumps(with_tier("draft", contact="cone", friction="tanh")))
"""
FOUND = """
import pickle
from pathlib import Path
simulation = pickle.loads(Path("simulation").read_bytes())
print(simulation.contact.name, simulation.friction.law(simulation.robot.scales, 0.3).mu)
"""


MENDED = """
import snapjump
from pathlib import Path
from snapjump.composition import with_tier
law = Path("mine/contact/cone.py")
text = law.read_text()
law.write_text(text.replace("def law(", "def make("))
for change in (text, text.replace("2.0 / pi", "4.0 / pi")):
    try:
        snapjump.load_plugins("mine")
        print(with_tier("draft", contact="cone").contact.name)
    except snapjump.ParameterError as error:
        print(str(error).rpartition(": ")[2].split(",")[0])
    law.write_text(change)
snapjump.load_plugins("mine")
"""


def test_a_mended_law_loads_and_one_that_changes_after_that_is_refused(place: Path) -> None:
    done = run(place, "-c", MENDED)
    assert done.stdout.splitlines() == ["a member with the methods law", "cone"], done.stderr
    assert "files have changed since, which a new process sees" in done.stderr


def test_a_pickle_loads_the_plugin_that_it_needs(tmp_path: Path) -> None:
    kept = run(tmp_path, "-c", KEPT, str(PLUGINS))
    assert kept.returncode == 0, kept.stderr
    assert run(tmp_path, "-c", FOUND).stdout == "cone 0.3\n"


# A dataset and a forward model of jumps on the cone, without a simulation.
MADE = """
import sys
from pathlib import Path
import snapjump
snapjump.load_plugins(sys.argv[1])
from forward_models import about, network
from small_datasets import made_up, small
from snapjump.learning.checkpoint import write_checkpoint
specification = small(8, 8, contact={"name": "cone"})
made_up(Path("dataset"), specification)
told = about()
told["dataset"]["specification"] = specification.plain
write_checkpoint(Path("forward.safetensors"), network(), told)
"""
OPENED = """
import sys
import snapjump
from snapjump.dataset.read import open_dataset
from snapjump.learning.checkpoint import read_checkpoint
if len(sys.argv) > 1:
    snapjump.load_plugins(sys.argv[1])
for opened in (lambda: open_dataset("dataset"), lambda: read_checkpoint("forward.safetensors")):
    try:
        opened()
    except snapjump.ParameterError as error:
        print(error)
"""


def test_what_was_made_with_it_is_refused_without_it(tmp_path: Path) -> None:
    support = f"{ROOT}:{ROOT / 'tests' / 'support'}"
    made = run(tmp_path, "-c", MADE, str(PLUGINS), PYTHONPATH=support)
    assert made.returncode == 0, made.stderr
    lines = run(tmp_path, "-c", OPENED).stdout.splitlines()
    assert len(lines) == 2 and all("contact = 'cone'" in line for line in lines), lines
    assert [line.partition(" = ")[0] for line in lines] == ["dataset.path", "checkpoint"]
    assert run(tmp_path, "-c", OPENED, str(PLUGINS)).stdout == ""


INSTALLED = """
from snapjump.declare.members import member_names
print("cone" in member_names("contact"), "drop" in member_names("sim"))
"""


def test_an_installed_package_offers_its_members(tmp_path: Path) -> None:
    shutil.copytree(PLUGINS, tmp_path / "snapjump_mine")
    for folder in (tmp_path / "snapjump_mine", tmp_path / "snapjump_mine" / "contact"):
        (folder / "__init__.py").touch()
    about = tmp_path / "snapjump_mine-1.0.dist-info"
    about.mkdir()
    (about / "METADATA").write_text("Metadata-Version: 2.1\nName: snapjump-mine\nVersion: 1.0\n")
    (about / "entry_points.txt").write_text("[snapjump.plugins]\nmine = snapjump_mine\n")
    done = run(tmp_path, "-c", INSTALLED, PYTHONPATH=f"{ROOT}:{tmp_path}")
    assert done.stdout == "True True\n", done.stderr


LANES = """
import sys
import numpy as np
import snapjump
from snapjump.batch import simulate_batch, simulate_designs, variants
from snapjump.composition import with_tier
from snapjump.stepping.fixed import FixedStep
snapjump.load_plugins(sys.argv[1])
base = with_tier("draft", contact="cone", friction="tanh")
designs = np.array([[0.1, 0.2, 0.768, 0.3], [0.05, 0.25, 1.2, 0.4], [0.15, 0.15, 0.6, 0.2]])
beside = simulate_batch(variants(base, designs), lanes=8)
alone = snapjump.simulate_jump(accuracy="draft", contact="cone", friction="tanh")
assert beside.status == ["ok"] * 3 and alone.status == "ok"
assert (alone.x_bar, alone.y_bar) == (beside.x_bar[0], beside.y_bar[0])
# A number of the law is an input as any other, and so are derivatives by it: those of the steps
# that are taken, so that differences are of the same steps, which resolve the strike.
base = with_tier("draft", contact="cone", friction="tanh", stepping=FixedStep(step_s=2e-6))
inputs = ("design.delta_alpha", "environment.mass_bar", "contact.modulus_Pa")
designs = np.array([[0.1, 0.768, 2e6], [0.05, 1.2, 5e6], [0.15, 0.6, 1e6]])
found = simulate_designs(base, designs, inputs=inputs, sensitivities=True, threads=1)
for column in (1, 2):
    step = 1e-5 * designs * np.eye(3)[column]
    ends = (designs + step, designs - step)
    more, less = (simulate_designs(base, end, inputs=inputs, threads=1) for end in ends)
    slope = (more.y_bar - less.y_bar) / (2.0 * step[:, column])
    np.testing.assert_allclose(found.sensitivities.dy_bar[:, column], slope, rtol=0.02)
"""


@pytest.mark.compiles
def test_in_python_in_lanes_and_with_sensitivities(tmp_path: Path) -> None:
    done = run(tmp_path, "-c", LANES, str(PLUGINS))
    assert done.returncode == 0, done.stderr


@pytest.mark.compiles
def test_parallel_workers_have_it(place: Path) -> None:
    apart = ("plugins=mine", "sim.speed_m_s=5,10", "hydra/launcher=joblib", "hydra.sweep.dir=out")
    done = run(place, str(ROOT / "run.py"), *SWEEP, *apart)
    assert done.returncode == 0 and "2 cells: 2 ok" in done.stdout, done.stderr


@pytest.mark.compiles
def test_an_edited_law_is_another_program(place: Path) -> None:
    command = [str(ROOT / "run.py"), "plugins=mine", *SWEEP[1:], "hydra.run.dir=out"]
    gaps = []
    for factor in ("2.0", "4.0", "2.0"):
        law = place / "mine" / "contact" / "cone.py"
        law.write_text(blocks("python")[0].replace("2.0 / pi", f"{factor} / pi"), encoding="utf-8")
        done = run(place, *command)
        assert done.returncode == 0, done.stderr
        gaps.append(json.loads((place / "out" / "result.json").read_text())["min_gap_m"])
    assert gaps[0] == gaps[2]
    assert gaps[1] / gaps[0] == pytest.approx(2.0 ** (-1.0 / 3.0), rel=1e-2)
    assert REFUSED in run(place, *command[:1], *SWEEP[1:]).stderr


@pytest.mark.compiles
@pytest.mark.parametrize(
    "choice",
    [
        ("sim=drop", "contact=cone"),
        ("sim=slide", "friction=tanh"),
        ("sim=snap", "integrator=theta", "stepping=fixed", "stepping.step_s=1e-5"),
    ],
)
def test_other_families(choice: tuple[str, ...], tmp_path: Path) -> None:
    switches = (f"plugins={PLUGINS}", "tracking=off", "figures=false", "hydra.run.dir=out")
    done = run(tmp_path, str(ROOT / "run.py"), *choice, *switches)
    assert done.returncode == 0, done.stderr
    result = json.loads((tmp_path / "out" / "result.json").read_text())
    if choice[0] == "sim=drop":
        assert result["highest_rebound_m"] == pytest.approx(0.01, rel=1e-3)
    elif choice[0] == "sim=slide":
        # v^2 / (2 mu g), and what smoothing below v0 lets it slide on.
        assert result["distance_m"] == pytest.approx(0.1**2 / (2.0 * 0.3 * 10.0), rel=0.05)
    else:
        assert result["alpha_snap_rad"] == pytest.approx(0.9109, abs=5e-4)


@pytest.mark.compiles
def test_the_composition_tests_take_them_in(tmp_path: Path) -> None:
    """Ranges, derivatives and small jumps with every other member."""
    chosen = [
        "tests/contact/test_laws.py",
        "tests/declare/test_options.py",
        "tests/test_composition.py",
    ]
    fast = ["-m", "not slow and not compiles", "-q", "-p", "no:cacheprovider", "-n", "2"]
    done = run(
        ROOT, "-m", "pytest", *chosen, *fast, "-k", "cone or tanh or theta",
        SNAPJUMP_PLUGINS=str(PLUGINS),
    )  # fmt: skip
    assert done.returncode == 0, done.stdout[-3000:]
    assert int(re.findall(r"(\d+) passed", done.stdout)[0]) > 40
