"""Plug-ins in processes that have them and in others that have not, and members of all families."""

import json
import re
import shutil
from functools import partial
from pathlib import Path
from typing import Any

import pytest
from command_line import ROOT, RUN, python

PLUGINS = ROOT / "docs" / "plugins"


def slow(*choice: str) -> Any:
    return pytest.param(choice, marks=pytest.mark.slow)


run = partial(python, OMP_NUM_THREADS="1")

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


@pytest.mark.processes
def test_a_mended_law_loads_and_one_that_changes_after_that_is_refused(tmp_path: Path) -> None:
    shutil.copytree(PLUGINS, tmp_path / "mine")
    done = run("-c", MENDED, folder=tmp_path, code=1)
    assert done.stdout.splitlines() == ["a member with the methods law", "cone"], done.stderr
    assert "files have changed since, which a new process sees" in done.stderr


@pytest.mark.processes
def test_a_pickle_loads_the_plugin_that_it_needs(tmp_path: Path) -> None:
    run("-c", KEPT, str(PLUGINS), folder=tmp_path)
    assert run("-c", FOUND, folder=tmp_path).stdout == "cone 0.3\n"


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
from snapjump.dataset.read import load_dataset
from snapjump.learning.checkpoint import read_checkpoint
if len(sys.argv) > 1:
    snapjump.load_plugins(sys.argv[1])
for opened in (lambda: load_dataset("dataset"), lambda: read_checkpoint("forward.safetensors")):
    try:
        opened()
    except snapjump.ParameterError as error:
        print(error)
"""


@pytest.mark.processes
def test_what_was_made_with_it_is_refused_without_it(tmp_path: Path) -> None:
    run(
        "-c", MADE, str(PLUGINS), folder=tmp_path, PYTHONPATH=f"{ROOT}:{ROOT / 'tests' / 'support'}"
    )
    lines = run("-c", OPENED, folder=tmp_path).stdout.splitlines()
    assert len(lines) == 2 and all("contact = 'cone'" in line for line in lines), lines
    assert [line.partition(" = ")[0] for line in lines] == ["dataset.path", "checkpoint"]
    assert run("-c", OPENED, str(PLUGINS), folder=tmp_path).stdout == ""


INSTALLED = """
from snapjump.declare.members import member_names
print("cone" in member_names("contact"), "drop" in member_names("sim"))
"""


@pytest.mark.processes
def test_an_installed_package_offers_its_members(tmp_path: Path) -> None:
    shutil.copytree(PLUGINS, tmp_path / "snapjump_mine")
    for folder in (tmp_path / "snapjump_mine", tmp_path / "snapjump_mine" / "contact"):
        (folder / "__init__.py").touch()
    about = tmp_path / "snapjump_mine-1.0.dist-info"
    about.mkdir()
    (about / "METADATA").write_text("Metadata-Version: 2.1\nName: snapjump-mine\nVersion: 1.0\n")
    (about / "entry_points.txt").write_text("[snapjump.plugins]\nmine = snapjump_mine\n")
    done = run("-c", INSTALLED, folder=tmp_path, PYTHONPATH=f"{ROOT}:{tmp_path}")
    assert done.stdout == "True True\n", done.stderr


LANES = """
import sys
import numpy as np
import snapjump
from snapjump.batch import simulate_designs
from snapjump.composition import with_tier
snapjump.load_plugins(sys.argv[1])
base = with_tier("draft", contact="cone", friction="tanh")
designs = np.array([[0.1, 0.2, 0.768, 0.3], [0.05, 0.25, 1.2, 0.4], [0.15, 0.15, 0.6, 0.2]])
beside = simulate_designs(base, designs, lanes=8, threads=1)
alone = simulate_designs(base, designs[:1], lanes=1)
assert beside.status == ["ok"] * 3 and alone.status == ["ok"]
assert (alone.x_bar[0], alone.y_bar[0]) == (beside.x_bar[0], beside.y_bar[0])
"""

SLOPES = """
import sys
import numpy as np
import snapjump
from snapjump.batch import simulate_designs
from snapjump.composition import with_tier
from snapjump.stepping.fixed import FixedStep
snapjump.load_plugins(sys.argv[1])
# Steps that resolve the strike: at four times the step, what Newton's method leaves moves
# derivatives by 5 %.
base = with_tier("draft", contact="cone", friction="tanh", stepping=FixedStep(step_s=5e-7))
# A number of the law is an input as any other, and so are derivatives by it: those of the steps
# that are taken, so that differences are of the same steps.
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
def test_in_python_and_in_lanes(tmp_path: Path) -> None:
    run("-c", LANES, str(PLUGINS), folder=tmp_path)


@pytest.mark.slow
def test_with_sensitivities(tmp_path: Path) -> None:
    run("-c", SLOPES, str(PLUGINS), folder=tmp_path)


@pytest.mark.compiles
@pytest.mark.parametrize(
    "choice",
    [
        ("sim=drop", "contact=cone"),
        slow("sim=slide", "friction=tanh"),
        slow("sim=snap", "integrator=theta", "stepping=fixed", "stepping.step_s=1e-5"),
    ],
)
def test_other_families(choice: tuple[str, ...], tmp_path: Path) -> None:
    run(
        str(RUN),
        *choice,
        f"plugins={PLUGINS}",
        "tracking=off",
        "figures=false",
        "hydra.run.dir=out",
        folder=tmp_path,
    )
    result = json.loads((tmp_path / "out" / "result.json").read_text())
    if choice[0] == "sim=drop":
        assert result["highest_rebound_m"] == pytest.approx(0.01, rel=1e-3)
    elif choice[0] == "sim=slide":
        # v^2 / (2 mu g), and what smoothing below v0 lets it slide on.
        assert result["distance_m"] == pytest.approx(0.1**2 / (2.0 * 0.3 * 10.0), rel=0.05)
    else:
        assert result["alpha_snap_rad"] == pytest.approx(0.9109, abs=5e-4)


@pytest.mark.slow
def test_the_composition_tests_take_them_in() -> None:
    """Ranges, derivatives and small jumps with most members; long ones are left out."""
    files = ("contact/test_laws.py", "declare/test_options.py", "test_composition.py")
    chosen = [f"tests/{file}" for file in files]
    fast = ["-m", "not slow and not compiles", "-q", "-p", "no:cacheprovider", "-n", "2"]
    only = ("-k", "(cone or tanh or theta) and not elastic-fixed and not central_difference")
    done = run("-m", "pytest", *chosen, *fast, *only, SNAPJUMP_PLUGINS=str(PLUGINS))
    assert int(re.findall(r"(\d+) passed", done.stdout)[0]) > 40
