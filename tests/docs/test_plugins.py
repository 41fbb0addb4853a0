"""The worked example of plug-ins, followed in an empty folder."""

import json
import re
from functools import partial
from math import gamma, pi, sqrt, tan
from pathlib import Path

import numpy as np
import pytest
from command_line import ROOT, RUN, Done, python
from pages import LAW_PAGE, blocks, text_of

pytestmark = pytest.mark.processes

PLUGINS = ROOT / "docs" / "plugins"
SUPPORT = ROOT / "tests" / "support"
LAW, OPTIONS = (blocks(LAW_PAGE, language)[0] for language in ("python", "yaml"))
SHELL = blocks(LAW_PAGE, "")
OFF = ("tracking=off", "figures=false")
REFUSED = "contact = 'cone' is not allowed"
# The command line as it is, without the time that compiling takes.
PLAIN = f"""
import sys
from pathlib import Path
from pytest import MonkeyPatch
sys.path[:0] = [{str(SUPPORT)!r}]
from plain_march import without_compiling
from snapjump.run.tasks.command_line import main
without_compiling(MonkeyPatch())
sys.exit(main())
"""


@pytest.fixture
def example(tmp_path: Path) -> Path:
    """An empty folder but for the page's two files."""
    folder = tmp_path / "mine" / "contact"
    folder.mkdir(parents=True)
    (folder / "cone.py").write_text(LAW, encoding="utf-8")
    (folder / "cone.yaml").write_text(OPTIONS, encoding="utf-8")
    return tmp_path


def edit_law(folder: Path, old: str, new: str) -> None:
    law = folder / "mine" / "contact" / "cone.py"
    text = law.read_text(encoding="utf-8")
    assert old in text
    law.write_text(text.replace(old, new), encoding="utf-8")


run = partial(python, OMP_NUM_THREADS="1")


def plain(folder: Path, *arguments: str, code: int = 0) -> Done:
    return run("-c", PLAIN, *arguments, folder=folder, code=code)


def refused(folder: Path, *arguments: str) -> str:
    """The one line by which the command is refused."""
    done = plain(folder, *arguments, code=2)
    assert done.stderr.count("\n") == 1
    return str(done.stderr)


def table_row(beginning: str) -> list[float]:
    """The numbers of a row of the page's table: closed form, standard, reference."""
    (row,) = (line for line in LAW_PAGE.splitlines() if line.startswith(f"| {beginning}"))
    cells = row.strip("|").split("|")[1:]
    return [float(re.findall(r"\d+\.?\d*", cell)[0]) for cell in cells]


def test_the_page_shows_the_files_and_the_law_is_short() -> None:
    assert text_of(PLUGINS / "contact" / "cone.py") == LAW and len(LAW.splitlines()) <= 40
    assert text_of(PLUGINS / "contact" / "cone.yaml") == OPTIONS


def test_its_numbers_are_those_of_its_command_and_of_the_closed_form(example: Path) -> None:
    command = SHELL[0].split()
    assert command[:5] == ["python", "run.py", "plugins=mine", "sim=bounce", "contact=cone"]
    stiffness = 2.0 / pi * 1e8 * tan(0.8)
    deepest = (1.5 * 7.6e-7 * 10.0**2 / stiffness) ** (1.0 / 3.0)
    in_contact = 2.0 * sqrt(pi) * gamma(4.0 / 3.0) / gamma(5.0 / 6.0) * deepest / 10.0
    expected = [[1e6 * deepest, 1.0, 1e6 * in_contact]]
    for tier, share in (("standard", 1e-3), ("reference", 1e-4)):
        plain(example, *command[2:], f"accuracy={tier}", f"hydra.run.dir={tier}")
        result = json.loads((example / tier / "result.json").read_text())
        last = {
            name: array[-1] for name, array in np.load(example / tier / "trajectory.npz").items()
        }
        duration = last["time_s"] - last["node_y_m"][0] / last["node_vy_m_s"][0]
        expected.append([-1e6 * result["min_gap_m"], result["restitution"], 1e6 * duration])
        assert expected[-1] == pytest.approx(expected[0], rel=share)
    rows = [table_row(name) for name in ("deepest", "`restitution`", "time in contact")]
    assert np.transpose(rows) == pytest.approx(np.array(expected), rel=1e-4, abs=5.1e-6)


