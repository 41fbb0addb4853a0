"""A lock between processes that ends with the process that holds it."""

import fcntl
from pathlib import Path
from typing import IO


class FileLock:
    """Exclusive use of a path, or one shared with others that share it.
    The lock file itself stays, and means nothing on its own."""

    def __init__(self, path: Path, shared: bool = False):
        self.path = path
        self._kind = fcntl.LOCK_SH if shared else fcntl.LOCK_EX
        self._file: IO[str] | None = None

    def acquire(self, wait: bool = True) -> bool:
        """Take the lock; False if another process holds it and ``wait`` is false."""
        self.path.parent.mkdir(parents=True, exist_ok=True)
        file = open(self.path, "a+")  # a network's file system lets only readers share
        try:
            fcntl.flock(file, self._kind if wait else self._kind | fcntl.LOCK_NB)
        except BlockingIOError:
            file.close()
            return False
        self._file = file
        return True

    def release(self) -> None:
        if self._file is not None:
            self._file.close()
            self._file = None

    def __enter__(self) -> "FileLock":
        self.acquire()
        return self

    def __exit__(self, *error: object) -> None:
        self.release()
