"""Finished cells on disk, each in a file of its own, so that no finished work is done twice."""

from dataclasses import replace
from pathlib import Path

from snapjump.checks import ParameterError
from snapjump.files.json_file import finite, read_json, write_json
from snapjump.files.lock import FileLock
from snapjump.run.studies.base import FAILED, Cell, Done
from snapjump.run.tasks.names import readable_name


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
        """This very cell as it was finished, or None."""
        kept = read_json(self.file(cell))
        inputs, _ = finite(cell.inputs)
        if kept is None or kept.pop("name") != cell.name or kept.pop("inputs") != inputs:
            return None
        return Done(cell=cell, **kept)

    def save(self, done: Done) -> Done:
        """Keep a cell, unless it failed; returns it as :meth:`load` would."""
        rows, _ = finite(done.rows)
        clean = replace(done, rows=rows)
        if done.status != FAILED:
            own = {key: value for key, value in vars(clean).items() if key != "cell"}
            write_json(self.file(done.cell), {**vars(done.cell), **own})
        return clean
