"""Cache of compiled kernels on disk: a folder named after the sources they came from.

numba checks only the file of the function that was called, not those of the functions it uses;
with the hash of all kernel sources in the folder's name, an edited one is never served stale. It
also tells sources apart by where they lie, and functions by their lines: with the hash, a copy, a
new checkout or one with other comments finds what was compiled for the same sources.

There is no other cache: where that folder cannot be written, kernels are compiled in each process.
"""

import sys
from contextlib import suppress
from pathlib import Path
from typing import Any

import numba
from numba.core.caching import CompileResultCacheImpl, FunctionCache, NullCache

from snapjump.files import sources
from snapjump.files.kept_hashes import cache_root
from snapjump.files.notice import notice
from snapjump.number.announcement import announce
from snapjump.number.old_kernels import remove_old, use

KERNEL_PACKAGES = (
    "contact",
    "damping",
    "discretization",
    "drag",
    "drive",
    "engine",
    "frame",
    "friction",
    "integrator",
    "linear_solver",
    "number",
    "statics",
    "stepping",
)
_place: list[Path] = []  # the folder in use
_told: set[str] = set()  # why kernels could not be kept


def source_hash() -> str:
    """Hash of every kernel source, plug-ins included, and of numba's version, 16 hex digits."""
    own = [source for source in sources.package_files() if source.part in KERNEL_PACKAGES]
    code = [source for source in (*own, *sources.plugin_files()) if source.path.suffix == ".py"]
    return sources.combined_hash(code, numba.__version__)[:16]


def cache_folder() -> Path:
    """The folder of this version's compiled kernels, under the user's cache directory."""
    return cache_root() / f"kernels-{source_hash()}"


def folder_in_use() -> Path:
    """The folder that this process keeps its kernels in."""
    return _place[-1]


def use_cache_folder() -> None:
    """Keep kernels in :func:`cache_folder` from now on; to be called before any is decorated.

    A new folder takes the place of those that are no longer used.
    """
    folder = cache_folder()
    is_new = not folder.exists()
    use(folder)
    if is_new:
        remove_old(folder)
    _place[:] = [folder]


def kernel_cache(py_func: Any) -> Any:
    """The cache of a kernel; none for one from elsewhere, whose edits the hash does not see."""
    is_ours = Path(py_func.__code__.co_filename).resolve().is_relative_to(sources.PACKAGE)
    return KernelCache(py_func) if is_ours else NullCache()


class KernelCache(FunctionCache):
    """The compiled programs of one kernel on disk; without a disk, kernels are compiled anew."""

    class _impl_class(CompileResultCacheImpl):  # noqa: N801
        """Finds a kernel by its file's place in the package, in a folder that answers for the
        rest: for what else numba looks at it has this one answer, wherever the function stands."""

        def __init__(self, py_func: Any):
            self._lineno = py_func.__code__.co_firstlineno
            self._locator = self
            self._py_file = py_func.__code__.co_filename
            place = Path(self._py_file).resolve().relative_to(sources.PACKAGE).with_suffix("")
            self._folder = folder_in_use()
            self._path = self._folder / place
            self._filename_base = self.get_filename_base(py_func.__qualname__, sys.abiflags)

        def get_cache_path(self) -> str:
            return str(self._path)

        def ensure_cache_path(self) -> None:
            self._path.mkdir(parents=True, exist_ok=True)

        def get_source_stamp(self) -> str:
            return self._folder.name

        def get_disambiguator(self) -> str:
            return ""  # a module has no two of one name

    def holds(self, sig: Any, target_context: Any) -> bool:
        """Whether there is a program for a signature."""
        try:
            key = self._index_key(sig, target_context.codegen())
            return key in self._cache_file._load_index()
        except Exception:  # half a file
            return False

    def load_overload(self, sig: Any, target_context: Any) -> Any:
        """The program for a signature; None if there is none that can be read, which is told,
        since it is compiled next."""
        found = None
        try:
            found = super().load_overload(sig, target_context)
        except Exception:
            # Half a file, after the machine went down: its index would stay in the way.
            with suppress(OSError):
                self.flush()
        if found is None:
            announce(self._py_func.__name__)
        return found

    def save_overload(self, sig: Any, data: Any) -> None:
        """Keep a program, or tell why that cannot be: the disk is full, or may not be written."""
        try:
            super().save_overload(sig, data)
        except OSError as error:
            reason = error.strerror or str(error)
            if reason not in _told:
                _told.add(reason)
                told = f"warning: compiled kernels are not kept in {folder_in_use()} ({reason}); "
                notice(f"{told}the next process compiles them again")
