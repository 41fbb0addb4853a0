"""A sweep around its jobs: one at a time in a folder, a parent record, and a table at the end."""

import os
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from snapjump.checks import ParameterError
from snapjump.files.json_file import read_json, write_json
from snapjump.files.lock import FileLock
from snapjump.files.provenance import now
from snapjump.run.tasks.names import cell_name, command, key_of, register_resolvers, swept_keys
from snapjump.tracking.base import Record, State, Tracker, TrackingError
from snapjump.tracking.parts.tracked import milliseconds

# How the jobs, in whatever process, hear of the sweep's name (a cell's own overrides would give
# another one), of the parent's record, and of a sweeper that optimises.
SWEEP_NAME = "SNAPJUMP_SWEEP"
PARENT_RUN = "SNAPJUMP_PARENT_RUN"
OPTIMISED = "SNAPJUMP_OPTIMISED"
MARK = "sweep.json"
# Where cells are that hydra.sweep.subdir puts elsewhere than where they are sought.
CELLS = ".cells"

register_resolvers()


@dataclass
class Sweep:
    """A sweep that is running: its folder, the overrides that it is of, where it is recorded.

    ``cells``: in order; None where a sweeper that optimises chooses them as it goes.
    """

    folder: Path
    overrides: list[str]
    cells: list[list[str]] | None
    tracker: Tracker
    lock: FileLock
    started_at: str = field(default_factory=now)
    parent_id: str | None = None

    @property
    def title(self) -> str:
        """What it is, for people."""
        return f"sweep over {', '.join(swept_keys()) or 'nothing'}"

    def record(self, state: State, ended_at: str, **parts: Any) -> Record:
        """Its own record: what it is of, and by which command."""
        tags = {"sweep": "true", "command": command(["-m", *self.overrides]), "task": "sweep"}
        tags |= {"mlflow.source.name": "snapjump", **parts.pop("tags", {})}
        params = {key_of(text): text.partition("=")[2] for text in self.overrides}
        times = milliseconds(self.started_at), milliseconds(ended_at)
        return Record(self.title, state, *times, params, tags=tags, **parts)

    def start(self) -> None:
        """Claim the folder and open the parent record; raises ParameterError."""
        if not self.lock.acquire(wait=False):
            raise ParameterError(
                "hydra.sweep.dir", str(self.folder), "a folder where no sweep is running"
            )
        self.tracker.check()
        mark = read_json(self.folder / MARK) or {}
        same_place = mark.get("place") == self.tracker.place
        try:
            record = self.record("FINISHED", self.started_at)
            self.parent_id = self.tracker.open(
                record, mark.get("parent_id") if same_place else None
            )
        except TrackingError as error:
            raise ParameterError("tracking", self.tracker.place, str(error)) from error
        write_json(self.folder / MARK, {"place": self.tracker.place, "parent_id": self.parent_id})
        if self.parent_id is None:
            os.environ.pop(PARENT_RUN, None)
        else:
            os.environ[PARENT_RUN] = self.parent_id


_current: list[Sweep] = []


def current_sweep() -> Sweep | None:
    """The sweep of this process, if it runs one."""
    return _current[0] if _current else None


def begin_sweep(sweep: Sweep) -> None:
    """Let this process have a sweep."""
    _current[:] = [sweep]


def leave_sweep(sweep: Sweep) -> None:
    """Let another process have the folder of a sweep that has ended."""
    sweep.lock.release()
    _current.clear()


def mark_folder(sweep: Path, overrides: list[str], folder: Path) -> None:
    """Leave word of where a cell is. Raises ParameterError for the folder of another cell."""
    name = cell_name(overrides)
    if folder == sweep / name and OPTIMISED not in os.environ:
        return
    for mark in (sweep / CELLS).glob("*.json"):
        if mark.stem != name and cell_folder(sweep, mark.stem) == folder:
            allowed = f"one for each cell, and {mark.stem} has this one"
            raise ParameterError("hydra.sweep.subdir", folder.name, allowed)
    (sweep / CELLS).mkdir(exist_ok=True)
    told = {"folder": os.path.relpath(folder, sweep), "overrides": overrides}
    write_json(sweep / CELLS / f"{name}.json", told)


def cell_folder(sweep: Path, name: str) -> Path:
    """The folder of a cell."""
    mark = read_json(sweep / CELLS / f"{name}.json") or {}
    return Path(os.path.normpath(sweep / str(mark.get("folder", name))))


def cells_of(sweep: Sweep) -> list[list[str]]:
    """The overrides of every cell; of a sweeper that optimises those that it has tried."""
    if sweep.cells is not None:
        return sweep.cells
    marks = sorted((sweep.folder / CELLS).glob("*.json"), key=lambda mark: mark.stat().st_mtime_ns)
    return [(read_json(mark) or {}).get("overrides", []) for mark in marks]
