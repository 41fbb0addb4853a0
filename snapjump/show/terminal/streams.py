"""Standard streams that a program can always write to: a closed pipe to ``head`` stops no work."""

import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from typing import Any

STANDARD = (0, 1, 2)


class Unfailing:
    """A text stream that is silent from the first time on that it cannot be written to."""

    def __init__(self, stream: Any):
        self._stream = stream

    def write(self, text: str) -> int:
        with suppress(OSError, ValueError):
            self._stream.write(text)
            return len(text)
        self._silence()
        return len(text)

    def flush(self) -> None:
        with suppress(OSError, ValueError):
            self._stream.flush()
            return
        self._silence()

    def __getattr__(self, name: str) -> Any:
        return getattr(self._stream, name)

    def _silence(self) -> None:
        """Let what is left in its buffer, and all that follows, go nowhere."""
        nowhere = os.open(os.devnull, os.O_WRONLY)
        with suppress(OSError, ValueError):
            os.dup2(nowhere, self._stream.fileno())
        os.close(nowhere)


@contextmanager
def unfailing_streams() -> Iterator[None]:
    """Make stdout and stderr such streams for the block."""
    open_standard_files()
    before = sys.stdout, sys.stderr
    sys.stdout, sys.stderr = (
        Unfailing(open(os.devnull, "w") if stream is None else stream) for stream in before
    )
    try:
        yield
    finally:
        for stream in (sys.stdout, sys.stderr):
            stream.flush()
        sys.stdout, sys.stderr = before


def open_standard_files() -> None:
    """Open the standard files that are closed (``2>&-``): the next file that is opened would
    get such a number, and what C code complains of would be written into it."""
    for number in STANDARD:
        try:
            os.fstat(number)
        except OSError:
            os.open(os.devnull, os.O_RDWR)
