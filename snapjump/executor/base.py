"""The contract of an executor: does pieces of work, here or elsewhere, and hands back answers."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any, Protocol

from snapjump.declare.fields import Part, required

Job = Mapping[str, Any]  # plain JSON, since it may travel
Answer = dict[str, Any]  # likewise
Progress = Callable[[float], None]  # share of a job that is done
Work = Callable[[Job, Progress | None], Answer]


class Executor(Protocol):
    """``with executor:`` claims what it needs and lets go of it."""

    def check(self) -> None:
        """Find out quickly whether it can work; raises ParameterError."""

    def __enter__(self) -> "Executor": ...

    def __exit__(self, *error: object) -> None: ...

    @property
    def cores(self) -> int:
        """Processor cores that work at once."""

    @property
    def at_once(self) -> int:
        """Jobs that are done at once."""

    @property
    def threads(self) -> int | None:
        """Threads that a job is to use; None: as many as its process has cores."""

    def answers(self, work: Work, jobs: Sequence[Job], progress: Progress) -> Iterator[Answer]:
        """The answer to each job as soon as it is there, in any order.

        ``work`` is a function of a module. ``progress`` hears of the job under way where that is
        known, else of 0.0 from time to time. What ``work`` raises, this raises.
        """


class ExecutorOptions(Part):
    """An executor and its numbers."""

    group = "executor"

    @required
    def executor(self) -> Executor:
        """What does the work."""
        raise NotImplementedError
