"""A lock between processes that ends with the process that holds it."""

import fcntl
from pathlib import Path
from typing import IO


class FileLock:
    """Exclusive use of a path; the lock file itself stays, and means nothing on its own."""

    def __init__(self, path: Path):
        self.path = path
        self._file: IO[str] | None = None

    def acquire(self, wait: bool = True) -> bool:
        """Take the lock; False if another process holds it and ``wait`` is false."""
        self.path.parent.mkdir(parents=True, exist_ok=True)
        file = open(self.path, "a")
        try:
            fcntl.flock(file, fcntl.LOCK_EX if wait else fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            file.close()
            return False
        self._file = file
        return True

    def release(self) -> None:
        """Let others have it."""
        if self._file is not None:
            self._file.close()
            self._file = None

    def __enter__(self) -> "FileLock":
        self.acquire()
        return self

    def __exit__(self, *error: object) -> None:
        self.release()
