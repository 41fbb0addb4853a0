"""``executor=dask``: jobs on the workers of a dask.distributed scheduler, wherever these are."""

import logging
import os
import platform
import re
import signal
import socket
from collections.abc import Iterator, Sequence
from contextlib import suppress
from importlib.util import find_spec
from typing import Any
from urllib.parse import urlsplit

from snapjump.checks import ParameterError
from snapjump.declare.fields import integer
from snapjump.declare.scenes import Progress
from snapjump.executor.base import Answer, Executor, ExecutorOptions, Job, Work

CONNECT_TIMEOUT_S = 10.0
ADDRESS = re.compile(r"(tcp|tls)://[^\s:/]+:\d{1,5}")
PATIENCE_S = 0.5  # between looks at what has been finished


class DaskExecutor(Executor):
    """A client of the scheduler at ``scheduler``, or of a cluster of its own on this machine.

    A job whose worker dies is done again by another; one that takes four workers down is given up
    (dask's ``distributed.scheduler.allowed-failures``).
    """

    def __init__(self, scheduler: str | None, workers: int):
        self.scheduler, self.workers = scheduler, workers

    def check(self) -> None:
        if find_spec("distributed") is None:
            raise ParameterError("executor", "dask", "local, or pip install 'snapjump[cluster]'")
        if self.scheduler is None:
            return
        parts = urlsplit(self.scheduler)
        try:
            address = (parts.hostname or "", parts.port or 0)
            socket.create_connection(address, CONNECT_TIMEOUT_S).close()
        except (OSError, ValueError) as error:
            allowed = f"a scheduler that answers ({getattr(error, 'strerror', None) or error})"
            raise ParameterError("executor.scheduler", self.scheduler, allowed) from None

    def __enter__(self) -> "DaskExecutor":
        from distributed import Client, LocalCluster

        # That a worker has gone is told by what becomes of its job.
        logging.getLogger("distributed").setLevel(logging.CRITICAL)
        self._cluster = None
        if self.scheduler is None:
            self._cluster = LocalCluster(
                n_workers=self.workers,
                threads_per_worker=1,
                host="127.0.0.1",
                dashboard_address=None,
                preload=[__name__],
            )
        self._client = Client(self._cluster or self.scheduler, timeout=CONNECT_TIMEOUT_S)
        return self

    def __exit__(self, *error: object) -> None:
        # What was going on is lost anyway; a cluster that has gone cannot be closed.
        with suppress(OSError, TimeoutError):
            self._client.close()
            if self._cluster is not None:
                self._cluster.close()

    @property
    def cores(self) -> int:
        """Cores of the workers that are there now, each machine's counted once."""
        machines: dict[str, set[int]] = {}
        for machine, cores in self._client.run(own_cores).values():
            machines.setdefault(machine, set()).update(cores)
        return max(1, sum(len(cores) for cores in machines.values()))

    @property
    def at_once(self) -> int:
        return sum(self._client.nthreads().values())

    @property
    def threads(self) -> int | None:
        if self.scheduler is not None:
            return None
        return max(1, len(os.sched_getaffinity(0)) // self.workers)

    def answers(self, work: Work, jobs: Sequence[Job], progress: Progress) -> Iterator[Answer]:
        from distributed import wait

        waiting = [self._client.submit(work, dict(job), None, pure=False) for job in jobs]
        while waiting:
            try:
                done, left = wait(waiting, timeout=PATIENCE_S, return_when="FIRST_COMPLETED")
            except TimeoutError:
                progress(0.0, "")
                continue
            waiting = list(left)
            for future in done:
                yield future.result()


def dask_setup(worker: Any) -> None:
    """Set up a worker that is started here, as dask calls it: Ctrl-C, which a terminal sends to all
    processes, is left to the one that started them."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)


def own_cores() -> tuple[str, list[int]]:
    """The machine and the cores of the process that this runs in."""
    return platform.node(), sorted(os.sched_getaffinity(0))


class Dask(ExecutorOptions):
    """Workers of dask.distributed: of a scheduler, or processes on this machine.
    ``scheduler``: its address, None to start ``workers`` processes here."""

    scheduler: str | None = None
    workers: int = integer(2, least=1, most=1024)

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.scheduler is not None and not (
            isinstance(self.scheduler, str) and ADDRESS.fullmatch(self.scheduler)
        ):
            raise ParameterError(
                "executor.scheduler", self.scheduler, "null, or an address like tcp://host:8786"
            )

    def executor(self) -> DaskExecutor:
        return DaskExecutor(self.scheduler, self.workers)
