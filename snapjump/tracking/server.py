"""``tracking=server``: MLflow records on a tracking server."""

import socket
from typing import Any
from urllib.parse import SplitResult, urlsplit

from snapjump.checks import ParameterError
from snapjump.tracking.parts.mlflow_store import MlflowStore

CONNECT_TIMEOUT_S = 5.0
PORTS = {"http": 80, "https": 443}
ADDRESS = "an address like http://127.0.0.1:5000"
SECRETS = (
    f"{ADDRESS}; a user and a password belong into the environment, MLFLOW_TRACKING_USERNAME and "
    "MLFLOW_TRACKING_PASSWORD (or MLFLOW_TRACKING_TOKEN), which are written nowhere"
)


class Server(MlflowStore):
    """MLflow records on a tracking server, at ``uri``; artifacts are sent there too."""

    uri: str = "http://127.0.0.1:5000"

    def __post_init__(self) -> None:
        super().__post_init__()
        parts = split(self.uri)
        if parts is None or "@" in parts.netloc or parts.query or parts.fragment:
            shown = without_secrets(self.uri)
            secret = "@" in self.uri or parts is not None
            raise ParameterError("tracking.uri", shown, SECRETS if secret else ADDRESS)

    @property
    def place(self) -> str:
        return self.uri.rstrip("/")

    def check(self) -> None:
        parts = split(self.uri)
        assert parts is not None
        try:
            address = (parts.hostname or "", parts.port or PORTS[parts.scheme])
            socket.create_connection(address, CONNECT_TIMEOUT_S).close()
        except (OSError, ValueError) as error:
            reason = getattr(error, "strerror", None) or error
            allowed = f"a server that answers ({reason})"
            raise ParameterError("tracking.uri", self.place, allowed) from None


def split(uri: Any) -> SplitResult | None:
    """The parts of the address of a server; None of what is no such address."""
    try:
        parts = urlsplit(uri)
        usable = parts.scheme in PORTS and bool(parts.hostname) and (parts.port or 1) > 0
    except ValueError:
        return None
    return parts if usable else None


def without_secrets(uri: str) -> str:
    """An address as it may be shown: what stands before the host, and after a question mark or a
    number sign, is left out."""
    scheme, slashes, rest = uri.partition("://")
    rest = rest if slashes else scheme
    host = rest.rpartition("@")[2].partition("?")[0].partition("#")[0]
    return f"{scheme}{slashes}{'***@' if '@' in rest else ''}{host}" if slashes else host
