"""``python run.py`` for tests: in this process, which is quicker, or in one of its own."""

import os
import subprocess
import sys
import warnings
from collections.abc import Iterator
from contextlib import contextmanager, redirect_stderr, redirect_stdout
from io import StringIO
from pathlib import Path
from typing import Any

from pytest import MonkeyPatch

ROOT = Path(__file__).resolve().parents[2]
RUN = ROOT / "run.py"
Done = subprocess.CompletedProcess[str]


def here(folder: Path, *arguments: str) -> Done:
    """The command in a folder, by the function that ``run.py`` calls."""
    from snapjump.tasks.command_line import main

    out, err = StringIO(), StringIO()
    with as_a_program(folder, *arguments), redirect_stdout(out), redirect_stderr(err):
        try:
            code: Any = main(ROOT / "conf")
        except SystemExit as stop:
            code = stop.code
    return subprocess.CompletedProcess(arguments, code, out.getvalue(), err.getvalue())


@contextmanager
def as_a_program(folder: Path, *arguments: str) -> Iterator[None]:
    """The folder, arguments and warnings of a program of its own, and no trace of it after."""
    environment = dict(os.environ)
    with MonkeyPatch.context() as patch, warnings.catch_warnings():
        patch.chdir(folder)
        patch.setattr(sys, "argv", ["run.py", *arguments])
        # pytest keeps warnings to itself, and asks for those that only developers see.
        patch.setattr(warnings, "showwarning", print_warning)
        warnings.simplefilter("ignore", DeprecationWarning)
        warnings.simplefilter("ignore", PendingDeprecationWarning)
        try:
            yield
        finally:
            os.environ.clear()
            os.environ.update(environment)


def print_warning(*warning: Any, file: Any = None, line: str | None = None) -> None:
    """A warning on stderr, as Python prints it."""
    print(warnings.formatwarning(*warning, line), end="", file=sys.stderr)


def apart(
    folder: Path, *arguments: str, python: tuple[str, ...] = (), timeout_s: float = 900.0
) -> Done:
    """The command in a folder, by an interpreter of its own with options of its own."""
    return subprocess.run(
        [sys.executable, *python, str(RUN), *arguments],
        cwd=folder,
        capture_output=True,
        text=True,
        timeout=timeout_s,
    )
