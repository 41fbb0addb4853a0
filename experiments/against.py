"""Factors of speed against an earlier revision: ``python -m experiments.against``.

Both are measured in turns, in one run and by their own ``python -m experiments.speed``, so that a
busy machine slows both. Factors are medians over the rounds, with the least and the most.
``--history docs/speed.csv`` adds a row with the factors of this revision, so that a slower one is
seen.
"""

import json
import platform
import statistics
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from snapjump.files.atomic import write_text
from snapjump.tiers import TIERS

from .command import measured

HERE = Path(__file__).parents[1]
FIGURES = ("ms_per_jump_core", "newton_iterations", "us_per_newton_iteration")
ALONE = "single_jump_kernel_seconds"
OUTCOME = "single_jump_outcome_ms"  # alone, without a recorder
HEADER = ["date", "revision", "against", "processor", *TIERS, "alone_outcome", "alone_recorded"]


@contextmanager
def checked_out(revision: str) -> Iterator[Path]:
    """A folder with the sources of a revision, for a while."""
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary) / revision
        git("worktree", "add", "--detach", str(folder), revision)
        try:
            yield folder
        finally:
            git("worktree", "remove", "--force", str(folder))


def git(*words: str) -> None:
    """Run git in this repository."""
    subprocess.run(["git", *words], cwd=HERE, check=True, capture_output=True)


def speed(folder: Path, designs: int) -> dict[str, Any]:
    """What the sources of a folder say of their speed."""
    command = [sys.executable, "-m", "experiments.speed", "--designs", str(designs)]
    done = subprocess.run(command, cwd=folder, check=True, stdout=subprocess.PIPE, text=True)
    said = dict(json.loads(done.stdout))
    batch = said["standard"]
    said[OUTCOME] = said["lanes_over_scalar"] * batch["ms_per_jump_core"]
    return said


def factor(theirs: list[float], ours: list[float]) -> dict[str, Any]:
    """How many times less ours are."""
    ratios = [a / b for a, b in zip(theirs, ours, strict=True)]
    return {
        "then": statistics.median(theirs),
        "now": statistics.median(ours),
        "factor": round(statistics.median(ratios), 3),
        "least_and_most": [round(min(ratios), 3), round(max(ratios), 3)],
    }


def row(found: dict[str, Any], revision: str) -> list[str]:
    """A line of the history."""
    tiers = [found[tier]["ms_per_jump_core"]["factor"] for tier in TIERS]
    alone = [found[OUTCOME]["factor"], found[ALONE]["factor"]]
    processor = platform.processor() or platform.machine()
    here = ["git", "log", "-1", "--format=%cs,%h"]
    date, now = subprocess.check_output(here, cwd=HERE, text=True).strip().split(",")
    return [date, now, revision, processor, *(str(factor) for factor in (*tiers, *alone))]


def remember(path: Path, line: list[str]) -> None:
    """Add a line to the history."""
    begun = path.read_text(encoding="utf-8") if path.exists() else ",".join(HEADER) + "\n"
    write_text(path, begun + ",".join(line) + "\n")


def report(revision: str = "57270aa", designs: int = 64, rounds: int = 5, history: str = "") -> Any:
    """Factors of each tier, and of a robot alone at ``standard``; ``history``: a table of them."""
    with checked_out(revision) as before:
        pairs = [(speed(before, designs), speed(HERE, designs)) for _ in range(rounds)]
    sides = tuple(zip(*pairs, strict=True))
    found: dict[str, Any] = {
        tier: {
            figure: factor(*([one[tier][figure] for one in side] for side in sides))
            for figure in FIGURES
        }
        for tier in TIERS
    }
    for figure in (OUTCOME, ALONE):
        found[figure] = factor(*([one[figure] for one in side] for side in sides))
    if history:
        remember(Path(history), row(found, revision))
    return {"revision": revision, "rounds": rounds, **found}


if __name__ == "__main__":
    measured(report)
