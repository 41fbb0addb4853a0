"""Telling the user which kernels are being compiled, how far that is, and about how long it takes.

Once for a choice of modules: they are kept on disk. What takes less than a second is not told.
"""

import time
from typing import NamedTuple

from snapjump.files.notice import notice


class Stage(NamedTuple):
    """A program that takes long to compile: what it does, and typical seconds of a core."""

    does: str
    seconds: int


# In the order in which a jump needs them.
STAGES = {
    "equilibrate": Stage("equilibria of the arch", 4),
    "find_starts": Stage("starts", 4),
    "march": Stage("time loop", 8),
}
OTHERS = {
    "differentiate_starts": Stage("derivatives of starts", 15),
    "cuda": Stage("programs of the card", 30),
}


_begun: list[float] = []  # moments at which something was announced


def announce(program: str, waiting: bool = False) -> None:
    """Say that a program is going to be compiled, or that another process is at it."""
    stage = STAGES.get(program) or OTHERS.get(program)
    if stage is None:
        return
    place = list(STAGES).index(program) + 1 if program in STAGES else None
    number = f"{place} of {len(STAGES)}, " if place else ""
    how = "by another process" if waiting else f"about {stage.seconds} s"
    _begun.append(time.monotonic())
    notice(f"compiling kernels, once for these modules: {number}{stage.does}, {how} ...")


def announce_end() -> None:
    """Say that what was announced is compiled, and how long that took."""
    if _begun:
        seconds = time.monotonic() - _begun[0]
        notice(f"compiled in {seconds:.0f} s, and kept for the next time")
        _begun.clear()
