"""The worked example of the documentation, applied to a copy of the repository and followed."""

import json
import re
import shlex
import shutil
import subprocess
import sys
from math import gamma, pi, sqrt, tan
from pathlib import Path

import numpy as np
import pytest

ROOT = Path(__file__).resolve().parents[2]
PAGE = (ROOT / "docs" / "adding_a_contact_law.md").read_text(encoding="utf-8")
COPIED = ("snapjump", "conf", "tests", "run.py", "pyproject.toml")
FENCE = re.compile(r"^```(\w*)\n(.*?)^```$", re.DOTALL | re.MULTILINE)
# What introduces a block: the last file that is named before it.
FILE = re.compile(r"(New file|At the end of) `([^`]+)`")
EDIT = re.compile(r"--- a/(\S+)\n\+\+\+ b/\1\n(.*?)(?=--- a/|\Z)", re.DOTALL)
# The command line as it is, without the half minute of compiling.
PLAIN = """
import sys
from pathlib import Path
from pytest import MonkeyPatch
sys.path[:0] = [".", "tests/support"]
from plain_march import without_compiling
from snapjump.tasks.command_line import main
without_compiling(MonkeyPatch())
sys.exit(main(Path("conf").resolve()))
"""


def blocks(language: str) -> list[str]:
    """The contents of all blocks of a language; of none, those of the shell."""
    return [content for kind, content in FENCE.findall(PAGE) if kind == language]


def files() -> list[tuple[str, str, str]]:
    """Every whole block: how it gets into which file, and what it says."""
    found = []
    for block in FENCE.finditer(PAGE):
        if block[1] in ("python", "yaml"):
            how, name = FILE.findall(PAGE[: block.start()])[-1]
            found.append((how, name, block[2]))
    return found


def edited(text: str, change: str) -> str:
    """The text after a change in the form of a diff without line numbers."""
    lines = change.splitlines()
    before = "\n".join(line[1:] for line in lines if line[:1] != "+")
    after = "\n".join(line[1:] for line in lines if line[:1] != "-")
    assert text.count(before) == 1, before
    return text.replace(before, after)


@pytest.fixture(scope="module")
def copy(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The repository with the page's files and edits."""
    root = tmp_path_factory.mktemp("repository")
    unneeded = shutil.ignore_patterns("__pycache__", "trained")
    for name in COPIED:
        if (ROOT / name).is_dir():
            shutil.copytree(ROOT / name, root / name, ignore=unneeded)
        else:
            shutil.copy(ROOT / name, root / name)
    for how, name, content in files():
        assert (root / name).exists() == (how == "At the end of"), name
        with (root / name).open("a", encoding="utf-8") as file:
            file.write(content if how == "New file" else f"\n\n{content}")
    for name, change in EDIT.findall("".join(blocks("diff"))):
        path = root / name
        path.write_text(edited(path.read_text(encoding="utf-8"), change), encoding="utf-8")
    return root


def run(root: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
    environment = {"PYTHONPATH": str(root), "HOME": str(root), "OMP_NUM_THREADS": "1"}
    return subprocess.run(
        [sys.executable, *arguments], cwd=root, env=environment, capture_output=True, text=True
    )


def table_row(beginning: str) -> list[float]:
    """The numbers of a row of the page's table: closed form, standard, reference."""
    (row,) = (line for line in PAGE.splitlines() if line.startswith(f"| {beginning}"))
    cells = row.strip("|").split("|")[1:]
    return [float(re.findall(r"\d+\.?\d*", cell)[0]) for cell in cells]


def test_its_numbers_are_those_of_its_command_and_of_the_closed_form(copy: Path) -> None:
    command = blocks("")[0].split()
    assert command[:4] == ["python", "run.py", "sim=bounce", "contact=cone"]
    stiffness = 2.0 / pi * 1e8 * tan(0.8)
    deepest = (1.5 * 7.6e-7 * 10.0**2 / stiffness) ** (1.0 / 3.0)
    in_contact = 2.0 * sqrt(pi) * gamma(4.0 / 3.0) / gamma(5.0 / 6.0) * deepest / 10.0
    expected = [[1e6 * deepest, 1.0, 1e6 * in_contact]]
    for tier, share in (("standard", 1e-3), ("reference", 1e-4)):
        done = run(copy, "-c", PLAIN, *command[2:], f"accuracy={tier}", f"hydra.run.dir={tier}")
        assert done.returncode == 0, done.stderr
        result = json.loads((copy / tier / "result.json").read_text())
        last = {name: array[-1] for name, array in np.load(copy / tier / "trajectory.npz").items()}
        duration = last["time_s"] - last["node_y_m"][0] / last["node_vy_m_s"][0]
        expected.append([-1e6 * result["min_gap_m"], result["restitution"], 1e6 * duration])
        assert expected[-1] == pytest.approx(expected[0], rel=share)
    rows = [table_row(name) for name in ("deepest", "`restitution`", "time in contact")]
    assert np.transpose(rows) == pytest.approx(np.array(expected), rel=1e-4, abs=5.1e-6)


def test_a_bad_value_is_the_line_that_it_shows(copy: Path) -> None:
    (shown,) = (block for block in blocks("") if block.startswith("$"))
    command, line = shown.splitlines()
    done = run(copy, *command.split()[2:])
    assert (done.returncode, done.stderr) == (2, line + "\n")


def test_its_tests_pass(copy: Path) -> None:
    """Its own and those that find the law, the derivative of the force among them."""
    (command,) = (line for line in blocks("")[-1].splitlines() if "pytest" in line)
    done = run(copy, *shlex.split(command)[1:], "-v")
    assert done.returncode == 0, done.stdout
    for name in (
        "test_a_bounce_is_that_of_the_closed_form",
        "test_stiffness_is_the_force_s_total_derivative[cone]",
        "test_force_at_rest_is_the_gradient_of_the_energy[cone]",
        "test_a_file_has_the_fields_and_defaults_of_its_member[contact-cone]",
        "test_every_field_of_every_option_is_listed_here",
    ):
        assert re.search(rf"{re.escape(name)}.* PASSED", done.stdout), name