def test_errors_are_the_lines_that_it_shows(example: Path) -> None:
    shown = [block.splitlines() for block in SHELL if block.startswith("$")]
    assert len(shown) == 2
    for command, line in shown:
        assert refused(example, *command.split()[3:]) == line + "\n"


def test_a_tableau_is_a_plugin_by_itself(tmp_path: Path) -> None:
    text = text_of("snapjump/integrator/sdirk2.yaml")
    (tmp_path / "mine" / "integrator").mkdir(parents=True)
    file = tmp_path / "mine" / "integrator" / "own.yaml"
    file.write_text(text.replace("name: sdirk2", "name: own"), encoding="utf-8")
    command = ("plugins=mine", "sim=bounce", "integrator=own", *OFF)
    plain(tmp_path, *command)
    file.write_text(text.replace("[0.0]", "[0.5]"), encoding="utf-8")
    assert plain(tmp_path, *command, code=2).stderr.startswith("plugins = ")


SWEEP = ("-m", "sim=bounce", "contact=cone", *OFF)


def test_workers_of_a_sweep_have_it_and_a_cell_is_known_by_it(example: Path) -> None:
    sweep = (*SWEEP, "plugins=mine", "sim.speed_m_s=5,10", "hydra.sweep.dir=sweep")
    kept = [plain(example, *sweep).stdout.count("(kept)") for _ in range(2)]
    assert kept == [0, 2]
    edit_law(example, "2.0 / pi", "4.0 / pi")
    assert plain(example, *sweep).stdout.count("(kept)") == 0


@pytest.mark.parametrize(
    ("edit", "words"),
    [
        (("def force", "def push"), "Law has no method force(self, gap, state)"),
        (("gap: Any, state: Any", "gap: Any"), "Law.force takes gap: gap, state"),
        (("def law(", "def make("), "a member with the methods law, which Cone lacks"),
        (("class Cone(ContactOptions)", "class Cone"), "one class of options of contact"),
        (("from math import pi, tan", "from math import pie"), "ImportError"),
        (("number(0.8,", "number(0.7,"), "half_angle_rad: 0.7"),
        (("half_angle_rad: float", "angle_rad: float"), "the keys name, modulus_Pa, angle_rad"),
    ],
)
def test_what_is_not_complete_is_one_line(example: Path, edit: tuple[str, str], words: str) -> None:
    edit_law(example, *edit)
    line = refused(example, "plugins=mine", "sim=bounce", "contact=cone")
    assert line.startswith("plugins = ") and words in line


@pytest.mark.parametrize(
    ("folder", "file", "words"),
    [
        ("nowhere", None, "a folder of plug-ins"),
        ("mine", "contact/penalty.py", "a name that no contact has yet"),
        ("mine", "ground/mud.py", "a folder named like a group"),
    ],
)
def test_folders_that_are_none(example: Path, folder: str, file: str | None, words: str) -> None:
    if file is not None:
        (example / folder / file).parent.mkdir(exist_ok=True)
        (example / folder / file).write_text("")
    assert words in refused(example, f"plugins={folder}", "sim=bounce", "contact=cone")


@pytest.mark.slow
def test_parallel_workers_have_it(example: Path) -> None:
    apart = ("plugins=mine", "sim.speed_m_s=5,10", "hydra/launcher=joblib", "hydra.sweep.dir=out")
    done = run(str(RUN), *SWEEP, *apart, folder=example)
    assert "2 cells: 2 ok" in done.stdout, done.stderr


def test_an_edited_law_is_another_program(example: Path) -> None:
    gaps = []
    for before, factor in (("2.0", "2.0"), ("2.0", "4.0"), ("4.0", "2.0")):
        edit_law(example, f"{before} / pi", f"{factor} / pi")
        run(str(RUN), "plugins=mine", *SWEEP[1:], "hydra.run.dir=out", folder=example)
        gaps.append(json.loads((example / "out" / "result.json").read_text())["min_gap_m"])
    assert gaps[0] == gaps[2]
    assert gaps[1] / gaps[0] == pytest.approx(2.0 ** (-1.0 / 3.0), rel=1e-2)
    assert REFUSED in run(str(RUN), *SWEEP[1:], folder=example, code=2).stderr
