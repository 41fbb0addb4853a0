"""Options of the executors."""

import re
from dataclasses import dataclass

from snapjump.checks import ParameterError, check_integer
from snapjump.executor.dask import DaskExecutor
from snapjump.executor.local import LocalExecutor

ADDRESS = re.compile(r"(tcp|tls)://[^\s:/]+:\d{1,5}")
MOST_WORKERS = 1024


@dataclass(frozen=True)
class LocalExecutorOptions:
    """This process, with all threads that the backend has."""

    def member(self) -> LocalExecutor:
        """The executor."""
        return LocalExecutor()


@dataclass(frozen=True)
class DaskExecutorOptions:
    """Workers of dask.distributed: of a scheduler, or processes on this machine.

    ``scheduler``: its address, None to start ``workers`` processes here.
    """

    scheduler: str | None = None
    workers: int = 2

    def __post_init__(self) -> None:
        if self.scheduler is not None and not (
            isinstance(self.scheduler, str) and ADDRESS.fullmatch(self.scheduler)
        ):
            raise ParameterError(
                "executor.scheduler", self.scheduler, "null, or an address like tcp://host:8786"
            )
        check_integer("executor.workers", self.workers, 1, MOST_WORKERS)

    def member(self) -> DaskExecutor:
        """The executor."""
        return DaskExecutor(self.scheduler, self.workers)
