"""Locks on open files, between processes: POSIX's flock, and none where there is no such thing.

Windows has no locks that readers share. There nothing keeps two processes apart, and nothing waits:
the same run, sweep or dataset must not be worked on twice at once.
"""

from typing import IO, Any

try:
    import fcntl
except ImportError:  # Windows
    fcntl = None  # type: ignore[assignment]


def lock_file(file: IO[Any], shared: bool = False, wait: bool = True) -> None:
    """Hold a lock until the file is closed, or its process ends.

    Raises BlockingIOError where another process holds it and ``wait`` is false, OSError where the
    file system has no locks.
    """
    if fcntl is not None:
        kind = fcntl.LOCK_SH if shared else fcntl.LOCK_EX
        fcntl.flock(file, kind if wait else kind | fcntl.LOCK_NB)
