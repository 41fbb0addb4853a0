"""Trackers by name."""

from collections.abc import Mapping
from inspect import signature
from typing import Any

from snapjump.checks import ParameterError, check_choice
from snapjump.tracking.base import Tracker
from snapjump.tracking.off import Off
from snapjump.tracking.server import Server
from snapjump.tracking.sqlite import Sqlite

TRACKERS = {"off": Off, "sqlite": Sqlite, "server": Server}


def find_tracker(options: Mapping[str, Any]) -> Tracker:
    """The tracker of a ``tracking`` group; raises ParameterError."""
    values = dict(options)
    name = values.pop("name")
    check_choice("tracking", name, tuple(TRACKERS))
    known = signature(TRACKERS[name]).parameters
    for key, value in values.items():
        if key not in known:
            allowed = f"tracking={name} has {', '.join(known) or 'no keys'}"
            raise ParameterError(f"tracking.{key}", value, allowed)
        if not isinstance(value, str) or not value:
            raise ParameterError(f"tracking.{key}", value, "a text that is not empty")
    tracker: Tracker = TRACKERS[name](**values)
    return tracker
