"""Exit codes by status."""

from collections.abc import Sequence

from snapjump.run.tasks.base import BAD_INPUT, ERROR, FINISHED, INTERRUPTED, UNREACHABLE

EXIT_OK = 0
EXIT_ERROR = 1
EXIT_BAD_INPUT = 2
EXIT_FAILED = 3
EXIT_UNREACHABLE = 4
EXIT_UNTRACKED = 5
EXIT_INTERRUPTED = 130


def exit_code(status: str) -> int:
    """The exit code of one job."""
    special = {
        BAD_INPUT: EXIT_BAD_INPUT,
        ERROR: EXIT_ERROR,
        INTERRUPTED: EXIT_INTERRUPTED,
        UNREACHABLE: EXIT_UNREACHABLE,
    }
    return special.get(status, EXIT_OK if status in FINISHED else EXIT_FAILED)


def sweep_exit_code(statuses: Sequence[str]) -> int:
    """The exit code of a sweep: a cell that failed counts before one that had bad input."""
    if all(status in FINISHED for status in statuses):
        return EXIT_OK
    bad = {status for status in statuses if status not in FINISHED}
    return EXIT_BAD_INPUT if bad == {BAD_INPUT} else EXIT_FAILED
