"""The folder of one job: which files it holds, and how each is written and read."""

import shutil
from collections.abc import Callable, Mapping
from contextlib import suppress
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np
import yaml

from snapjump.files.atomic import atomic_file, flush, write_text
from snapjump.files.former_names import with_present_names
from snapjump.files.json_file import read_json, write_json
from snapjump.files.lock import FileLock
from snapjump.files.notice import notice

# Where a run is recorded says nothing about what it computes.
NOT_PHYSICS = ("tracking", "objective")

PROVENANCE, TRACEBACK = "provenance.json", "traceback.txt"
DRAWING = ".figures."
ALWAYS = ("config.yaml", PROVENANCE, "result.json")
Stamp = tuple[int, int]  # what tells that a file was written anew

LONGEST_REASON = 300  # characters of why a picture was not drawn


class ResultFolder:
    """``config.yaml``, ``provenance.json``, ``trajectory.npz``, figures, and ``result.json``.
    ``result.json`` is written last: where it says that a job is finished, all else is there.

    The folder may hold files of others; ``provenance.json`` lists those of the job.
    """

    def __init__(self, path: Path):
        self.path = Path(path)
        self.lock = FileLock(self.path / ".lock")
        self._found: dict[str, Stamp] | None = None

    def taken(self) -> list[str]:
        """Names of ours that files of somebody else have: a job here would replace them."""
        if self.provenance() is not None or "task" in (self.config() or {}):
            return []
        return [name for name in ALWAYS if (self.path / name).exists()]

    def begin(self) -> None:
        """Remove the files of an earlier job, so that none can pass for one of the next, and note
        which others are there. Once for each job."""
        if self._found is None:
            for name in (*ALWAYS, TRACEBACK, *self._listed()):
                (self.path / name).unlink(missing_ok=True)
            for left in self.path.glob(f"{DRAWING}*"):  # of a job that was killed
                shutil.rmtree(left, ignore_errors=True)
            self._found = {file.name: stamp(file) for file in self._all()}

    def withdraw(self) -> None:
        """Leave no trace of a job that was refused; a folder with anything else in it stays."""
        if self._found is not None:
            for file in self._new():
                file.unlink()
        self.lock.remove()
        with suppress(OSError):  # not empty
            self.path.rmdir()

    def write_config(self, config: Mapping[str, Any]) -> None:
        """Write the configuration with every reference resolved."""
        write_text(self.path / "config.yaml", yaml.safe_dump(dict(config), sort_keys=False))

    def write_provenance(self, content: Mapping[str, Any]) -> None:
        """Write where the job's files come from, and which they are: from now on no more."""
        own = {file.name for file in self._new()}
        write_json(self.path / PROVENANCE, {**content, "files": sorted({*own, *ALWAYS})})
        self._found = None

    def write_result(self, content: Mapping[str, Any]) -> list[str]:
        """Write the flat result; returns the keys whose numbers were not finite."""
        return write_json(self.path / "result.json", content)

    def write_arrays(self, name: str, arrays: Mapping[str, Any]) -> list[str]:
        """Write ``<name>.npz``; arrays that are not finite are left out, and their names returned.
        Writes no file if nothing is left."""
        kept = {
            key: array
            for key, array in arrays.items()
            if array.dtype.kind not in "fc" or bool(np.isfinite(array).all())
        }
        if kept:
            with atomic_file(self.path / f"{name}.npz", "wb") as file:
                np.savez_compressed(file, allow_pickle=False, **kept)
        return [key for key in arrays if key not in kept]

    def write_figures(self, draw: Callable[[Path], Any]) -> bool:
        """Let ``draw`` fill a folder, and take its files over once all of them are complete.

        False for pictures that cannot be drawn (fonts, memory, a full disk): that is told, and
        takes no result along.
        """
        try:
            with TemporaryDirectory(prefix=DRAWING, dir=self.path) as folder:
                draw(Path(folder))
                for file in sorted(Path(folder).iterdir()):
                    flush(file)
                    file.replace(self.path / file.name)
        except Exception as error:
            reason = " ".join(f"{type(error).__name__}: {error}".split())
            notice(f"figures not drawn: {reason[:LONGEST_REASON]}")
            return False
        return True

    def result(self) -> dict[str, Any] | None:
        """The result, if there is one, under the names of today."""
        found = read_json(self.path / "result.json")
        return None if found is None else with_present_names(found, self.config)

    def provenance(self) -> dict[str, Any] | None:
        return read_json(self.path / PROVENANCE)

    def config(self) -> dict[str, Any] | None:
        try:
            content = yaml.safe_load((self.path / "config.yaml").read_text(encoding="utf-8"))
        except (OSError, ValueError, RecursionError, yaml.YAMLError):
            return None
        return content if isinstance(content, dict) else None

    def files(self) -> list[Path]:
        """The files of the job, by name; of one that was killed those that every job has."""
        if self._found is not None:
            return self._new()
        listed = self._listed() or ALWAYS
        return [file for file in self._all() if file.name in listed]

    def _new(self) -> list[Path]:
        """Files that were written since the job began."""
        before = self._found or {}
        return [file for file in self._all() if before.get(file.name) != stamp(file)]

    def _all(self) -> list[Path]:
        files = self.path.iterdir() if self.path.is_dir() else ()
        return sorted(file for file in files if file.is_file() and not file.name.startswith("."))

    def _listed(self) -> list[str]:
        """Names in the provenance, which somebody may have edited: none leads elsewhere."""
        listed = (self.provenance() or {}).get("files")
        names = listed if isinstance(listed, list) else []
        return [name for name in names if isinstance(name, str) and Path(name).name == name]

    def holds(
        self,
        config: Mapping[str, Any],
        source_sha256: str,
        outside: Mapping[str, str],
        done: frozenset[str],
    ) -> bool:
        """Whether this very computation, by the same code, has ended in one of ``done`` here, and
        all its files are there.
        ``outside``: digests of what it reads and leaves elsewhere, as they are now."""
        result, origin = self.result() or {}, self.provenance() or {}
        return (
            str(result.get("status")) in done
            and origin.get("source_sha256") == source_sha256
            and origin.get("outside", {}) == outside
            and physics(self.config() or {}) == physics(config)
            and all((self.path / name).is_file() for name in self._listed())
        )


def stamp(file: Path) -> Stamp:
    """A file's number and time: whoever writes a file whole gives it another number."""
    found = file.stat()
    return found.st_ino, found.st_mtime_ns


def physics(config: Mapping[str, Any]) -> dict[str, Any]:
    """A configuration without what says nothing about results."""
    return {key: value for key, value in config.items() if key not in NOT_PHYSICS}
