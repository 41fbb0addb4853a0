"""The contract of an executor: does pieces of work, here or elsewhere, and hands back answers."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any, Self

from snapjump.declare.fields import Part, required
from snapjump.declare.scenes import Progress
from snapjump.files.cores import own_cores

Job = Mapping[str, Any]  # plain JSON, since it may travel
Answer = dict[str, Any]  # likewise
Work = Callable[[Job, Progress | None], Answer]


class Executor:
    """``with executor:`` claims what it needs and lets go of it. By default it works in this
    process, and there is nothing to claim and nothing that could fail."""

    def check(self) -> None:
        """Find out quickly whether it can work; raises ParameterError."""

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *error: object) -> None:
        """Let go."""

    @property
    def cores(self) -> int:
        """Processor cores that work at once."""
        return len(own_cores())

    @property
    def at_once(self) -> int:
        """Jobs that are done at once."""
        return 1

    @property
    def threads(self) -> int | None:
        """Threads that a job is to use; None: as many as its process has cores."""
        return None

    def answers(self, work: Work, jobs: Sequence[Job], progress: Progress) -> Iterator[Answer]:
        """The answer to each job as soon as it is there, in any order.

        ``work`` is a function of a module. ``progress`` hears of the job under way where that is
        known, else of 0.0 from time to time. What ``work`` raises, this raises.
        """
        raise NotImplementedError


class ExecutorOptions(Part):
    """An executor and its numbers."""

    group = "executor"

    @required
    def executor(self) -> Executor:
        """What does the work."""
        raise NotImplementedError
