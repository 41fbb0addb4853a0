"""Where compiled kernels are kept: a folder named after the sources they came from.

numba checks only the file of the function that was called, not those of the functions it uses;
with the hash of all kernel sources in the folder's name, an edited one is never served stale.
"""

import hashlib
import os
from pathlib import Path

import numba

PACKAGE = Path(__file__).resolve().parent.parent
KERNEL_PACKAGES = (
    "clamp",
    "contact",
    "cuda",
    "damping",
    "discretization",
    "ending",
    "engine",
    "frame",
    "friction",
    "integrator",
    "linear_solver",
    "load",
    "number",
    "recorder",
    "statics",
    "stepping",
)


def source_hash() -> str:
    """Hash of every kernel source and of numba's version, 16 hex digits."""
    digest = hashlib.sha256(numba.__version__.encode())
    for package in KERNEL_PACKAGES:
        for path in sorted((PACKAGE / package).glob("*.py")):
            digest.update(path.name.encode())
            digest.update(path.read_bytes())
    return digest.hexdigest()[:16]


def cache_folder() -> Path:
    """The folder of this version's compiled kernels, under the user's cache directory."""
    root = os.environ.get("NUMBA_CACHE_DIR") or os.path.join(
        os.environ.get("XDG_CACHE_HOME") or os.path.expanduser("~/.cache"), "snapjump"
    )
    return Path(root) / f"kernels-{source_hash()}"


def use_cache_folder() -> None:
    """Point numba to :func:`cache_folder`; to be called before any kernel is decorated."""
    numba.config.CACHE_DIR = str(cache_folder())
