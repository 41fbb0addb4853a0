"""``python -m experiments.faults``: a dataset whose making is killed again and again.

``python run.py task=dataset`` is killed (SIGKILL, its whole process group) at random moments and
started again, until it has been killed so many times; then it is left to finish. After every kill
each shard that is listed must be whole. At the end the manifest must equal, byte for byte, that of
a run that nobody disturbed. Prints one JSON object.
"""

import json
import os
import random
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from snapjump.dataset.folder import DatasetFolder
from snapjump.dataset.shard import read_entry
from snapjump.files.sealed import read_sealed, sha256_of

from .command import measured
from .grid import RUN

# Of all shards, how many the killed runs may make at most: there is always something left to kill.
SHARE_BEFORE_KILLS = 0.6
LOOK_EVERY_S = 0.005


@dataclass
class Kill:
    """One of them: so long after so many new shards; shards that were listed then, and those that
    were not whole."""

    shards: int
    after_s: float
    listed: int
    not_whole: list[str]


def started(path: Path, overrides: Sequence[str], **how: Any) -> subprocess.Popen[bytes]:
    """Begin to make the dataset, in a process of its own."""
    own = [f"dataset.path={path}", "tracking=off", "figures=false", "task=dataset"]
    command = [sys.executable, str(RUN), *own, *overrides]
    return subprocess.Popen(command, cwd=path.parent, stdout=subprocess.DEVNULL, **how)


def run_through(path: Path, overrides: Sequence[str]) -> tuple[float, float]:
    """Make the dataset; returns the seconds until it had a shard, and until it had all."""
    begun = time.perf_counter()
    process = started(path, overrides)
    first_s = 0.0
    while process.poll() is None:
        if not first_s and listed(path):
            first_s = time.perf_counter() - begun
        time.sleep(LOOK_EVERY_S)
    if process.returncode:
        raise subprocess.CalledProcessError(process.returncode, process.args)
    return first_s, time.perf_counter() - begun


def run_killed(path: Path, overrides: Sequence[str], shards: int, after_s: float) -> bool:
    """Start to make the dataset, and kill it some time after there are so many more shards.
    False if it ended before."""
    enough = listed(path) + shards
    process = started(path, overrides, stderr=subprocess.DEVNULL, start_new_session=True)
    while listed(path) < enough and process.poll() is None:
        time.sleep(LOOK_EVERY_S)
    try:
        process.wait(after_s)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        process.wait()
        return True
    return False


def listed(path: Path) -> int:
    """Number of shards that have an entry."""
    return len(list(path.glob("shards/_shard-*.json")))


def look(path: Path) -> tuple[int, list[str]]:
    """Number of listed shards, and the damage of any of them."""
    folder = DatasetFolder(path)
    plain = read_sealed(folder.specification)
    numbers = sorted(int(file.stem[-5:]) for file in (path / "shards").glob("_shard-*.json"))
    if plain is None:
        return len(numbers), [] if not folder.specification.exists() else ["dataset.json"]
    found = [read_entry(folder, number, sha256_of(plain))[1] for number in numbers]
    return len(numbers), [reason for reason in found if reason]


def faults(folder: Path, kills: int, overrides: Sequence[str], seed: int) -> dict[str, Any]:
    """Make a dataset undisturbed and one that is killed, and compare."""
    undisturbed, disturbed = folder / "undisturbed", folder / "disturbed"
    # Kernels are compiled by a run that is not timed.
    run_through(folder / "compiling", [*overrides, "plan.count=1"])
    start_s, seconds = run_through(undisturbed, overrides)
    total = listed(undisturbed)
    most = max(1, int(SHARE_BEFORE_KILLS * total / kills))
    chance = random.Random(seed)
    done: list[Kill] = []
    begun = time.perf_counter()
    while len(done) < kills:
        # While it begins, or while it makes a shard.
        shards = chance.randint(0, most)
        after_s = chance.uniform(0.0, (seconds - start_s) / total if shards else start_s)
        if not run_killed(disturbed, overrides, shards, after_s):
            break
        done.append(Kill(shards, round(after_s, 3), *look(disturbed)))
    _, last = run_through(disturbed, overrides)
    manifests = [(path / "manifest.json").read_bytes() for path in (undisturbed, disturbed)]
    left = [file.name for file in (disturbed / "shards").glob(".*")]
    content = json.loads(manifests[0])
    return {
        "designs": content["designs"],
        "shards": len(content["shards"]),
        "kills": len(done),
        "kills_before_the_end": sum(kill.listed < len(content["shards"]) for kill in done),
        "shards_not_whole_after_kills": sum(len(kill.not_whole) for kill in done),
        "half_written_files_left": len(left),
        "manifests_identical": manifests[0] == manifests[1],
        "dataset_sha256": content["dataset_sha256"],
        "undisturbed_seconds": seconds,
        "disturbed_seconds": time.perf_counter() - begun,
        "last_run_seconds": last,
        "each": [asdict(kill) for kill in done],
    }


def report(
    kills: int = 20,
    designs: int = 4096,
    shard_size: int = 64,
    accuracy: str = "draft",
    seed: int = 0,
) -> dict[str, Any]:
    """A dataset of such a plan, made in a folder that is deleted afterwards."""
    size = (f"plan.count={designs}", f"dataset.shard_size={shard_size}")
    with tempfile.TemporaryDirectory() as folder:
        overrides = ("plan=sobol", *size, f"accuracy={accuracy}")
        return faults(Path(folder), kills, overrides, seed)


if __name__ == "__main__":
    measured(report)
