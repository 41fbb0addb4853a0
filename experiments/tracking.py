"""What recording a jump costs: ``python -m experiments.tracking`` prints one JSON object.

Processor time of a whole command with and without a record in a database that is there already,
the least of several; unlike wall time it is hardly longer on a machine that has other work.
"""

import argparse
import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
JUMP = ("sim=jump", "accuracy=draft", "figures=false")


def cost_s(folder: Path, tracking: str) -> float:
    """Processor time of one command in a folder."""
    before = os.times()
    subprocess.run(
        [sys.executable, str(ROOT / "run.py"), *JUMP, f"tracking={tracking}"],
        cwd=folder,
        check=True,
        stdout=subprocess.DEVNULL,
    )
    after = os.times()
    user_s = after.children_user - before.children_user
    return user_s + after.children_system - before.children_system


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--repeats", type=int, default=5)
    repeats = parser.parse_args().repeats
    with tempfile.TemporaryDirectory() as folder:
        # Compiles the kernels and creates the database.
        cost_s(Path(folder), "sqlite")
        pairs = [[cost_s(Path(folder), name) for name in ("off", "sqlite")] for _ in range(repeats)]
    off, sqlite = (min(times) for times in zip(*pairs, strict=True))
    report = {"off_s": off, "sqlite_s": sqlite, "record_s": sqlite - off}
    print(json.dumps({key: round(value, 2) for key, value in report.items()}, indent=2))


if __name__ == "__main__":
    main()
