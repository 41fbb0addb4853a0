"""Who lacks an optional package is told the extra that has it, in one line."""

import subprocess
import sys
import tomllib

import pytest
from command_line import ROOT

from snapjump.files.extras import EXTRAS, MissingExtraError, explained, extras_named

DECLARED = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]


def test_every_extra_is_one_of_ours():
    assert {*EXTRAS} < {*DECLARED["optional-dependencies"]}


def test_the_library_needs_little():
    needed = {text.split(">")[0] for text in DECLARED["dependencies"]}
    assert needed == {"numpy", "scipy", "numba", "pyyaml", "matplotlib", "pillow"}


def test_a_package_of_none_stays_as_it_is():
    error = ModuleNotFoundError("No module named 'nothing'", name="nothing")
    assert explained(error) is error
    with pytest.raises(ModuleNotFoundError, match="nothing"), extras_named():
        raise error


def test_a_part_of_a_package_counts():
    with pytest.raises(MissingExtraError, match=r"torch is not.*snapjump\[learn\].*without CUDA"):
        with extras_named():
            raise ModuleNotFoundError("no", name="torch.nn")


WITHOUT = """
import sys
for name in {hidden!r}:
    sys.modules[name] = None
import snapjump
{work}
"""
CASES = {
    ("torch",): "snapjump.forward_model('standard')",
    ("pyarrow",): "snapjump.load_dataset('d')",
    ("pandas",): "snapjump.simulate_designs('draft', [[0.1, 0.2, 0.768, 0.3]]).to_frame()",
    ("hydra",): "from snapjump.__main__ import main; sys.argv[1:] = []; sys.exit(main())",
}


@pytest.mark.processes
@pytest.mark.parametrize("hidden", CASES, ids="-".join)
def test_the_front_page_says_which(hidden):
    code = WITHOUT.format(hidden=hidden, work=CASES[hidden])
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, cwd=ROOT)
    last = run.stderr.splitlines()[-1]
    extra = next(name for name, packages in EXTRAS.items() if hidden[0] in packages)
    assert run.returncode != 0
    assert f"{hidden[0]} is not installed: pip install 'snapjump[{extra}]'" in last


@pytest.mark.processes
def test_without_any_of_them_a_jump_is_simulated():
    hidden = [package for packages in EXTRAS.values() for package in packages]
    work = "jump = snapjump.simulate_jump(accuracy='draft'); print(jump.status, jump.plot().name)"
    code = WITHOUT.format(hidden=hidden, work=work)
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, cwd=ROOT)
    assert run.stdout.split() == ["ok", "jump.png"], run.stderr
