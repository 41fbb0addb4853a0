"""``executor=dask``: jobs on the workers of a dask.distributed scheduler, wherever these are."""

import logging
import platform
import re
import signal
import socket
import time
from collections.abc import Iterator, Sequence
from contextlib import suppress
from importlib.util import find_spec
from typing import Any
from urllib.parse import urlsplit

from snapjump.checks import LONGEST, ParameterError
from snapjump.deadline import within
from snapjump.declare.fields import integer, number
from snapjump.declare.scenes import Progress
from snapjump.executor.base import Answer, Executor, ExecutorOptions, Job, Work
from snapjump.files.cores import own_cores
from snapjump.files.notice import notice
from snapjump.files.sources import combined_hash, package_files

CONNECT_TIMEOUT_S = 10.0
ADDRESS = re.compile(r"(tcp|tls)://[^\s:/]+:\d{1,5}")
PATIENCE_S = 0.5  # between looks at what has been finished
ANSWER_S = 15.0  # within which a scheduler and its workers answer
WAIT_S = 4.0  # for a first worker
SERVERS = ("scheduler", "worker", "nanny")


class DaskExecutor(Executor):
    """A client of the scheduler at ``scheduler``, or of a cluster of its own on this machine.

    A job whose worker dies is done again by another; one that takes four workers down is given up
    (dask's ``distributed.scheduler.allowed-failures``).
    """

    def __init__(self, scheduler: str | None, workers: int, wait_s: float = WAIT_S):
        self.scheduler, self.workers, self.wait_s = scheduler, workers, wait_s

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
        # That a worker has gone is told by what becomes of its job.
        logging.getLogger("distributed").setLevel(logging.CRITICAL)
        self._cluster = None
        if self.scheduler is None:
            self._begin_workers()
            return self
        self._connect()
        try:
            self._wait_for_workers()
            self._compare_sources()
        except BaseException:
            self.__exit__()
            raise
        return self

    def __exit__(self, *error: object) -> None:
        # What was going on is lost anyway; a cluster that has gone cannot be closed.
        with suppress(OSError, TimeoutError):
            within(ANSWER_S, self._client.close)
            if self._cluster is not None:
                self._cluster.close()

    def _begin_workers(self) -> None:
        """Workers of our own: with certificates of their own, so that nobody else on this machine
        can give them work, and without the pages that any process could read."""
        import dask
        from distributed import Client, LocalCluster, Security

        with dask.config.set({f"distributed.{who}.http.routes": [] for who in SERVERS}):
            self._cluster = LocalCluster(
                n_workers=self.workers,
                threads_per_worker=1,
                host="127.0.0.1",
                dashboard_address=None,
                preload=[__name__],
                security=Security.temporary(),
            )
        self._client = Client(self._cluster, timeout=CONNECT_TIMEOUT_S)

    def _connect(self) -> None:
        """Raise ParameterError for what does not answer as a scheduler does."""
        from distributed import Client

        try:
            self._client = within(
                ANSWER_S, lambda: Client(self.scheduler, timeout=CONNECT_TIMEOUT_S)
            )
        except Exception as error:
            reason = " ".join(f"{type(error).__name__}: {error}".split())[:LONGEST]
            raise self._refused(f"the address of a dask scheduler ({reason})") from error

    def _wait_for_workers(self) -> None:
        """Raise ParameterError if there is none, after as long as was asked for."""
        end = time.monotonic() + self.wait_s
        if not self._client.nthreads() and self.wait_s > WAIT_S:
            notice(f"no workers at {self.scheduler} yet; waiting for {self.wait_s:g} s")
        while not self._client.nthreads():
            if time.monotonic() > end:
                allowed = f"one with workers, and there was none for {self.wait_s:g} s"
                raise self._refused(f"{allowed} (executor.wait_s waits longer)")
            time.sleep(PATIENCE_S)

    def _compare_sources(self) -> None:
        """Raise ParameterError for workers whose snapjump is another, before any work is done."""
        try:
            found = within(ANSWER_S, lambda: self._client.run(own_sources))
        except Exception as error:
            reason = " ".join(f"{type(error).__name__}: {error}".split())[:LONGEST]
            raise self._refused(f"one whose workers have this snapjump ({reason})") from error
        others = [worker for worker, sources in found.items() if sources != own_sources()]
        if others:
            raise self._refused(f"one whose workers have this snapjump; {others[0]} has another")

    def _refused(self, allowed: str) -> ParameterError:
        return ParameterError("executor.scheduler", self.scheduler, allowed)

    @property
    def cores(self) -> int:
        """Cores of the workers that are there now, each machine's counted once."""
        machines: dict[str, set[int]] = {}
        for machine, cores in self._client.run(cores_here).values():
            machines.setdefault(machine, set()).update(cores)
        return max(1, sum(len(cores) for cores in machines.values()))

    @property
    def at_once(self) -> int:
        return sum(self._client.nthreads().values())

    @property
    def threads(self) -> int | None:
        if self.scheduler is not None:
            return None
        return max(1, len(own_cores()) // self.workers)

    def answers(self, work: Work, jobs: Sequence[Job], progress: Progress) -> Iterator[Answer]:
        from distributed import CancelledError, wait

        waiting = [self._client.submit(work, dict(job), None, pure=False) for job in jobs]
        lost: float | None = None  # since when nothing is heard of the scheduler
        while waiting:
            now = time.monotonic()
            lost = None if self._client.status == "running" else lost or now
            if lost is not None and now - lost > ANSWER_S:
                raise ConnectionError(f"the scheduler {self.scheduler or 'here'} has gone")
            try:
                done, left = wait(waiting, timeout=PATIENCE_S, return_when="FIRST_COMPLETED")
            except TimeoutError:
                progress(0.0, "")
                continue
            except CancelledError:  # of a client that has lost its scheduler
                time.sleep(PATIENCE_S)
                continue
            waiting = list(left)
            for future in done:
                try:
                    answer = future.result()
                except (OSError, CancelledError):
                    time.sleep(PATIENCE_S)
                    if self._client.status == "running":  # the work's own
                        raise
                    waiting.append(future)
                    continue
                yield answer


def own_sources() -> str:
    """A hash of the sources of this process."""
    return combined_hash(package_files())


def dask_setup(worker: Any) -> None:
    """Set up a worker that is started here, as dask calls it: Ctrl-C, which a terminal sends to all
    processes, is left to the one that started them."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)


def cores_here() -> tuple[str, list[int]]:
    """The machine and the cores of the process that this runs in."""
    return platform.node(), own_cores()


class Dask(ExecutorOptions):
    """Workers of dask.distributed: of a scheduler, or processes on this machine.
    ``scheduler``: its address, None to start ``workers`` processes here; ``wait_s``: how long to
    wait for its first worker."""

    scheduler: str | None = None
    workers: int = integer(2, least=1, most=1024)
    wait_s: float = number(WAIT_S, least=0.0, most=1e7, unit="s")

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.scheduler is not None and not (
            isinstance(self.scheduler, str) and ADDRESS.fullmatch(self.scheduler)
        ):
            raise ParameterError(
                "executor.scheduler", self.scheduler, "null, or an address like tcp://host:8786"
            )

    def executor(self) -> DaskExecutor:
        return DaskExecutor(self.scheduler, self.workers, self.wait_s)
