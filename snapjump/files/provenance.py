"""Provenance of a result: code, versions, machine, seed and the command that repeats it."""

import os
import platform
import subprocess
from datetime import UTC, datetime
from functools import cache
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Any

from snapjump.files.sources import PACKAGE, combined_hash, package_files, plugin_files

PACKAGES = (
    *("snapjump", "numpy", "scipy", "numba", "llvmlite", "hydra-core", "omegaconf"),
    *("mlflow", "matplotlib", "pyarrow", "torch", "pytorch-lightning"),
)
# Packages that only show, keep or ask for results: a change in them changes no number.
NOT_PHYSICS = ("executor", "files", "run", "show", "tracking")
# What is built on datasets, and changes none.
BEYOND_DATASETS = ("inverse", "learning", "surrogate", "targets")
# Variables of git that name a repository, which may be another one.
OF_A_REPOSITORY = (
    *("GIT_DIR", "GIT_WORK_TREE", "GIT_COMMON_DIR", "GIT_INDEX_FILE"),
    *("GIT_OBJECT_DIRECTORY", "GIT_ALTERNATE_OBJECT_DIRECTORIES", "GIT_NAMESPACE"),
)


def now() -> str:
    """The time in UTC, to the millisecond, as ISO 8601."""
    return datetime.now(UTC).isoformat(timespec="milliseconds")


def provenance(command: str, seed: int, started_at: str) -> dict[str, Any]:
    """Everything that is needed to tell how a result came about, and to repeat it."""
    times = {"started_at": started_at, "finished_at": now()}
    return {"command": command, "seed": seed, **times, **origin()}


def origin() -> dict[str, Any]:
    """The code, its versions and the machine."""
    return {**git_state(), "source_sha256": source_hash(), **_surroundings()}


@cache
def _surroundings() -> dict[str, Any]:
    """What stays while a process runs; to look it up takes as long as tens of jumps."""
    return {
        "versions": {"python": platform.python_version(), **{p: _version(p) for p in PACKAGES}},
        "machine": {
            "system": platform.platform(),
            "processor": _processor(),
            "cores": os.cpu_count(),
        },
    }


@cache
def git_state() -> dict[str, Any]:
    """The revision of the code and whether files differ from it; null outside a repository of its
    own, as where the package is installed within somebody else's."""
    top = _git("rev-parse", "--show-toplevel")
    if top is None or Path(top).resolve() != PACKAGE.parent.resolve():
        return {"git_revision": None, "git_dirty": None}
    revision = _git("rev-parse", "HEAD")
    changes = _git("status", "--porcelain")
    return {"git_revision": revision, "git_dirty": None if changes is None else changes != ""}


def source_hash(without: tuple[str, ...] = ()) -> str:
    """A hash of the sources that results depend on; tells apart what git calls just dirty.

    Plug-ins count, comments and docstrings do not.

    ``without``: parts of the package that those at hand do not depend on.
    """
    return combined_hash(
        source
        for source in (*package_files(), *plugin_files())
        if source.part not in (*NOT_PHYSICS, *without)
    )


def _git(*arguments: str) -> str | None:
    environment = {key: value for key, value in os.environ.items() if key not in OF_A_REPOSITORY}
    try:
        answer = subprocess.run(
            ["git", "-C", str(PACKAGE), *arguments],
            capture_output=True,
            text=True,
            timeout=10,
            check=True,
            env=environment,
        )
    except (OSError, subprocess.SubprocessError):
        return None
    return answer.stdout.strip()


def _version(name: str) -> str | None:
    try:
        return version(name)
    except PackageNotFoundError:
        return None


def _processor() -> str:
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
    except OSError:
        lines = []
    names = [line.split(":", 1)[1].strip() for line in lines if line.startswith("model name")]
    return names[0] if names else platform.processor()
