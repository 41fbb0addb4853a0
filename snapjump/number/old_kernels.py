"""Removing compiled kernels that nobody has used for long: each edit of a kernel leaves some."""

import os
import re
import shutil
import time
from contextlib import suppress
from pathlib import Path
from typing import IO

from snapjump.files.flock import lock_file

NAME = re.compile("kernels-[0-9a-f]{16}")
OLD_S = 30 * 24 * 3600.0
LOCK = "in_use"
# Held as long as the process lives.
_held: dict[Path, IO[str]] = {}


def use(folder: Path) -> None:
    """Note that a folder of kernels is used, now and as long as this process runs."""
    # Without these notes, which no file system must allow, kernels are compiled once more at worst.
    with suppress(OSError):
        folder.mkdir(parents=True, exist_ok=True)
        os.utime(folder)
        if folder not in _held:
            _held[folder] = open(folder / LOCK, "a")
            lock_file(_held[folder], shared=True)  # waits for who is removing it


def remove_old(folder: Path) -> None:
    """Remove the folders of kernels beside this one that are neither in use nor were of late."""
    for other in folder.parent.glob("kernels-*"):
        # Nothing depends on it.
        with suppress(OSError):
            if NAME.fullmatch(other.name) and other != folder and _is_old(other):
                _remove_unused(other)


def _is_old(folder: Path) -> bool:
    return folder.is_dir() and time.time() - folder.stat().st_mtime > OLD_S


def _remove_unused(folder: Path) -> None:
    with open(folder / LOCK, "a") as file:
        lock_file(file, wait=False)
        shutil.rmtree(folder, ignore_errors=True)
