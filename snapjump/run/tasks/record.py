"""``python run.py record=<run folder>``: a record that could not be written when the run ended."""

import os
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from snapjump.checks import ParameterError
from snapjump.declare.members import make_member
from snapjump.files.json_file import read_json
from snapjump.files.layout import CONF
from snapjump.files.result_folder import ResultFolder
from snapjump.run.tasks.base import EXIT_OK, EXIT_UNTRACKED
from snapjump.run.tasks.tracking import chosen
from snapjump.tracking.base import TrackingError
from snapjump.tracking.parts.tracked import MARK, record_folder

KEY = "record="
OF_THE_RUN = "a run's folder, alone or with tracking=... and tracking.<key>=..."


def record(arguments: Sequence[str]) -> int:
    """Record a run from its files, where it was to be recorded or where the command says.
    Returns the exit code. Raises ParameterError."""
    path = next(text.removeprefix(KEY) for text in arguments if text.startswith(KEY))
    others = [text for text in arguments if not text.startswith(KEY)]
    if strange := [text for text in others if not text.startswith(("tracking=", "tracking."))]:
        raise ParameterError("command line", strange[0], OF_THE_RUN)
    folder = ResultFolder(Path(path))
    config = folder.config()
    if config is None or folder.result() is None or folder.provenance() is None:
        raise ParameterError("record", path, "the folder of a run that has ended")
    group = _composed(others) if others else chosen(config.get("tracking"), others)
    tracker = make_member("tracking", group)
    tracker.check()
    mark = read_json(folder.path / MARK) or {}
    try:
        place = record_folder(tracker, folder, mark.get("name"), mark.get("parent_id"))
    except (TrackingError, OSError) as error:
        print(f"not recorded: {error}", file=sys.stderr)
        return EXIT_UNTRACKED
    print(f"recorded: {place}" if place else f"{os.path.relpath(path)} was not to be recorded")
    return EXIT_OK


def _composed(overrides: Sequence[str]) -> Any:
    """The group ``tracking`` as the command line says."""
    from hydra import compose, initialize_config_dir
    from omegaconf import OmegaConf

    with initialize_config_dir(str(CONF), version_base="1.3"):
        return OmegaConf.to_container(compose("config", overrides=list(overrides)).tracking)
