"""Which tests are for one worker, one after the other, and which of them are begun with.

Compiling takes most of the time. Tests that march with the same compiled programs stay together, so
that neither waits for the other to compile them; the longest groups come first, and what belongs
to none comes last and evens out the workers' times.
"""

from pathlib import Path
from typing import Any

import pytest
from xdist.scheduler import LoadScopeScheduling

# In the order in which they and their members begin: robots one at a time, side by side, and what
# needs both. What a process compiles itself it has for the next program; what it finds on disk, or
# what a process of its own compiles, it has not.
GROUPS = {
    "single": (
        "physics", "engine/recorder", "stepping", "run/tasks/test_command_line.py", "show/plots",
        "tracking", "docs/test_tutorial.py",
    ),
    "lanes": (
        "engine", "batch", "uncertainty", "targets", "dataset", "executor", "run/tasks",
    ),
    "studies": ("experiments",),
}  # fmt: skip
PLACES = [(group, start) for group, starts in GROUPS.items() for start in starts]


def place_of(file: str) -> int:
    """The position of a test file, named relative to the folder of all tests, in PLACES."""
    for position, (_, start) in enumerate(PLACES):
        if file == start or file.startswith(f"{start}/"):
            return position
    return len(PLACES)


def in_order(items: list[pytest.Item], root: Path) -> list[pytest.Item]:
    return sorted(items, key=lambda item: place_of(item.path.relative_to(root).as_posix()))


class GroupScheduling(LoadScopeScheduling):
    """A group to a worker, and every other test to the next that is free."""

    def __init__(self, config: pytest.Config, log: Any):
        config.option.loadscopereorder = False
        super().__init__(config, log)

    def _split_scope(self, nodeid: str) -> str:
        place = place_of(nodeid.partition("::")[0].removeprefix("tests/"))
        return PLACES[place][0] if place < len(PLACES) else nodeid
