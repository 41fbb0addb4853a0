"""Time from a fresh clone to the first apex: ``python -m experiments.first_result``.

Prints one JSON object: seconds of ``make jump`` in a clone of what is committed, with no kernels
compiled, until the closing block with the apex is there, and of that until something is compiled
and while that goes on; then, from Python there, milliseconds of ``simulate_jump`` of other designs
besides its kernels, and CPU seconds of compiling for other modules. Medians of ``--runs``. The
installers' own caches are as they are; with ``--cold`` they are empty, and with ``--pip`` uv is
left out. Needs git, make and Python.
"""

import json
import os
import re
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from .command import measured

WARM = """
import json, os, statistics, time
from snapjump import simulate_jump
from snapjump.scenes import compile_ahead
simulate_jump()
besides = []
for k in range(20):
    begun = time.perf_counter()
    jump = simulate_jump(design={"epsilon": 0.2 + 0.003 * (k + 1)})
    besides.append(1e3 * (time.perf_counter() - begun - jump.kernel_seconds))
before = os.times()
simulate_jump(contact="penalty", friction="lagged", integrator="tr_bdf2")
for process in compile_ahead._begun.values():
    process.wait()
after = os.times()
cpu = sum(after[:4]) - sum(before[:4])
print(json.dumps({"warm_besides_kernels_ms": round(statistics.median(besides), 1),
                  "other_modules_cpu_s": round(cpu, 1)}))
"""
ROOT = Path(__file__).resolve().parents[1]
APEX = re.compile(r"^\s+apex\s")
COMPILING, COMPILED = re.compile("compiling kernels"), re.compile("compiled in")
CACHES = ("UV_CACHE_DIR", "PIP_CACHE_DIR")


def report(runs: int = 3, cold: bool = False, pip: bool = False) -> dict[str, object]:
    """Time so many clones, one after the other."""
    found = [one_clone(cold, pip) for _ in range(runs)]
    middle = {key: round(statistics.median(run[key] for run in found), 1) for key in found[0]}
    return {"runs": runs, "cores": os.cpu_count(), **middle, "each": found}


def one_clone(cold: bool, pip: bool) -> dict[str, float]:
    """Seconds to the first apex in a clone of its own, and where they went."""
    with tempfile.TemporaryDirectory() as folder:
        clone = Path(folder, "clone")
        subprocess.run(["git", "clone", "--quiet", str(ROOT), str(clone)], check=True)
        environment = {**os.environ, "XDG_CACHE_HOME": f"{folder}/cache"}
        for name in ("NUMBA_CACHE_DIR", "VIRTUAL_ENV", "PYTHONPATH", "MLFLOW_TRACKING_URI"):
            environment.pop(name, None)
        for name in CACHES:
            kept = Path.home() / ".cache" / name.partition("_")[0].lower()
            environment[name] = f"{folder}/{name}" if cold else os.environ.get(name, str(kept))
        command = ["make", "jump", *(["UV=false"] if pip else [])]
        found = followed(command, clone, environment)
        python = [".venv/bin/python", "-c", WARM]
        told = subprocess.run(python, cwd=clone, env=environment, check=True, capture_output=True)
        return found | json.loads(told.stdout)


def followed(command: list[str], folder: Path, environment: dict[str, str]) -> dict[str, float]:
    """Seconds until the apex is printed, and what of them went where, by what is printed."""
    begun = time.perf_counter()
    process = subprocess.Popen(
        command,
        cwd=folder,
        env={**environment, "PYTHONUNBUFFERED": "1"},
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
    )
    assert process.stdout is not None
    compiling, compiled, apex, told = 0.0, 0.0, 0.0, []
    for line in process.stdout:
        told.append(line)
        now = time.perf_counter() - begun
        if COMPILING.match(line) and not compiling:
            compiling = now
        if COMPILED.match(line):
            compiled = now
        if APEX.match(line) and not apex:
            apex = now
    if process.wait() != 0 or not apex:
        sys.exit("".join(told))
    return {
        "apex_s": round(apex, 1),
        "before_compiling_s": round(compiling, 1),
        "compiled_s": round(compiled - compiling, 1),
        "recorded_s": round(time.perf_counter() - begun, 1),
    }


if __name__ == "__main__":
    measured(report)
