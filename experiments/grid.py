"""The paper's grid of 50,625 jumps: ``python -m experiments.grid --tier standard`` prints one JSON
object with its time, memory and what became of the jumps.

Started again with the same folder it continues there, and its time is then that of the rest.
"""

import argparse
import json
import os
import resource
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

from snapjump.dataset.read import open_dataset

RELEASED_SECONDS = 26.0  # of one core for a jump of the released program
ROOT = Path(__file__).resolve().parent.parent


def generate(path: Path, tier: str, overrides: list[str]) -> dict[str, Any]:
    """Run the command and look at what it left."""
    command = [sys.executable, str(ROOT / "run.py"), "task=dataset", "plan=grid"]
    command += [f"accuracy={tier}", f"dataset.path={path}", *overrides]
    begun = time.perf_counter()
    subprocess.run(command, check=True, cwd=ROOT)
    wall_seconds = time.perf_counter() - begun
    dataset = open_dataset(path)
    cores = len(os.sched_getaffinity(0))
    rate = dataset.rows / wall_seconds / cores
    return {
        "tier": tier,
        "rows": dataset.rows,
        "wall_seconds": round(wall_seconds, 1),
        "cores": cores,
        "jumps_per_second_core": round(rate, 1),
        "times_fewer_core_seconds_than_released": round(RELEASED_SECONDS * rate),
        "peak_memory_mb": resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss // 1024,
        "bytes_on_disk": sum(file.stat().st_size for file in path.rglob("*") if file.is_file()),
        "statuses": dict(dataset.statuses),
        "dataset_sha256": dataset.sha256,
    }


def main() -> None:
    """Generate and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--tier", default="standard")
    parser.add_argument("--path", type=Path, default=None, help="folder of the dataset")
    parser.add_argument("overrides", nargs="*", help="further overrides for run.py")
    arguments = parser.parse_args()
    path = arguments.path or ROOT / "outputs" / "datasets" / f"grid-{arguments.tier}"
    print(json.dumps(generate(path.absolute(), arguments.tier, arguments.overrides), indent=2))


if __name__ == "__main__":
    main()
