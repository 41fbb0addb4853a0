"""``python run.py`` for tests: in this process, which is quicker, or in one of its own."""

import json
import os
import signal
import socket
import subprocess
import sys
import time
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


def here(folder: Path, *arguments: str, code: int = 0) -> Done:
    """The command in a folder, by the function that ``run.py`` calls; ends with this code."""
    from snapjump.run.tasks.command_line import main

    out, err = StringIO(), StringIO()
    with as_a_program(folder, *arguments), redirect_stdout(out), redirect_stderr(err):
        try:
            ended: Any = main()
        except SystemExit as stop:
            ended = stop.code
    assert ended == code, out.getvalue() + err.getvalue()
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


def apart(folder: Path, *arguments: str, options: tuple[str, ...] = (), code: int = 0) -> Done:
    """The command in a folder, by an interpreter of its own with options of its own."""
    return python(*options, str(RUN), *arguments, folder=folder, code=code)


def python(
    *arguments: str, folder: Path = ROOT, code: int = 0, timeout_s: float = 900.0, **variables: str
) -> Done:
    """A Python that finds this library, with other environment variables; ends with this code."""
    done = subprocess.run(
        [sys.executable, *arguments],
        cwd=folder,
        env={**os.environ, "PYTHONPATH": str(ROOT), **variables},
        capture_output=True,
        text=True,
        timeout=timeout_s,
    )
    assert done.returncode == code, done.stdout + done.stderr
    return done


def begun(folder: Path, *arguments: str, until: str, **options: Any) -> "subprocess.Popen[str]":
    """The command in a process of its own, which has left a file of this pattern."""
    process = subprocess.Popen(
        [sys.executable, str(RUN), *arguments],
        cwd=folder,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        **options,
    )
    while not list(folder.glob(until)):
        assert process.poll() is None
        time.sleep(0.005)
    return process


def interrupted(process: "subprocess.Popen[str]") -> str:
    """What a command prints that Ctrl-C stops in the usual way."""
    process.send_signal(signal.SIGINT)
    out, errors = process.communicate(timeout=300)
    assert process.returncode == 130
    assert "Traceback" not in errors and "interrupted" in errors
    return out


def result_in(folder: Path) -> tuple[Path, dict[str, Any]]:
    """The folder and the result of the only run."""
    (file,) = folder.glob("outputs/20*/*/result.json")
    return file.parent, json.loads(file.read_text())


def free_port() -> int:
    """A port that nobody listens at on loopback."""
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        return int(free.getsockname()[1])
