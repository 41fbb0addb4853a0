"""A sweep around its jobs: one at a time in a folder, a parent record, and a table at the end."""

import os
import sys
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from hydra.experimental.callback import Callback
from omegaconf import DictConfig, OmegaConf

from snapjump.checks import ParameterError
from snapjump.declare.members import make_member
from snapjump.files.json_file import read_json, write_json
from snapjump.files.lock import FileLock
from snapjump.files.notice import notice
from snapjump.files.provenance import now
from snapjump.run.tasks.base import EXIT_BAD_INPUT
from snapjump.run.tasks.names import cell_name, register_resolvers, sweep_name, task_overrides
from snapjump.run.tasks.tracking import chosen
from snapjump.run.tasks.workers import SWEEP_PROCESS
from snapjump.tracking.base import Record, Tracker, TrackingError
from snapjump.tracking.parts.tracked import milliseconds

# How the jobs, in whatever process, hear of the sweep's name (a cell's own overrides would give
# another one) and of the parent's record.
SWEEP_NAME = "SNAPJUMP_SWEEP"
PARENT_RUN = "SNAPJUMP_PARENT_RUN"
MARK = "sweep.json"
# Where cells are that hydra.sweep.subdir puts elsewhere than where they are sought.
CELLS = ".cells"
MANY = 200  # cells, whose composing takes seconds

register_resolvers()


@dataclass
class Sweep:
    """A sweep that is running: its folder, its cells in order, and where it is recorded."""

    folder: Path
    cells: list[list[str]]
    tracker: Tracker
    lock: FileLock
    started_at: str = field(default_factory=now)
    parent_id: str | None = None

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
            began = milliseconds(self.started_at)
            record = Record(self.folder.name, "FINISHED", began, began, tags={"sweep": "true"})
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


def leave_sweep(sweep: Sweep) -> None:
    """Let another process have the folder of a sweep that has ended."""
    sweep.lock.release()
    _current.clear()


def mark_folder(sweep: Path, name: str, folder: Path) -> None:
    """Leave word of where a cell is. Raises ParameterError for the folder of another cell."""
    if folder == sweep / name:
        return
    for mark in (sweep / CELLS).glob("*.json"):
        if mark.stem != name and cell_folder(sweep, mark.stem) == folder:
            allowed = f"one for each cell, and {mark.stem} has this one"
            raise ParameterError("hydra.sweep.subdir", folder.name, allowed)
    (sweep / CELLS).mkdir(exist_ok=True)
    write_json(sweep / CELLS / f"{name}.json", {"folder": os.path.relpath(folder, sweep)})


def cell_folder(sweep: Path, name: str) -> Path:
    """The folder of a cell."""
    mark = read_json(sweep / CELLS / f"{name}.json") or {}
    return Path(os.path.normpath(sweep / str(mark.get("folder", name))))


class SweepCallback(Callback):
    """Hydra's callback at the start of a sweep."""

    def on_multirun_start(self, config: DictConfig, **others: Any) -> None:
        """Start the sweep; Hydra would turn any Exception from here into a mere warning."""
        os.environ[SWEEP_NAME] = sweep_name(task_overrides(config.hydra))
        os.environ[SWEEP_PROCESS] = str(os.getpid())
        try:
            cells = expand(config)
            folder = Path(config.hydra.sweep.dir).absolute()
            group: Any = OmegaConf.to_container(config.tracking, resolve=True)
            tracker = make_member("tracking", chosen(group, task_overrides(config.hydra)))
            sweep = Sweep(folder, cells, tracker, FileLock(folder / ".lock"))
            sweep.start()
        except OSError as error:
            allowed = f"a folder that can be written to ({error.strerror})"
            refused = ParameterError("hydra.sweep.dir", str(config.hydra.sweep.dir), allowed)
            print(refused, file=sys.stderr)
            raise SystemExit(EXIT_BAD_INPUT) from error
        except ParameterError as error:
            print(error, file=sys.stderr)
            raise SystemExit(EXIT_BAD_INPUT) from error
        _current[:] = [sweep]
        if len(cells) > MANY:
            notice(f"{len(cells)} cells in {folder}; all are composed before the first begins")


def expand(config: DictConfig) -> list[list[str]]:
    """The overrides of every cell, just as Hydra's own sweeper makes them."""
    from hydra._internal.core_plugins.basic_sweeper import BasicSweeper
    from hydra.core.override_parser.overrides_parser import OverridesParser
    from hydra.errors import HydraException

    sweeper = config.hydra.sweeper
    if not sweeper._target_.endswith(".BasicSweeper"):
        raise ParameterError("hydra/sweeper", sweeper._target_, "basic")
    given = [f"{key}={value}" for key, value in (sweeper.params or {}).items()]
    try:
        overrides = OverridesParser.create().parse_overrides(
            [*given, *task_overrides(config.hydra)]
        )
        (cells,) = BasicSweeper.split_arguments(overrides, None)
    except HydraException as error:
        raise ParameterError("command line", task_overrides(config.hydra), str(error)) from error
    by_name = {cell_name(cell): cell for cell in cells}
    return list(by_name.values())
