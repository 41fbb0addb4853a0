"""Where compiled kernels are kept: a folder named after the sources they came from.

numba checks only the file of the function that was called, not those of the functions it uses;
with the hash of all kernel sources in the folder's name, an edited one is never served stale. It
also tells sources apart by where they lie, and some of its versions by their dates: with the hash,
a copy or a new checkout finds what was compiled for the same sources.
"""

import hashlib
import os
from pathlib import Path
from typing import Any

import numba
from numba.core.caching import UserProvidedCacheLocator

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
# numba's own, for functions of others: from files, and from notebooks.
NUMBA_LOCATORS = "UserProvidedCacheLocator,IPythonCacheLocator"


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


class KernelLocator(UserProvidedCacheLocator):
    """Finds a kernel by its file's place in the package, in a folder that answers for the rest."""

    def __init__(self, py_func: Any, py_file: str):
        super().__init__(py_func, py_file)
        place = Path(py_file).resolve().relative_to(PACKAGE).with_suffix("")
        self._cache_path = os.path.join(numba.config.CACHE_DIR, *place.parts)

    def get_source_stamp(self) -> str:
        """What the folder's name says already: the hash of all kernel sources."""
        return os.path.basename(numba.config.CACHE_DIR)

    @classmethod
    def from_function(cls, py_func: Any, py_file: str) -> Any:
        """None for functions that are not of this package: numba has a way of its own for them."""
        if not Path(py_file).resolve().is_relative_to(PACKAGE):
            return None
        return super().from_function(py_func, py_file)


def use_cache_folder() -> None:
    """Point numba to :func:`cache_folder`; to be called before any kernel is decorated."""
    numba.config.CACHE_DIR = str(cache_folder())
    others = os.environ.get("NUMBA_CACHE_LOCATOR_CLASSES") or NUMBA_LOCATORS
    numba.config.CACHE_LOCATOR_CLASSES = f"{__name__}.{KernelLocator.__name__},{others}"
