"""Files that are there whole or not at all, whatever interrupts the writing."""

import os
import uuid
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import IO, Any


@contextmanager
def atomic_file(path: Path, mode: str = "w") -> Iterator[IO[Any]]:
    """Open a file for writing that appears under its name only once it is complete.

    It is written beside its destination, flushed to the disk and renamed. If the block raises,
    nothing is left and a file that was there before is untouched.
    """
    path = Path(path)
    beside = path.with_name(f".{path.name}.{uuid.uuid4().hex}")
    try:
        with open(beside, mode, encoding=None if "b" in mode else "utf-8") as file:
            yield file
            file.flush()
            os.fsync(file.fileno())
        os.replace(beside, path)
    except BaseException:
        beside.unlink(missing_ok=True)
        raise
    # Or the new name might be lost with the power, though the contents are safe.
    flush_folder(path.parent)


def write_text(path: Path, text: str) -> None:
    """Write a whole text file at once."""
    with atomic_file(path) as file:
        file.write(text)


def write_bytes(path: Path, content: bytes) -> None:
    """Write a whole file of bytes at once."""
    with atomic_file(path, "wb") as file:
        file.write(content)


def flush(path: Path) -> None:
    """Have the disk hold all of a file that some other code wrote."""
    with open(path, "r+b") as file:
        os.fsync(file.fileno())


def flush_folder(path: Path) -> None:
    """Have the disk hold the names of a folder's files; Windows opens no folders."""
    if os.name == "nt":
        return
    handle = os.open(path, os.O_RDONLY)
    try:
        os.fsync(handle)
    finally:
        os.close(handle)
