"""Computing time of recording a jump: ``python -m experiments.tracking`` prints one JSON object.

Processor time of a whole command with and without a record in a database that is there already,
the least of several; unlike wall time it is hardly longer on a machine that has other work.
"""

import os
import subprocess
import sys
import tempfile

from .command import measured
from .grid import RUN

JUMP = ("sim=jump", "accuracy=draft", "figures=false")


def cost_s(folder: str, tracking: str) -> float:
    """Processor time of one command in a folder."""
    command = [sys.executable, str(RUN), *JUMP, f"tracking={tracking}"]
    before = os.times()
    subprocess.run(command, cwd=folder, check=True, stdout=subprocess.DEVNULL)
    after = os.times()
    user_s = after.children_user - before.children_user
    return user_s + after.children_system - before.children_system


def report(repeats: int = 5) -> dict[str, float]:
    """Seconds without a record, with one, and of it."""
    with tempfile.TemporaryDirectory() as folder:
        # Compiles the kernels and creates the database.
        cost_s(folder, "sqlite")
        pairs = [[cost_s(folder, name) for name in ("off", "sqlite")] for _ in range(repeats)]
    off, sqlite = (min(times) for times in zip(*pairs, strict=True))
    found = {"off_s": off, "sqlite_s": sqlite, "record_s": sqlite - off}
    return {key: round(value, 2) for key, value in found.items()}


if __name__ == "__main__":
    measured(report)
