"""One job of Hydra's, a run or a cell of a sweep: done, recorded, told, and its exit code."""

import math
import os
import re
import sys
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path
from typing import Any

from hydra.core.hydra_config import HydraConfig
from hydra.types import RunMode
from omegaconf import DictConfig, OmegaConf
from omegaconf.errors import OmegaConfBaseException

from snapjump.checks import ParameterError, is_finite_number
from snapjump.declare.fields import construct
from snapjump.declare.members import make_member
from snapjump.declare.plugins import load_all
from snapjump.files.provenance import now, source_hash
from snapjump.files.result_folder import ResultFolder
from snapjump.robot.other_units import in_own_units
from snapjump.robot.robot import Robot
from snapjump.run.tasks import base
from snapjump.run.tasks.base import Outcome, Task
from snapjump.run.tasks.execute import check_run, execute, write_outcome
from snapjump.run.tasks.hydra_errors import one_line
from snapjump.run.tasks.live import Live
from snapjump.run.tasks.names import cell_name, command, key_of, register_resolvers, task_overrides
from snapjump.run.tasks.registry import find_task
from snapjump.run.tasks.sweep import PARENT_RUN, mark_folder
from snapjump.run.tasks.tracking import chosen
from snapjump.run.tasks.workers import end_with_sweep
from snapjump.show.terminal.block import block, heading_width, number
from snapjump.show.terminal.progress import ProgressBar
from snapjump.tracking.base import Tracker, TrackingError
from snapjump.tracking.parts.tracked import MARK, OWN, record_folder

DAY = re.compile(r"\d{4}-\d{2}-\d{2}")  # the folder of a day's runs

# A worker process of a parallel sweep imports this module, and nothing before it.
register_resolvers()


def run_job(composed: DictConfig) -> int:
    """Do one job as configured; returns the exit code. Called by Hydra, in any process."""
    hydra = HydraConfig.get()
    # Paths are relative to where the command is run, whatever hydra.job.chdir says.
    os.chdir(hydra.runtime.cwd)
    folder = ResultFolder(Path(hydra.runtime.output_dir))
    overrides = task_overrides(hydra)
    try:
        config: Any = OmegaConf.to_container(composed, resolve=True, throw_on_missing=True)
        load_all(config.get("plugins"))
        config["tracking"] = chosen(config.get("tracking"), overrides)
        given = set(map(key_of, overrides))
        config = in_own_units(config, given, construct("robot", Robot, config.get("robot")))
        if folder.taken():
            allowed = f"a folder without a {folder.taken()[0]} of something else"
            raise ParameterError("hydra.run.dir", str(folder.path), allowed)
        if hydra.mode == RunMode.MULTIRUN:
            return run_cell(config, folder, overrides)
        return run_alone(config, folder, overrides)
    except OmegaConfBaseException as error:
        return _refused(str(one_line(error, overrides)), folder)
    except ParameterError as error:
        return _refused(str(error), folder)
    finally:
        folder.lock.remove()


def objective(composed: DictConfig) -> float | None:
    """What a sweeper that optimises is told of a job: an output, or the worst there is for one that
    failed or has none. None where nothing is optimised."""
    name = composed.get("objective")
    if name is None:
        return None
    value: Any = (ResultFolder(Path(HydraConfig.get().runtime.output_dir)).result() or {}).get(name)
    if is_finite_number(value):
        return float(value)
    minimised = "min" in str(HydraConfig.get().sweeper.get("direction", "minimize")).lower()
    return math.inf if minimised else -math.inf


