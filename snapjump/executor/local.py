"""``executor=local``: one job after another in this process, each on all of its cores."""

from collections.abc import Iterator, Sequence

from snapjump.declare.scenes import Progress
from snapjump.executor.base import Answer, Executor, ExecutorOptions, Job, Work


class LocalExecutor(Executor):
    """One job after another."""

    def answers(self, work: Work, jobs: Sequence[Job], progress: Progress) -> Iterator[Answer]:
        for job in jobs:
            yield work(job, progress)


class Local(ExecutorOptions):
    """This process, with all threads that the backend has."""

    def executor(self) -> LocalExecutor:
        return LocalExecutor()
