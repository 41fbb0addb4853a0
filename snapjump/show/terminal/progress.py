"""A small progress bar for whatever takes longer than two seconds."""

import os
import sys
import time
from typing import TextIO

SHOW_AFTER_S = 2.0
REDRAW_EVERY_S = 0.1
WIDTH = 30


class ProgressBar:
    """Call it with the share that is done and a word on what is being done.
    It draws only on a terminal, or where SNAPJUMP_PROGRESS=1 asks for it."""

    def __init__(
        self, stream: TextIO | None = None, show_after_s: float = SHOW_AFTER_S, visible: bool = True
    ):
        self._stream = stream if stream is not None else sys.stderr
        wanted = os.environ.get("SNAPJUMP_PROGRESS", "")
        shown = wanted == "1" or (wanted != "0" and self._stream.isatty())
        self._visible = visible and shown
        self._next_s = time.monotonic() + show_after_s
        self._drawn = 0

    def __call__(self, done: float, text: str) -> None:
        """Redraw, if it is time to."""
        now = time.monotonic()
        if not self._visible or now < self._next_s:
            return
        self._next_s = now + REDRAW_EVERY_S
        done = min(max(done, 0.0), 1.0)
        full = round(WIDTH * done)
        line = f"[{'#' * full}{'.' * (WIDTH - full)}] {100 * done:3.0f} % {text}"
        self._stream.write("\r" + line.ljust(self._drawn))
        self._stream.flush()
        self._drawn = len(line)

    def close(self) -> None:
        """Take the bar off the screen."""
        if self._drawn:
            self._stream.write("\r" + " " * self._drawn + "\r")
            self._stream.flush()
            self._drawn = 0