def run_alone(config: Mapping[str, Any], folder: ResultFolder, overrides: list[str]) -> int:
    """One job on its own: the closing block on stdout, an error in one line on stderr.
    Raises ParameterError for bad input."""
    if not folder.lock.acquire(wait=False):
        raise ParameterError("hydra.run.dir", str(folder.path), "a folder that no other run uses")
    tracker = make_member("tracking", config["tracking"])
    tracker.check()
    live = Live(tracker, folder, command(overrides))
    outcome, task = execute(config, folder, overrides, ProgressBar(), live)
    if outcome.status == base.BAD_INPUT:
        return _refused(outcome.message, folder)
    code = ended = base.exit_code(outcome.status)
    if live.run_id is None:
        (folder.path / MARK).unlink(missing_ok=True)  # of a run that was here before
    width = 0 if task is None else _tell(task, outcome, folder)
    place, interrupted = "", False
    try:
        place = record_folder(tracker, folder)
    except (TrackingError, OSError, KeyboardInterrupt) as error:
        interrupted = isinstance(error, KeyboardInterrupt)
        again = command([f"record={os.path.relpath(folder.path)}"])
        print(f"not recorded: {str(error) or 'interrupted'}; {again} does it", file=sys.stderr)
        code = code or (base.EXIT_INTERRUPTED if interrupted else base.EXIT_UNTRACKED)
    if task is not None and place:
        print(f"  {'tracking'.ljust(width)}{place}")
    if ended != base.EXIT_OK:
        print(f"{outcome.status}: {outcome.message}", file=sys.stderr)
    return code


def run_cell(config: Mapping[str, Any], folder: ResultFolder, overrides: list[str]) -> int:
    """One cell of a sweep: done only if it is not yet, and told in one line."""
    end_with_sweep()
    folder.lock.acquire()  # of a sweep that was killed, a worker may still be at it
    tracker, name = make_member("tracking", config["tracking"]), cell_name(overrides)
    mark_folder(Path(HydraConfig.get().sweep.dir).absolute(), overrides, folder.path.absolute())
    parent_id = os.environ.get(PARENT_RUN)
    if is_done(config, folder):
        result = folder.result() or {}
        _record(tracker, folder, name, parent_id)
        print(f"{name}: {result['status']} (kept)", flush=True)
        return base.EXIT_OK
    started_at, published = now(), config.get("publish")
    if published is None:
        live = Live(tracker, folder, command(overrides), name=name, parent_id=parent_id)
        outcome, _ = execute(config, folder, overrides, ProgressBar(visible=False), live)
    else:
        allowed = "null in a sweep, whose cells would replace each other's"
        outcome = Outcome(base.BAD_INPUT, str(ParameterError("publish", published, allowed)))
    if outcome.status == base.BAD_INPUT:
        write_outcome(config, folder, overrides, started_at, outcome, {})
    _record(tracker, folder, name, parent_id)
    seconds = outcome.summary.get("wall_seconds")
    took = "" if seconds is None else f" ({number(seconds)} s)"
    print(f"{name}: {outcome.status} {outcome.message}".rstrip() + took, flush=True)
    if outcome.status == base.INTERRUPTED:
        raise KeyboardInterrupt
    return base.exit_code(outcome.status)


def is_done(config: Mapping[str, Any], folder: ResultFolder) -> bool:
    """Whether a cell has been done, from what is there now and with what it left still there."""
    try:
        check_run(config)
        task = find_task(config["task"]["name"])
        outside = {**task.reads(config), **task.leaves(config)}
    except (ImportError, ParameterError):
        return False
    return folder.holds(config, source_hash(), outside, base.FINISHED)


def _record(tracker: Tracker, folder: ResultFolder, name: str, parent_id: str | None) -> None:
    """Record a cell; what cannot be is tried again at the end of the sweep, and by its restart."""
    try:
        record_folder(tracker, folder, name, parent_id)
    except (TrackingError, OSError) as error:
        print(f"{name} is not recorded: {error}", file=sys.stderr)


def _refused(message: str, folder: ResultFolder) -> int:
    """Bad input: one line, and no trace of a run that never was."""
    print(message, file=sys.stderr)
    folder.withdraw()
    if DAY.fullmatch(folder.path.parent.name):
        with suppress(OSError):  # others are in it
            folder.path.parent.rmdir()
    return base.EXIT_BAD_INPUT


def _tell(task: Task, outcome: Outcome, folder: ResultFolder) -> int:
    """Print the closing block, before anybody waits for a store; returns where its texts begin."""
    names = [file.name for file in folder.files() if file.name not in OWN]
    lines = [
        *task.report(outcome),
        ("files", f"{os.path.relpath(folder.path)}: {', '.join(names)}"),
    ]
    if outcome.status != "ok":
        lines.insert(1, ("status", f"{outcome.status} {outcome.message}".rstrip()))
    width = heading_width([*lines, ("tracking", "")])
    print(block(lines, width), flush=True)
    return width
