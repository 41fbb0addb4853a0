"""``tracking=server``: MLflow records on a tracking server."""

import socket
from urllib.parse import urlsplit

from snapjump.checks import ParameterError
from snapjump.tracking.mlflow_store import MlflowStore

CONNECT_TIMEOUT_S = 5.0


class Server(MlflowStore):
    """Records on the server at ``uri``; artifacts are sent there too."""

    def __init__(self, uri: str = "http://127.0.0.1:5000", experiment: str = "snapjump"):
        super().__init__(uri=uri.rstrip("/"), experiment=experiment, artifacts=None)

    def check(self) -> None:
        """Someone must listen at the address."""
        try:
            parts = urlsplit(self.uri)
            port = parts.port or {"http": 80, "https": 443}[parts.scheme]
            address = (parts.hostname or "", port)
        except (ValueError, KeyError):
            raise ParameterError(
                "tracking.uri", self.uri, "an address like http://127.0.0.1:5000"
            ) from None
        try:
            socket.create_connection(address, CONNECT_TIMEOUT_S).close()
        except OSError as error:
            raise ParameterError(
                "tracking.uri", self.uri, f"a server that answers ({error.strerror or error})"
            ) from None

    def prepare(self) -> None:
        """Nothing: the server looks after its own database."""
