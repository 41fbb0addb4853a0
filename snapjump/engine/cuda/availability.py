"""Availability of a card to simulate on, said in one line before any work."""

import os
from importlib.util import find_spec

from snapjump.checks import ParameterError

INSTALL = "pip install 'snapjump[cuda]'"


def check_card(device: int) -> None:
    """Raises ParameterError unless numba-cuda, a driver and the device of that number are here."""

    def missing(what: str) -> ParameterError:
        return ParameterError("backend", "cuda", what)

    if find_spec("numba_cuda") is None:
        raise missing(f"it needs the package numba-cuda, which is not installed ({INSTALL})")
    from numba import cuda

    if not cuda.is_available():
        reason = str(cuda.cuda_error() or "no CUDA device").strip().splitlines()[0]
        raise missing(f"it needs an NVIDIA card and its driver, of which none is found ({reason})")
    count = len(cuda.gpus)
    if device >= count:
        raise ParameterError("backend.device", device, f"an integer in [0, {count - 1}]")


def simulated() -> bool:
    """Whether numba's simulator of a card stands in for one (``NUMBA_ENABLE_CUDASIM=1``)."""
    return os.environ.get("NUMBA_ENABLE_CUDASIM", "0") not in ("", "0")
