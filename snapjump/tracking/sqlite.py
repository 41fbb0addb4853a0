"""``tracking=sqlite``: MLflow records in one database file, artifacts in a folder beside it."""

import os
import sqlite3
import sys
from pathlib import Path

from snapjump.checks import ParameterError
from snapjump.files.lock import FileLock
from snapjump.tracking.mlflow_store import MlflowStore


class Sqlite(MlflowStore):
    """Records in ``path``, relative to where the command is run."""

    def __init__(self, path: str = "mlruns.db", experiment: str = "snapjump"):
        self.path = Path(path).absolute()
        super().__init__(
            uri=f"sqlite:///{self.path}",
            experiment=experiment,
            artifacts=(self.path.parent / f"{self.path.stem}_artifacts").as_uri(),
        )

    def check(self) -> None:
        """The file, or else its nearest folder that exists, must be writable."""
        if "?" in str(self.path):
            raise ParameterError("tracking.path", str(self.path), "a path without '?'")
        if self.path.is_dir():
            raise ParameterError("tracking.path", str(self.path), "a file, and this is a folder")
        place = self.path
        while not place.exists():
            place = place.parent
        if not os.access(place, os.W_OK):
            raise ParameterError("tracking.path", str(self.path), f"{place} must be writable")

    def prepare(self) -> None:
        """Create the tables, once: processes that did so at the same time would collide."""
        if self._has_tables():
            return
        with FileLock(self.path.parent / f".{self.path.name}.lock"):
            if not self._has_tables():
                print(
                    "creating the tracking database, once, about 5 s", file=sys.stderr, flush=True
                )
                self.client.search_experiments(max_results=1)

    def _has_tables(self) -> bool:
        if not self.path.exists():
            return False
        connection = sqlite3.connect(self.path)
        try:
            query = "SELECT version_num FROM alembic_version"
            return connection.execute(query).fetchone() is not None
        except sqlite3.DatabaseError:
            return False
        finally:
            connection.close()
