"""Standard streams that nobody reads, that are closed or full: they stop no work."""

import io
import json
import os
import shlex
import subprocess
import sys

import pytest
from command_line import RUN, result_in
from small_datasets import OVERRIDES

from snapjump.show.terminal.streams import Unfailing, unfailing_streams

pytestmark = pytest.mark.processes

SCENE = ("sim=cantilever", "tracking=off", "figures=false")


class Broken(io.StringIO):
    """Can be written to once."""

    def write(self, text: str) -> int:
        if self.getvalue():
            raise BrokenPipeError
        return super().write(text)


def test_it_is_silent_after_the_first_failure():
    below = Broken()
    stream = Unfailing(below)
    for text in ("first", "second", "third"):
        print(text, end="", file=stream, flush=True)
    assert below.getvalue() == "first" and not stream.isatty()


def test_missing_streams_are_there_within_the_block(monkeypatch, capsys):
    monkeypatch.setattr(sys, "stderr", None)
    with unfailing_streams():
        print("to nobody", file=sys.stderr)
        print("to somebody")
    assert sys.stderr is None and capsys.readouterr().out == "to somebody\n"


def shell(folder, redirected, *arguments, program=(str(RUN),), **environment):
    """The command with its streams led elsewhere by a shell; what else the shell prints."""
    command = shlex.join([sys.executable, *program, *arguments])
    done = subprocess.run(
        ["bash", "-c", f"exec 3>&1; ({command}; echo rc $? >&3) {redirected}"],
        cwd=folder,
        env={**os.environ, "PYTHONPATH": str(RUN.parent), **environment},
        capture_output=True,
        text=True,
        timeout=600,
    )
    return done.stdout + done.stderr


@pytest.mark.parametrize("redirected", ["| true", "2>&1 | head -c 1", ">/dev/full", ">&-"])
def test_a_run_ends_well_whoever_listens(tmp_path, redirected):
    said = shell(tmp_path, redirected, *SCENE)
    assert "rc 0" in said and "Traceback" not in said and "Error" not in said
    assert result_in(tmp_path)[1]["status"] == "ok"


# The program with a bar that is drawn from the beginning.
EAGER = f"""
import runpy, sys
from snapjump.show.terminal.progress import ProgressBar
ProgressBar.__init__.__defaults__ = (None, 0.0, True)
sys.argv[0] = {str(RUN)!r}
runpy.run_path(sys.argv[0], run_name="__main__")
"""


@pytest.mark.parametrize("redirected", ["2>&-", "2>/dev/full", "2>&1 | head -c 1"])
def test_a_progress_bar_that_cannot_be_drawn_stops_nothing(tmp_path, redirected):
    plan = ("plan=sobol", "plan.count=64", "dataset.shard_size=8", "tracking=off", "figures=false")
    said = shell(
        tmp_path, redirected, *OVERRIDES, *plan, program=("-c", EAGER), SNAPJUMP_PROGRESS="1"
    )
    assert "rc 0" in said
    assert result_in(tmp_path)[1]["complete"]


def test_what_is_refused_is_refused_without_stderr(tmp_path):
    assert "rc 2" in shell(tmp_path, "2>&-", *SCENE, "design.epsilon=9")


def test_help_for_head(tmp_path):
    said = shell(tmp_path, "| head -n 1", "--help")
    assert "rc 0" in said and "Traceback" not in said


def test_a_closed_number_is_given_to_no_file(tmp_path):
    """A database as file 2 would have what C code complains of written into it."""
    script = "from snapjump.show.terminal.streams import *; open_standard_files(); import json, os;"
    script += "json.dump(os.open('data', os.O_CREAT | os.O_RDWR), os.fdopen(1, 'w'))"
    command = [sys.executable, "-c", script]
    done = subprocess.run(
        ["bash", "-c", 'exec "$@" 2>&-', "bash", *command],
        cwd=tmp_path, env={**os.environ, "PYTHONPATH": str(RUN.parent)}, capture_output=True,
    )  # fmt: skip
    assert json.loads(done.stdout) > 2
