"""A lock between processes that ends with the process that holds it."""

import os
from contextlib import suppress
from pathlib import Path
from typing import IO

from snapjump.files.flock import lock_file


class FileLock:
    """Exclusive use of a path, or one shared with others that share it.
    The lock file means nothing on its own: it stays, unless it is removed."""

    def __init__(self, path: Path, shared: bool = False):
        self.path = path
        self._shared = shared
        self._file: IO[str] | None = None

    def acquire(self, wait: bool = True) -> bool:
        """Take the lock; False if another process holds it and ``wait`` is false."""
        self.path.parent.mkdir(parents=True, exist_ok=True)
        while True:
            file = open(self.path, "a+")  # a network's file system lets only readers share
            try:
                lock_file(file, self._shared, wait)
            except BaseException as error:
                file.close()
                if isinstance(error, BlockingIOError):
                    return False
                raise
            with suppress(FileNotFoundError):
                if os.stat(self.path).st_ino == os.fstat(file.fileno()).st_ino:
                    self._file = file
                    return True
            file.close()  # it has been removed meanwhile

    def remove(self) -> None:
        """Release an exclusive lock, and take its file away."""
        if self._file is not None:
            self.path.unlink(missing_ok=True)
            self.release()

    def release(self) -> None:
        if self._file is not None:
            self._file.close()
            self._file = None

    def __enter__(self) -> "FileLock":
        self.acquire()
        return self

    def __exit__(self, *error: object) -> None:
        self.release()
