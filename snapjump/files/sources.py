"""Source files of the package and of plug-ins, and one hash of several.

A process computes by the sources that it has imported, whatever becomes of the files while it
runs: each is hashed as it was when it was first asked for, and the package's are listed once.
"""

import hashlib
import os
from collections.abc import Iterable
from functools import cache
from pathlib import Path
from typing import NamedTuple

from snapjump.files.kept_hashes import kept_hashes

PACKAGE = Path(__file__).resolve().parents[1]
# Folders of members from outside, absolute, and laid out as the package is: <group>/<member>.py or
# .yaml.
PLUGINS: list[Path] = []
SUFFIXES = (".py", ".yaml")
BESIDE = ("conf", "experiments")  # lie beside the package in a clone
_seen: dict[Path, str] = {}


class Source(NamedTuple):
    """``name``: the path within the package or the folder of plug-ins, with slashes."""

    name: str
    path: Path

    @property
    def part(self) -> str:
        """The subpackage, group or file at the top."""
        return self.name.split("/", 1)[0]


def package_files() -> list[Source]:
    """The package's Python, and its tableaux; not what only a wheel has within the package."""
    return _files_in(PACKAGE)


@cache
def _files_in(package: Path) -> list[Source]:
    found = [
        Source(path.relative_to(package).as_posix(), path)
        for folder, _, names in os.walk(package)
        for path in (Path(folder, name) for name in names if name.endswith(SUFFIXES))
    ]
    return [source for source in found if source.part not in BESIDE]


def plugin_files() -> list[Source]:
    """The files in the groups of all folders of plug-ins, wherever these lie."""
    return [
        Source(path.relative_to(folder).as_posix(), path)
        for folder in PLUGINS
        for suffix in SUFFIXES
        for path in folder.glob(f"*/*{suffix}")
    ]


def combined_hash(sources: Iterable[Source], *more: str) -> str:
    """A hash of names and of what the files say, in any order, and of more; 64 hex digits."""
    sources = list(sources)
    unseen = [source.path for source in sources if source.path not in _seen]
    if unseen:
        with kept_hashes() as file_hash:
            _seen.update((path, file_hash(path)) for path in unseen)
    digest = hashlib.sha256("\0".join(more).encode())
    for name, found in sorted((source.name, _seen[source.path]) for source in sources):
        digest.update(f"\0{name}\0{found}".encode())
    return digest.hexdigest()


def forget(folder: Path) -> None:
    """Have the files below a folder hashed anew: what was imported from them is again, too."""
    _files_in.cache_clear()
    for path in [path for path in _seen if path.is_relative_to(folder)]:
        del _seen[path]
