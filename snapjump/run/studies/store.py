"""Finished cells on disk, each in a file of its own, so that no finished work is done twice."""

from dataclasses import fields, replace
from pathlib import Path

from snapjump.checks import ParameterError
from snapjump.files.json_file import finite
from snapjump.files.lock import FileLock
from snapjump.files.notice import notice
from snapjump.files.sealed import read_sealed, write_sealed
from snapjump.run.studies.base import FAILED, Cell, Done
from snapjump.run.tasks.names import readable_name

OF_A_CELL = tuple(one.name for one in fields(Done) if one.name != "cell")


class CellStore:
    """The cells of one study; one process at a time (``with store:``) works on them."""

    def __init__(self, path: Path):
        self.path = Path(path)
        self._lock = FileLock(self.path / ".lock")

    def __enter__(self) -> "CellStore":
        if not self._lock.acquire(wait=False):
            raise ParameterError("task", str(self.path), "a study that no other process is doing")
        return self

    def __exit__(self, *error: object) -> None:
        self._lock.release()

    def file(self, cell: Cell) -> Path:
        return self.path / f"{readable_name(cell.name)}.json"

    def load(self, cell: Cell) -> Done | None:
        """This very cell as it was finished, or None; a file that was edited since is told."""
        file, wanted = self.file(cell), finite(vars(cell))[0]
        kept = read_sealed(file)
        if kept is None:
            if file.exists():
                notice(f"done again: {file} is not what was written")
            return None
        if {key: kept.get(key) for key in wanted} != wanted or not kept.keys() >= {*OF_A_CELL}:
            return None
        return Done(cell, **{key: kept[key] for key in OF_A_CELL})

    def save(self, done: Done) -> Done:
        """Keep a cell, unless it failed; returns it as :meth:`load` would."""
        rows, _ = finite(done.rows)
        clean = replace(done, rows=rows)
        if done.status != FAILED:
            own = {key: getattr(clean, key) for key in OF_A_CELL}
            write_sealed(self.file(done.cell), finite({**vars(done.cell), **own})[0])
        return clean
