"""What tests of several folders share."""

import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "tests" / "support"))
pytest_plugins = ["perturbation"]
Command = Callable[..., subprocess.CompletedProcess[str]]


@pytest.fixture
def command(tmp_path: Path) -> Command:
    """Runs ``python run.py`` with the given arguments in an empty folder of its own."""

    def run(*arguments: str, timeout_s: float = 300.0, python: tuple[str, ...] = ()):
        return subprocess.run(
            [sys.executable, *python, str(ROOT / "run.py"), *arguments],
            cwd=tmp_path,
            capture_output=True,
            text=True,
            timeout=timeout_s,
        )

    return run
