"""What tests of several folders share."""

import os
import shutil
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from typing import Any

import pytest
from command_line import ROOT, Done, apart, here
from groups import GroupScheduling, in_order

Command = Callable[..., Done]
pytest_plugins = ["golden", "perturbation"]
# Which MLflow reads once, when it is imported by whichever test comes first.
os.environ["MLFLOW_DISABLE_TELEMETRY"] = "true"
# Processes side by side that each take all cores for a small matrix wait for each other. Read once
# as well, by numpy's library and torch's.
if "PYTEST_XDIST_WORKER" in os.environ:
    os.environ["OMP_NUM_THREADS"] = "1"


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Begin with the tests that compile most."""
    items[:] = in_order(items, ROOT / "tests")


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_make_scheduler(config: pytest.Config, log: Any) -> Any:
    """``--dist loadgroup`` groups tests by their files, without marks in them."""
    return GroupScheduling(config, log) if config.getvalue("dist") == "loadgroup" else None


@pytest.fixture(autouse=True, scope="session")
def one_process_compiles() -> Iterator[None]:
    """No second process compiles what a jump that is only checked would need: those side by side
    have no core to spare."""
    from snapjump.sim import jump

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(jump, "compile_ahead", lambda simulation: None)
        yield


@pytest.fixture
def command(tmp_path) -> Command:
    """Runs ``python run.py`` with the given arguments in a folder of its own, in this process.

    It must end with exit code 0, or with the ``code`` that is given.
    """
    return partial(here, tmp_path)


@pytest.fixture
def process(tmp_path) -> Command:
    """Runs the command in a process of its own, where it matters that it is one."""
    return partial(apart, tmp_path)


@pytest.fixture
def refusal(command) -> Callable[..., str]:
    """The one line by which a command is refused, which prints nothing else."""

    def line_of(*arguments: str) -> str:
        done = command(*arguments, code=2)
        assert done.stdout == "" and done.stderr.count("\n") == 1, done.stdout + done.stderr
        return str(done.stderr)

    return line_of


@pytest.fixture(scope="session")
def tables(tmp_path_factory) -> Path:
    """A tracking database without records: making one takes longer than most tests.

    The first of the processes that tests are spread over makes it for all.
    """
    from snapjump.files.lock import FileLock
    from snapjump.tracking.sqlite import Sqlite

    folder = tmp_path_factory.getbasetemp()
    if "PYTEST_XDIST_WORKER" in os.environ:
        folder = folder.parent
    with FileLock(folder / "tables.lock"):
        Sqlite(path=str(folder / "tables.db")).prepare()
    return folder / "tables.db"


@pytest.fixture
def database(tables, tmp_path) -> Path:
    """The tracking database of the folder that commands run in, its tables made."""
    return Path(shutil.copy(tables, tmp_path / "mlruns.db"))
