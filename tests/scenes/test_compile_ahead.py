"""A second process compiles a jump's time loop; without one, the first does it all."""

import os
import shutil
import subprocess
import sys

import pytest

pytestmark = pytest.mark.slow

JUMP = """
import os, pickle, sys
from snapjump import simulate_jump
from snapjump.engine.march import march
from snapjump.scenes import compile_ahead
{change}
jump = simulate_jump(accuracy="draft", discretization={{"elements": 40}})
found = jump.x_bar, sum(march.stats.cache_hits.values()), sum(march.stats.cache_misses.values())
print(*found)
"""
CHANGES = {
    "two cores": "",
    "one core": "os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})",
    "it dies": "compile_ahead.PROGRAM = 'import sys; sys.exit(1)'",
}


def test_outcomes_are_the_same_whoever_compiles(tmp_path):
    found = {}
    for name, change in CHANGES.items():
        if found:  # all but the time loop is there
            kept = shutil.copytree(tmp_path / "two cores", tmp_path / name)
            for file in kept.rglob("march-*"):
                file.unlink()
        environment = {**os.environ, "NUMBA_CACHE_DIR": str(tmp_path / name)}
        command = [sys.executable, "-c", JUMP.format(change=change)]
        run = subprocess.run(command, env=environment, capture_output=True, text=True)
        assert run.returncode == 0, run.stderr
        found[name] = run.stdout.split()
    assert len({x for x, *_ in found.values()}) == 1
    # On one core the time loop is compiled here, on two it is fetched from disk.
    assert [found[name][1:] for name in CHANGES] == [["1", "0"], *2 * [["0", "1"]]]
