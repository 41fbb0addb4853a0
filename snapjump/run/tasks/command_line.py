"""The command: the help page, Hydra, errors in one line, and the exit code."""

import os
import sys
from collections.abc import Sequence
from itertools import pairwise
from pathlib import Path
from typing import Any

from snapjump import __version__
from snapjump.checks import ParameterError
from snapjump.declare.former_options import check_arguments
from snapjump.declare.plugins import load_all, load_installed
from snapjump.files.layout import CONF
from snapjump.run.tasks.base import EXIT_BAD_INPUT, EXIT_ERROR, EXIT_INTERRUPTED
from snapjump.run.tasks.interrupts import heeded
from snapjump.show.terminal.streams import unfailing_streams

# Hydra's flags, and the values that some take.
ALONE = frozenset(
    "-m --multirun -r --run --resolve -sc --shell-completion --hydra-help --version".split()
)
WITH_VALUE: dict[str, tuple[str, ...]] = {
    **dict.fromkeys(("-c", "--cfg"), ("job", "hydra", "all")),
    **dict.fromkeys(
        ("-i", "--info"), ("all", "config", "defaults", "defaults-tree", "plugins", "searchpath")
    ),
    **dict.fromkeys(
        "-p --package -cd --config-dir -cn --config-name -cp --config-path".split(), ()
    ),
}

# Hydra drops what a job returns; a job in this process leaves its exit code here.
_exit_codes: list[int] = []


def main() -> int:
    """Do what ``sys.argv`` says; returns the exit code."""
    with unfailing_streams():
        try:
            with heeded():
                return _main()
        except ParameterError as error:
            print(error, file=sys.stderr)
            return EXIT_BAD_INPUT
        except OSError as error:
            print(f"error: {error}", file=sys.stderr)
            return EXIT_ERROR
        except KeyboardInterrupt:
            print("interrupted", file=sys.stderr)
            return EXIT_INTERRUPTED


def _main() -> int:
    arguments = sys.argv[1:]
    if {"-h", "--help"} & set(arguments):
        from snapjump.show.terminal.help_page import help_page, member_page

        plugins = [Path(folder) for folder in (*named_plugins(arguments), *config_dirs(arguments))]
        chosen = [
            text for text in arguments if "=" in text and not text.startswith(("plugins=", "-"))
        ]
        print(member_page(CONF, chosen, plugins) if chosen else help_page(CONF, plugins))
        return 0
    if "--version" in arguments:
        print(f"snapjump {__version__}")
        return 0
    if any(argument.startswith("record=") for argument in arguments):
        from snapjump.run.tasks.record import record

        return record(arguments)
    arguments = flags_first(arguments)
    sys.argv[1:] = arguments
    check_arguments(arguments)
    load_all(named_plugins(arguments))
    return _run_hydra()


def flags_first(arguments: Sequence[str]) -> list[str]:
    """The arguments with flags, wherever they stand, before overrides, as Hydra takes them.
    Raises ParameterError for a flag that is not Hydra's, or has not one of its values."""
    flags: list[str] = []
    others: list[str] = []
    waiting = list(arguments)
    while waiting:
        flag, equals, value = waiting.pop(0).partition("=")
        if not flag.startswith("-"):
            others.append(flag + equals + value)
        elif flag in ALONE and not equals:
            flags.append(flag)
        elif flag in WITH_VALUE:
            choices = WITH_VALUE[flag]
            if not equals and waiting and (not choices or waiting[0] in choices):
                value = waiting.pop(0)
            if not value and flag in ("-i", "--info"):
                value = choices[0]
            if not value or (choices and value not in choices):
                allowed = "one of " + ", ".join(choices) if choices else "a value after it"
                raise ParameterError(
                    "command line", flag + equals + value, f"{flag} with {allowed}"
                )
            flags += [flag, value]
        else:
            raise ParameterError("command line", flag + equals + value, "a flag that --help lists")
    return flags + others


def named_plugins(arguments: Sequence[str]) -> list[str]:
    """The folders of ``plugins=<folder>`` or ``plugins=[<folder>,...]``.
    Hydra finds their members when it composes, before any key has a value."""
    found: list[str] = []
    for argument in arguments:
        key, _, value = argument.partition("=")
        if key == "plugins" and value not in ("", "null"):
            found += [part.strip(" '\"") for part in value.strip("[]").split(",")]
    return found


def config_dirs(arguments: Sequence[str]) -> list[str]:
    """The folder of ``--config-dir``, whose members are listed as well."""
    flags = ("-cd", "--config-dir")
    after = [value for flag, value in pairwise(arguments) if flag in flags]
    return after + [
        text.partition("=")[2] for text in arguments if text.startswith("--config-dir=")
    ]


def _run_hydra() -> int:
    import hydra
    from hydra.errors import HydraException
    from omegaconf.errors import OmegaConfBaseException

    from snapjump.run.tasks.hydra_errors import one_line
    from snapjump.run.tasks.search_path import search_plugins
    from snapjump.run.tasks.sweep import current_sweep, leave_sweep
    from snapjump.run.tasks.sweep_summary import summarise

    wants_traceback = os.environ.get("HYDRA_FULL_ERROR") == "1"
    # Otherwise Hydra prints several lines and exits with 1 for whatever goes wrong.
    os.environ["HYDRA_FULL_ERROR"] = "1"
    _exit_codes.clear()
    load_installed()
    search_plugins()
    run = hydra.main(version_base="1.3", config_path=str(CONF), config_name="config")(_job)
    try:
        run()
    except Exception as error:
        if wants_traceback or _exit_codes:
            raise
        if current_sweep() is None or isinstance(error, (HydraException, OmegaConfBaseException)):
            raise one_line(error, sys.argv[1:]) from error
        print(f"the sweep broke off: {type(error).__name__}: {error}", file=sys.stderr)
    finally:
        sweep = current_sweep()
        if sweep is not None:
            try:
                _exit_codes[:] = [summarise(sweep, sys.exc_info()[1])]
            finally:
                leave_sweep(sweep)
    return max(_exit_codes, default=0)


def _job(config: Any) -> Any:
    from snapjump.run.tasks.job import objective, run_job

    # Until it is known better: what a job raises is a defect, and not bad input.
    _exit_codes.append(EXIT_ERROR)
    _exit_codes[-1] = run_job(config)
    return objective(config)
