"""Notices to the user on stderr, which never stop the work: nobody may be there to read them."""

import sys
from contextlib import suppress


def notice(text: str) -> None:
    """Print a line on stderr, if there is one that can still be written to."""
    if sys.stderr is not None:
        with suppress(OSError, ValueError):  # a pipe without reader, a full disk, a closed stream
            print(text, file=sys.stderr, flush=True)
