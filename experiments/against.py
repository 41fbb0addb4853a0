"""Factors of speed against an earlier revision: ``python -m experiments.against``.

Both are measured in turns, in one run and by their own ``python -m experiments.speed``, so that a
busy machine slows both. Factors are medians over the rounds, with the least and the most.
"""

import json
import statistics
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from snapjump.tiers import TIERS

from .command import measured

HERE = Path(__file__).parents[1]
FIGURES = ("ms_per_jump_core", "newton_iterations", "us_per_newton_iteration")
ALONE = "single_jump_kernel_seconds"


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
    return dict(json.loads(done.stdout))


def factor(theirs: list[float], ours: list[float]) -> dict[str, Any]:
    """How many times less ours are."""
    ratios = [a / b for a, b in zip(theirs, ours, strict=True)]
    return {
        "then": statistics.median(theirs),
        "now": statistics.median(ours),
        "factor": round(statistics.median(ratios), 3),
        "least_and_most": [round(min(ratios), 3), round(max(ratios), 3)],
    }


def report(revision: str = "57270aa", designs: int = 64, rounds: int = 5) -> Any:
    """Factors of each tier, and of one robot alone at ``standard``."""
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
    alone = factor(*([one[ALONE] for one in side] for side in sides))
    return {"revision": revision, "rounds": rounds, **found, ALONE: alone}


if __name__ == "__main__":
    measured(report)
