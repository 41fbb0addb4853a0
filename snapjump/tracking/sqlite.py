"""``tracking=sqlite``: MLflow records in one database file, artifacts in a folder beside it."""

import os
import sqlite3
from contextlib import suppress
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING

from snapjump.checks import ParameterError
from snapjump.files.lock import FileLock
from snapjump.files.notice import notice
from snapjump.tracking.parts.mlflow_store import MlflowStore

if TYPE_CHECKING:
    from mlflow.tracking import MlflowClient


def escaped(path: Path) -> Path:
    """A path as addresses spell it: what follows a percent sign would be taken for a code."""
    return Path(str(path).replace("%", "%25"))


class Sqlite(MlflowStore):
    """MLflow records in a file, ``path``, relative to where the command is run."""

    path: str = "mlruns.db"

    @cached_property
    def file(self) -> Path:
        return Path(self.path).absolute()

    @property
    def place(self) -> str:
        return f"sqlite:///{escaped(self.file)}"

    @cached_property
    def client(self) -> "MlflowClient":
        """The client, which makes the folder of the address as it is spelled there, too."""
        spelled = escaped(self.file.parent)
        stray = spelled != self.file.parent and not spelled.exists()
        found = super().client
        if stray:
            with suppress(OSError):
                spelled.rmdir()
        return found

    @property
    def artifacts(self) -> str:
        return (self.file.parent / f"{self.file.stem}_artifacts").as_uri()

    def check(self) -> None:
        """The file, or else its nearest folder that exists, must be writable."""
        try:
            existing = next(p for p in (self.file, *self.file.parents) if p.exists())
        except OSError as error:  # a name that is too long
            raise ParameterError("tracking.path", self.path, str(error.strerror)) from error
        for wrong, allowed in (
            (not existing.is_dir() and existing != self.file, f"a folder; {existing} is none"),
            ("?" in str(self.file), "a path without '?'"),
            (self.file.is_dir(), "a file, and this is a folder"),
            (not os.access(existing, os.W_OK), f"{existing} must be writable"),
        ):
            if wrong:
                raise ParameterError("tracking.path", str(self.file), allowed)

    def prepare(self) -> None:
        """Create the tables, once: processes that did so at the same time would collide."""
        if self._has_tables():
            return
        with FileLock(self.file.parent / f".{self.file.name}.lock"):
            if not self._has_tables():
                notice("creating the tracking database, once, about 5 s")
                self.client.search_experiments(max_results=1)

    def _has_tables(self) -> bool:
        if not self.file.exists():
            return False
        connection = sqlite3.connect(self.file)
        try:
            query = "SELECT version_num FROM alembic_version"
            return connection.execute(query).fetchone() is not None
        except sqlite3.OperationalError as error:
            return "locked" in str(error)  # by somebody who has made them
        except sqlite3.DatabaseError:
            return False
        finally:
            connection.close()
