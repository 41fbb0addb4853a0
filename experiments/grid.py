"""The paper's grid of 50,625 jumps: ``python -m experiments.grid --tier standard`` prints one JSON
object with its time, memory and what became of the jumps.

``--path`` is the folder of the dataset; other words are overrides for run.py. Started again with
the same folder it continues there, and its time is then that of the rest.
"""

import resource
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

from snapjump.dataset.read import load_dataset
from snapjump.files.cores import own_cores

from .command import measured

RELEASED_SECONDS = 26.0  # of one core for a jump of the released program, at its least
RUN = Path(__file__).resolve().parents[1] / "run.py"


def report(*overrides: str, tier: str = "standard", path: str = "") -> dict[str, Any]:
    """Run the command and look at what it left."""
    folder = Path(path or RUN.parent / "outputs" / "datasets" / f"grid-{tier}").absolute()
    command = [sys.executable, str(RUN), "task=dataset", "plan=grid"]
    command += [f"accuracy={tier}", f"dataset.path={folder}", *overrides]
    begun = time.perf_counter()
    subprocess.run(command, check=True, cwd=RUN.parent)
    wall_seconds = time.perf_counter() - begun
    dataset = load_dataset(folder)
    cores = len(own_cores())
    rate = dataset.rows / wall_seconds / cores
    kernels = float(dataset.frame(["kernel_seconds"]).to_numpy().sum())
    beside = wall_seconds - kernels / cores
    return {
        "tier": tier,
        "rows": dataset.rows,
        "wall_seconds": round(wall_seconds, 1),
        "cores": cores,
        "kernel_seconds": round(kernels, 1),
        # Starting Python, preparing, writing, and waiting for the last jumps.
        "beside_kernels_percent": round(100.0 * beside / wall_seconds, 1),
        "beside_kernels_percent_on_64_cores": round(100.0 * beside / (beside + kernels / 64), 1),
        "jumps_per_second_core": round(rate, 1),
        "times_fewer_core_seconds_than_released": round(RELEASED_SECONDS * rate),
        "peak_memory_mb": resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss // 1024,
        "bytes_on_disk": sum(file.stat().st_size for file in folder.rglob("*") if file.is_file()),
        "statuses": dict(dataset.statuses),
        "dataset_sha256": dataset.sha256,
    }


if __name__ == "__main__":
    measured(report)
