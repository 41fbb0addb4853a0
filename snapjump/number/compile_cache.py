"""Cache of compiled kernels on disk: a folder named after the sources they came from.

numba checks only the file of the function that was called, not those of the functions it uses;
with the hash of all kernel sources in the folder's name, an edited one is never served stale. It
also tells sources apart by where they lie, and functions by their lines: with the hash, a copy, a
new checkout or one with other comments finds what was compiled for the same sources.
"""

import os
from pathlib import Path
from typing import Any

import numba
from numba.core.caching import UserProvidedCacheLocator

from snapjump.files import sources
from snapjump.files.kept_hashes import cache_root
from snapjump.number.old_kernels import remove_old, use

KERNEL_PACKAGES = (
    "contact",
    "damping",
    "discretization",
    "engine",
    "frame",
    "friction",
    "integrator",
    "linear_solver",
    "number",
    "statics",
    "stepping",
)
# numba's own, for functions of others: from files, and from notebooks.
NUMBA_LOCATORS = "UserProvidedCacheLocator,IPythonCacheLocator"


def source_hash() -> str:
    """Hash of every kernel source, plug-ins included, and of numba's version, 16 hex digits."""
    own = [source for source in sources.package_files() if source.part in KERNEL_PACKAGES]
    code = [source for source in (*own, *sources.plugin_files()) if source.path.suffix == ".py"]
    return sources.combined_hash(code, numba.__version__)[:16]


def cache_folder() -> Path:
    """The folder of this version's compiled kernels, under the user's cache directory."""
    return cache_root() / f"kernels-{source_hash()}"


class KernelLocator(UserProvidedCacheLocator):
    """Finds a kernel by its file's place in the package, in a folder that answers for the rest."""

    def __init__(self, py_func: Any, py_file: str):
        super().__init__(py_func, py_file)
        place = Path(py_file).resolve().relative_to(sources.PACKAGE).with_suffix("")
        self._cache_path = os.path.join(numba.config.CACHE_DIR, *place.parts)

    def get_source_stamp(self) -> str:
        """What the folder's name says already: the hash of all kernel sources."""
        return os.path.basename(numba.config.CACHE_DIR)

    def get_disambiguator(self) -> str:
        """Nothing, wherever the function stands: a module has no two of one name."""
        return ""

    @classmethod
    def from_function(cls, py_func: Any, py_file: str) -> Any:
        """None for functions that are not a module's of this package: numba has ways for them."""
        of_a_module = py_func.__qualname__ == py_func.__name__
        if not of_a_module or not Path(py_file).resolve().is_relative_to(sources.PACKAGE):
            return None
        return super().from_function(py_func, py_file)


def use_cache_folder() -> None:
    """Point numba to :func:`cache_folder`; to be called before any kernel is decorated.

    A new folder takes the place of those that are no longer used.
    """
    folder = cache_folder()
    is_new = not folder.exists()
    use(folder)
    if is_new:
        remove_old(folder)
    numba.config.CACHE_DIR = str(folder)
    others = os.environ.get("NUMBA_CACHE_LOCATOR_CLASSES") or NUMBA_LOCATORS
    numba.config.CACHE_LOCATOR_CLASSES = f"{__name__}.{KernelLocator.__name__},{others}"
