"""The kernels compile for a card that is not here, round as processors do and allocate nothing."""

import re
import shutil
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from robots import DESIGNS, small_march

pytestmark = pytest.mark.slow
MOST_SPILLED_BYTES = 4096
# NVIDIA's compiler needs no card; numba-cuda asks for one.
CAPABILITY = (9, 0)  # of an H100 or H200
EULER = {"integrator": "implicit_euler"}
EXACT = {"discretization": "geometrically_exact", "contact": "penalty", "integrator": "bdf2"}
PAPER = {**EULER, "stepping": "fixed", "friction": "lagged", "damping": "none"}
EXPLICIT = {"integrator": "central_difference", "contact": "hunt_crossley", "damping": "none"}
OTHERS = ({"frame": "elastic"}, EXACT, {**EULER, "contact": "signorini"}, PAPER, EXPLICIT)
PROGRAMS = [("find_starts", {}), ("march", {}), *[("march", members) for members in OTHERS]]


class Elsewhere:
    """What numba-cuda wants to know of the device that it compiles for."""

    compute_capability = CAPABILITY


@pytest.fixture(scope="module", autouse=True)
def compiler() -> None:
    """Tests are skipped where numba-cuda or NVIDIA's compiler libraries are missing."""
    pytest.importorskip("numba_cuda", reason="numba-cuda is not installed")
    try:
        from cuda.bindings import nvrtc, nvvm
        from numba.cuda.cudadrv import libs

        nvvm.version()
        nvrtc.nvrtcGetSupportedArchs()
        if not libs.get_libdevice():
            raise RuntimeError("no libdevice")
    except Exception as error:  # each library has its own way to say so
        pytest.skip(f"NVIDIA's compiler libraries are missing ({type(error).__name__})")


def ptx_of(monkeypatch: Any, kernel: Any, *arguments: Any) -> str:
    """The kernel's program for a card, compiled for arguments like these."""
    from numba import cuda
    from numba.core import types
    from numba.cuda import dispatcher
    from numba.cuda.typing.typeof import typeof

    from snapjump.engine.cuda.methods import register_methods
    from snapjump.engine.cuda.rounding import rounded_as_written

    register_methods()
    monkeypatch.setattr(dispatcher, "get_current_device", Elsewhere)
    with rounded_as_written():
        signature = types.void(*[typeof(argument) for argument in arguments])
        ptx, _ = cuda.compile_ptx(kernel.py_func, signature, cc=CAPABILITY)
    return str(ptx)


def arguments_of(march: Any) -> dict[str, tuple[Any, ...]]:
    """What the kernels are called with, but for arrays on the card."""
    counts, carried = np.zeros((1, 2), dtype=np.int64), np.zeros(1, dtype=np.int64)
    last = (march.memory, march.queue._replace(counts=counts, carried=carried), 1)
    robot = (march.models[0], march.masses)
    return {"find_starts": (*robot, *last), "march": (*robot, march.method, march.recorder, *last)}


def resources(ptx: str, folder: Path) -> dict[str, int]:
    """Registers, stack and spilled bytes of a program's machine code.

    Empty without ptxas, or with one that is older than the program's language.
    """
    ptxas = shutil.which("ptxas")
    if ptxas is None:
        return {}
    source = folder / "kernel.ptx"
    source.write_text(ptx)
    architecture = "-arch=sm_{}{}".format(*CAPABILITY)
    command = [ptxas, "-v", architecture, source, "-o", folder / "kernel.cubin"]
    done = subprocess.run(command, capture_output=True, text=True)
    if "Unsupported .version" in done.stderr:
        return {}
    assert done.returncode == 0, done.stderr
    found = {
        "registers": r"Used (\d+) registers",
        "stack_bytes": r"(\d+) bytes stack frame",
        "spilled_bytes": r"(\d+) bytes spill stores",
    }
    return {name: int(re.findall(pattern, done.stderr)[-1]) for name, pattern in found.items()}


@pytest.mark.parametrize(("kernel", "members"), PROGRAMS)
def test_kernel(kernel, members, monkeypatch, tmp_path):
    from snapjump.engine.cuda import kernels

    arguments = arguments_of(small_march(DESIGNS[:1], 1, **members))[kernel]
    ptx = ptx_of(monkeypatch, getattr(kernels, kernel), *arguments)
    assert ".target sm_90" in ptx
    # Products and sums that could still be merged have no rounding mode.
    assert re.findall(r"\b(?:mul|add|sub)\.f64", ptx) == []
    assert "mul.rn.f64" in ptx and "fma.rn.f64" in ptx
    assert not re.search(r"approx|ftz", ptx)
    # No stack of its own, no memory that threads share, no calls: everything is one program.
    assert "__local_depot" not in ptx and ".shared" not in ptx
    assert not re.search(r"^\s*call", ptx, re.MULTILINE)
    found = resources(ptx, tmp_path)
    if found:
        assert found["spilled_bytes"] < MOST_SPILLED_BYTES
        print(kernel, members, found)
