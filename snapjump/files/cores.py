"""The processor cores that this process may use: those it is bound to, where a system tells."""

import os


def own_cores() -> list[int]:
    """Their numbers; macOS and Windows do not bind processes, and have all of the machine's."""
    if hasattr(os, "sched_getaffinity"):
        return sorted(os.sched_getaffinity(0))
    return list(range(os.cpu_count() or 1))
