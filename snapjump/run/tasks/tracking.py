"""Where a run is recorded: what the command says, else the environment, else the default."""

import os
import re
from collections.abc import Mapping, Sequence
from typing import Any
from urllib.parse import unquote

from snapjump.checks import ParameterError
from snapjump.declare.members import make_member, member_group
from snapjump.tracking.server import without_secrets
from snapjump.tracking.sqlite import Sqlite

VARIABLE = "MLFLOW_TRACKING_URI"
ASKED = re.compile(r"[+~]*tracking([.=@]|$)")
SQLITE = "sqlite:///"


def chosen(group: Any, overrides: Sequence[str]) -> Any:
    """The group of the tracker: that of the configuration if the command or a file of it says so,
    else that of MLFLOW_TRACKING_URI, if it is set. Raises ParameterError."""
    uri = os.environ.get(VARIABLE, "")
    asked = any(ASKED.match(text) for text in overrides)
    if asked or not uri or group != member_group(Sqlite()):
        return group
    try:
        tracker = make_member("tracking", {**_group_of(uri), "experiment": group["experiment"]})
        tracker.check()
    except ParameterError as error:
        raise ParameterError(VARIABLE, without_secrets(uri), error.allowed) from None
    return member_group(tracker)


def _group_of(uri: str) -> Mapping[str, Any]:
    if uri.startswith(SQLITE):
        return {"name": "sqlite", "path": unquote(uri.removeprefix(SQLITE))}
    if uri.startswith(("http:", "https:")):
        return {"name": "server", "uri": uri}
    allowed = f"an http address, or {SQLITE}<path>; tracking=sqlite and tracking=off need none"
    raise ParameterError(VARIABLE, uri, allowed)
