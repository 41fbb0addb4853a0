"""``tracking=server``: MLflow records on a tracking server."""

import socket
from urllib.parse import urlsplit

from snapjump.checks import ParameterError
from snapjump.tracking.parts.mlflow_store import MlflowStore

CONNECT_TIMEOUT_S = 5.0


class Server(MlflowStore):
    """MLflow records on a tracking server, at ``uri``; artifacts are sent there too."""

    uri: str = "http://127.0.0.1:5000"

    @property
    def place(self) -> str:
        return self.uri.rstrip("/")

    def check(self) -> None:
        try:
            parts = urlsplit(self.place)
            port = parts.port or {"http": 80, "https": 443}[parts.scheme]
            socket.create_connection((parts.hostname or "", port), CONNECT_TIMEOUT_S).close()
        except (ValueError, KeyError):
            allowed = "an address like http://127.0.0.1:5000"
            raise ParameterError("tracking.uri", self.place, allowed) from None
        except OSError as error:
            allowed = f"a server that answers ({error.strerror or error})"
            raise ParameterError("tracking.uri", self.place, allowed) from None
