"""``executor=local``: one job after another in this process, each on all of its cores."""

import os
from collections.abc import Iterator, Sequence

from snapjump.executor.base import Answer, ExecutorOptions, Job, Progress, Work


class LocalExecutor:
    """Nothing to claim and nothing that could fail."""

    def check(self) -> None:
        """It can always work."""

    def __enter__(self) -> "LocalExecutor":
        return self

    def __exit__(self, *error: object) -> None:
        pass

    @property
    def cores(self) -> int:
        return len(os.sched_getaffinity(0))

    @property
    def at_once(self) -> int:
        return 1

    @property
    def threads(self) -> None:
        return None

    def answers(self, work: Work, jobs: Sequence[Job], progress: Progress) -> Iterator[Answer]:
        for job in jobs:
            yield work(job, progress)


class Local(ExecutorOptions):
    """This process, with all threads that the backend has."""

    def executor(self) -> LocalExecutor:
        return LocalExecutor()
