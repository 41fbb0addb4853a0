"""The start of a sweep: its cells, which of them are refused, and its folder."""

import os
import sys
from pathlib import Path
from typing import Any

from hydra.experimental.callback import Callback
from omegaconf import DictConfig, OmegaConf, open_dict
from omegaconf.errors import OmegaConfBaseException

from snapjump.checks import ParameterError, check_choice
from snapjump.declare.fields import construct
from snapjump.declare.members import make_member, member_class
from snapjump.declare.outputs import NUMBER
from snapjump.files.lock import FileLock
from snapjump.files.notice import notice
from snapjump.robot.other_units import in_own_units
from snapjump.robot.robot import Robot
from snapjump.run.tasks.base import EXIT_BAD_INPUT
from snapjump.run.tasks.names import (
    FIXED,
    SWEPT_KEYS,
    cell_name,
    key_of,
    sweep_name,
    task_overrides,
)
from snapjump.run.tasks.sweep import OPTIMISED, SWEEP_NAME, Sweep, begin_sweep
from snapjump.run.tasks.tracking import chosen
from snapjump.run.tasks.workers import SWEEP_PROCESS
from snapjump.simulation import build

MANY = 200  # cells, whose composing takes seconds


class SweepCallback(Callback):
    """Hydra's callback at the start of a sweep."""

    def on_multirun_start(self, config: DictConfig, **others: Any) -> None:
        """Start the sweep; Hydra would turn any Exception from here into a mere warning."""
        os.environ[SWEEP_PROCESS] = str(os.getpid())
        overrides = task_overrides(config.hydra)
        try:
            parsed = parsed_overrides(config)
            varied = [key_of(one.get_key_element()) for one in parsed if one.is_sweep_override()]
            swept = list(dict.fromkeys(varied))
            cells = expand(config, parsed)
            name = sweep_name(overrides, swept)
            os.environ |= {SWEEP_NAME: name, SWEPT_KEYS: ",".join(swept), FIXED: ""}
            folder = Path(config.hydra.sweep.dir).absolute()
            if folder.name != name:  # one of the user's, where other sweeps may be too
                os.environ[FIXED] = name.rpartition("-")[2]
            os.environ.pop(OPTIMISED, None)
            if cells is None:
                os.environ[OPTIMISED] = "1"
            else:
                cells = list({cell_name(cell): cell for cell in cells}.values())
                tell_refused(config, cells)
            group: Any = OmegaConf.to_container(config.tracking, resolve=True)
            tracker = make_member("tracking", chosen(group, overrides))
            sweep = Sweep(folder, overrides, cells, tracker, FileLock(folder / ".lock"))
            sweep.start()
        except OSError as error:
            allowed = f"a folder that can be written to ({error.strerror})"
            refused = ParameterError("hydra.sweep.dir", str(config.hydra.sweep.dir), allowed)
            print(refused, file=sys.stderr)
            raise SystemExit(EXIT_BAD_INPUT) from error
        except ParameterError as error:
            print(error, file=sys.stderr)
            raise SystemExit(EXIT_BAD_INPUT) from error
        begin_sweep(sweep)
        if cells is not None and len(cells) > MANY:
            notice(f"{len(cells)} cells in {folder}; all are composed before the first begins")


def parsed_overrides(config: DictConfig) -> list[Any]:
    """What is said on the command line, and in the sweeper's own parameters.
    Raises ParameterError."""
    from hydra.core.override_parser.overrides_parser import OverridesParser
    from hydra.errors import HydraException

    overrides = task_overrides(config.hydra)
    given = [f"{key}={value}" for key, value in (config.hydra.sweeper.get("params") or {}).items()]
    try:
        return list(OverridesParser.create().parse_overrides([*given, *overrides]))
    except HydraException as error:
        raise ParameterError("command line", overrides, str(error)) from error


def expand(config: DictConfig, parsed: list[Any]) -> list[list[str]] | None:
    """The overrides of every cell, just as Hydra's own sweeper makes them; None for a sweeper that
    chooses them by what comes of them. Raises ParameterError for one without an objective."""
    from hydra._internal.core_plugins.basic_sweeper import BasicSweeper
    from hydra.errors import HydraException

    if not config.hydra.sweeper._target_.endswith(".BasicSweeper"):
        check_objective(config)
        return None
    try:
        (cells,) = BasicSweeper.split_arguments(parsed, None)
    except HydraException as error:
        raise ParameterError("command line", task_overrides(config.hydra), str(error)) from error
    return list(cells)


def check_objective(config: DictConfig) -> None:
    """Raise ParameterError for an objective that is no number of the task's outcome."""
    if config.objective is None:
        sweeper = config.hydra.sweeper._target_.rpartition(".")[2]
        allowed = f"the name of an output, such as y_bar, for {sweeper} to optimise"
        raise ParameterError("objective", None, allowed)
    if config.task.name == "simulate":
        outputs = member_class("sim", config.sim.name)().outputs.declared()
        check_choice("objective", config.objective, [o.name for o in outputs if o.kind == NUMBER])


def tell_refused(config: DictConfig, cells: list[list[str]]) -> None:
    """Say which cells cannot be simulated, before the first of many is. A great many are told as
    their turn comes."""
    from hydra.core.global_hydra import GlobalHydra
    from hydra.errors import HydraException

    if len(cells) > MANY:
        return
    loader = GlobalHydra.instance().config_loader()
    for overrides in cells:
        try:
            check_cell(loader.load_sweep_config(config, overrides), overrides)
        except ParameterError as error:
            notice(f"{cell_name(overrides)} is refused: {error}")
        except (HydraException, OmegaConfBaseException):
            return  # Hydra says why, in its turn


def check_cell(composed: DictConfig, overrides: list[str]) -> None:
    """Raise ParameterError for a simulation that is refused."""
    with open_dict(composed):
        del composed["hydra"]
    config: Any = OmegaConf.to_container(composed, resolve=True)
    if config["task"]["name"] == "simulate":
        build(
            in_own_units(
                config, [*map(key_of, overrides)], construct("robot", Robot, config["robot"])
            )
        )
