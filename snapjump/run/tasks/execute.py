"""One job around its task: checks, files, and a status whatever happens."""

import sys
import time
import traceback
from collections.abc import Mapping, Sequence
from typing import Any

from snapjump.checks import ParameterError, check_choice, check_integer
from snapjump.declare.families import FAMILIES
from snapjump.files.atomic import write_text
from snapjump.files.extras import MissingExtraError, extras_named
from snapjump.files.json_file import finite
from snapjump.files.provenance import now, provenance
from snapjump.files.result_folder import TRACEBACK, ResultFolder
from snapjump.run.tasks.base import (
    BAD_INPUT,
    ERROR,
    INTERRUPTED,
    NOT_FINITE,
    OK,
    SIMULATION,
    Outcome,
    Task,
)
from snapjump.run.tasks.interrupts import heeded, reason, stopping, uninterrupted
from snapjump.run.tasks.live import Live
from snapjump.run.tasks.names import command
from snapjump.run.tasks.publish import check_publish, publish
from snapjump.run.tasks.registry import find_task
from snapjump.show.terminal.progress import ProgressBar
from snapjump.simulation import GROUPS, OF_RUNS, OF_SOME_TASKS
from snapjump.tiers import check_tier_keys

SECTIONS = ("task", "accuracy", "robot", "design", "environment", *FAMILIES, "tracking")
SWITCHES = ("figures", "seed", "effort", "publish")
EFFORTS = ("quick", "full")
LARGEST_SEED = 2**32 - 1


def execute(
    config: Mapping[str, Any],
    folder: ResultFolder,
    overrides: Sequence[str],
    bar: ProgressBar,
    live: Live | None = None,
) -> tuple[Outcome, Task | None]:
    """Do one job and leave its files; never raises for what happens inside the task.
    A job with bad input has done nothing and leaves nothing: what becomes of it is the caller's.
    The task is returned if it got as far as to be prepared, and can report."""
    started_at, clock = now(), time.perf_counter()
    task, outside, noticed = None, {}, []
    try:
        check_run(config)
        with extras_named(), heeded() as noticed:
            found = find_task(config["task"]["name"])
            check_read(found, config, overrides)
            found.prepare(config)
            outside = found.reads(config)
            task = found
            folder.begin()
            folder.write_config(config)
            progress = stopping(bar, noticed)
            if live is not None:
                task.step, progress = live.step, live.watched(progress)
            outcome = task.run(folder, progress)
    except ParameterError as error:
        return Outcome(BAD_INPUT, str(error)), task
    except MissingExtraError as error:
        return Outcome(BAD_INPUT, str(error)), None
    except KeyboardInterrupt:
        outcome = Outcome(INTERRUPTED, reason(noticed))
    except Exception as error:
        outcome = failed(error, folder)
    finally:
        bar.close()
    with uninterrupted():
        outcome.summary.setdefault("wall_seconds", time.perf_counter() - clock)
        if task is not None and outcome.finished:
            outside |= task.leaves(config)
        try:
            write_outcome(config, folder, overrides, started_at, outcome, outside)
        except OSError as error:
            told = f"{error.strerror}: the result is not in {folder.path}"
            return Outcome(ERROR, told, outcome.summary), task
        if config["publish"] is not None and outcome.finished:
            try:
                told = "published " + ", ".join(map(str, publish(config, folder)))
            except OSError as error:
                told = f"not published: {error}; the report is in {folder.path}"
            print(told, file=sys.stderr)
    return outcome, task


def failed(error: Exception, folder: ResultFolder) -> Outcome:
    """The outcome of a job that broke off; where its traceback is, if there was room for it."""
    told = " ".join(f"{type(error).__name__}: {error}".split())
    try:
        folder.begin()
        write_text(folder.path / TRACEBACK, "".join(traceback.format_exception(error)))
    except OSError:
        return Outcome(ERROR, told)
    return Outcome(ERROR, f"{told} (see {TRACEBACK})")


def write_outcome(
    config: Mapping[str, Any],
    folder: ResultFolder,
    overrides: Sequence[str],
    started_at: str,
    outcome: Outcome,
    outside: Mapping[str, str],
) -> None:
    """Write what every job leaves; ``result.json`` last. Takes NaN out of the outcome."""
    folder.begin()
    summary, not_finite = finite(outcome.summary)
    outcome.summary = summary
    # A robot that does not jump has no lift-off; one that does has every number.
    if not_finite and outcome.status == OK:
        outcome.status = NOT_FINITE
        outcome.message = "not a finite number: " + ", ".join(not_finite)
    folder.write_config(config)
    folder.write_provenance(
        {**provenance(command(overrides), config["seed"], started_at), "outside": outside}
    )
    message = {"message": outcome.message} if outcome.message else {}
    summary = {key: value for key, value in outcome.summary.items() if key != "status"}
    folder.write_result({"status": outcome.status, **message, **summary})


def check_read(task: Task, config: Mapping[str, Any], overrides: Sequence[str]) -> None:
    """Raise ParameterError for what a command says and its task does not read."""
    name = config["task"]["name"]
    left_out = f"left out: task={name} reads {', '.join(task.keys) or 'no other group'}"
    for key in OF_SOME_TASKS:
        if key in config and key not in task.keys:
            raise ParameterError(key, config[key], left_out)
    for key, value in config["task"].items():
        if key not in ("name", *task.options):
            allowed = ", ".join(task.options) or "no keys"
            raise ParameterError(f"task.{key}", value, f"task={name} has {allowed}")
    check_tier_keys(config["accuracy"])
    for text in overrides:
        path, _, given = text.lstrip("+~").partition("=")
        group = path.partition("@")[0].partition(".")[0]
        if group in SIMULATION and group not in task.keys:
            raise ParameterError(path, given, left_out)
        if path == "integrator.name":  # a tableau under the name of another
            raise ParameterError(path, given, "chosen by integrator=<name>")


def check_run(config: Mapping[str, Any]) -> None:
    """Check the keys that are about the run itself; raises ParameterError."""
    for key in config:
        if key not in (*GROUPS, *OF_RUNS):
            raise ParameterError(key, config[key], "no such key; see --help")
    for key in SECTIONS:
        if not isinstance(config.get(key), Mapping):
            raise ParameterError(key, config.get(key), "a group, which cannot be left out")
    for key in SWITCHES:
        if key not in config:
            raise ParameterError(key, None, "a value, which cannot be left out")
    if "name" not in config["task"]:
        raise ParameterError("task.name", None, "a value, which cannot be left out")
    check_integer("seed", config["seed"], 0, LARGEST_SEED)
    if not isinstance(config["figures"], bool):
        raise ParameterError("figures", config["figures"], "true or false")
    check_choice("effort", config["effort"], EFFORTS)
    check_publish(config)
