"""The folder of a dataset: what lies where, who may write, and whether it is this dataset's.

    dataset.json               the specification: everything that determines the numbers
    shards/shard-00000.parquet rows of a stretch of the plan
    shards/_shard-00000.json   its entry: checksums of file and content, statuses
    manifest.json              the contents of all entries, and the hash of the dataset

A shard counts once its entry lies beside it, and an entry is written after its shard: whatever is
interrupted, there is an entry only of a shard that is whole. Readers of Parquet take ``shards`` for
one table: they pass over files whose name begins with an underscore.
"""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from snapjump.checks import ParameterError, of_ours
from snapjump.dataset.specification import Specification, first_difference
from snapjump.files.lock import FileLock
from snapjump.files.sealed import read_sealed, write_sealed
from snapjump.plan.parts.axes import recorded_axes

DIGITS = 8  # of hashes in names
SPECIFICATION, MANIFEST, SHARDS = "dataset.json", "manifest.json", "shards"
DEFAULT = Path("outputs/datasets")


class DatasetFolder:
    """Names of the files in a folder."""

    def __init__(self, path: Path):
        self.path = Path(path).absolute()
        self.specification = self.path / SPECIFICATION
        self.manifest = self.path / MANIFEST

    def shard(self, number: int) -> Path:
        """The rows of a shard."""
        return self.path / SHARDS / f"shard-{number:05d}.parquet"

    def entry(self, number: int) -> Path:
        """The entry of a finished shard: checksums and statuses."""
        path = self.path / SHARDS / f"_shard-{number:05d}.json"
        former = path.with_name(path.name[1:])
        return former if former.exists() and not path.exists() else path

    def claim(self, part: int, parts: int) -> list[FileLock]:
        """Locks of one who generates the whole, or one of several parts.
        Raises ParameterError if another process is at it."""
        locks = [FileLock(self.path / ".lock", shared=parts > 1)]
        if parts > 1:
            locks.append(FileLock(self.path / f".lock-{part}-of-{parts}"))
        for taken, lock in enumerate(locks):
            if not lock.acquire(wait=False):
                for other in locks[:taken]:
                    other.release()
                raise self.refused("a folder that no other process writes to")
        return locks

    def check(self, specification: Specification) -> None:
        """Raise ParameterError for a folder of something else, or of another dataset."""
        if self.path.exists() and not self.path.is_dir():
            raise self.refused("a folder, and this is a file")
        if not self.specification.exists():
            self._check_empty()
            return
        there = read_sealed(self.specification)
        if there is None:
            raise self.refused(f"a folder whose {SPECIFICATION} is not damaged")
        mine = specification.plain
        with of_ours(lambda reason: self.refused(f"a folder of a dataset: {reason}")):
            found = first_difference(by_path(mine), by_path(there)) or first_difference(mine, there)
        if found is None:
            return
        key, ours, theirs = found
        # As it is called on the command line.
        named = {"shard_size": "dataset.shard_size", "processor": "backend"}.get(key, key)
        named = named.removeprefix("configuration.")
        named = f"plan.{named}" if named.startswith("inputs") else named
        allowed = f"{theirs!r} to go on with {self.path}, or another dataset.path"
        raise ParameterError(named, ours, allowed)

    def open(self, specification: Specification) -> None:
        """Make what is not there yet."""
        (self.path / SHARDS).mkdir(parents=True, exist_ok=True)
        if not self.specification.exists():
            write_sealed(self.specification, specification.plain)

    def sweep(self, numbers: list[int]) -> None:
        """Remove what killed processes left half-written of these shards."""
        names = {file.name for n in numbers for file in (self.shard(n), self.entry(n))}
        for left in (self.path / SHARDS).glob(".*"):
            if left.name[1:].rpartition(".")[0] in names:
                left.unlink(missing_ok=True)

    def refused(self, allowed: str) -> ParameterError:
        return ParameterError("dataset.path", str(self.path), allowed)

    def _check_empty(self) -> None:
        files = self.path.iterdir() if self.path.is_dir() else ()
        if [f for f in files if not f.name.startswith(".") and f.name != SHARDS]:
            raise self.refused(f"a new folder, or one with a {SPECIFICATION}")


def by_path(plain: Mapping[str, Any]) -> dict[str, Any]:
    """A plain specification with the ranges of its inputs by their paths."""
    return {**plain, "inputs": {axis.path: list(axis.range) for axis in recorded_axes(plain)}}


def default_path(specification: Specification) -> Path:
    """A folder named after all that determines the dataset."""
    plan = specification.plain["plan"]["name"]
    tier = specification.simulation.accuracy
    return DEFAULT / f"{plan}-{tier}-{specification.sha256[:DIGITS]}"
