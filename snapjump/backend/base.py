"""Backends: the contract that every one fulfils."""

from typing import TYPE_CHECKING, Any, ClassVar

from snapjump.declare.fields import Part

WIDTHS = (2, 4, 8, 16)
MOST_THREADS = 1024


class BackendOptions(Part):
    """A backend and its numbers: by default, one robot at a time on one core.

    ``processor``: whose arithmetic its bits are. ``one_at_a_time``: whether a robot's whole
    trajectory is recorded, and not its outcome alone.
    """

    group = "backend"
    processor: ClassVar[str] = "cpu"
    one_at_a_time: ClassVar[bool] = False

    @property
    def thread_count(self) -> int:
        """Threads of the processor that a batch is simulated with."""
        return 1

    if TYPE_CHECKING:  # fields of a member that only its family is known of

        def __getattr__(self, name: str) -> Any: ...
