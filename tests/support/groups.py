"""Which tests are for one worker, one after the other, and which of them are begun with.

Compiling takes most of the time. Tests that march with the same compiled programs stay together, so
that neither waits for the other to compile them; the longest groups come first, and what belongs
to none comes last and evens out the workers' times.
"""

from pathlib import Path
from typing import Any

import pytest
from xdist.scheduler import LoadScopeScheduling

# In the order in which they begin: robots one at a time, side by side, and what needs both.
GROUPS = {
    "single": (
        "physics",
        "recorder",
        "stepping",
        "tracking",
        "test_command_line.py",
        "docs/test_tutorial.py",
    ),
    "lanes": ("engine", "batch", "targets", "dataset", "executor", "cuda", "tasks"),
    "studies": ("experiments",),
}


def group_of(place: str) -> str | None:
    """The group of a test file, named relative to the folder of all tests."""
    for name, places in GROUPS.items():
        if any(place == start or place.startswith(f"{start}/") for start in places):
            return name
    return None


def in_order(items: list[pytest.Item], root: Path) -> list[pytest.Item]:
    """The tests in the order of their groups."""
    order: dict[Any, list[pytest.Item]] = {name: [] for name in (*GROUPS, None)}
    for item in items:
        order[group_of(item.path.relative_to(root).as_posix())].append(item)
    return [item for members in order.values() for item in members]


class GroupScheduling(LoadScopeScheduling):
    """A group to a worker, and every other test to the next that is free."""

    def __init__(self, config: pytest.Config, log: Any):
        config.option.loadscopereorder = False
        super().__init__(config, log)

    def _split_scope(self, nodeid: str) -> str:
        return group_of(nodeid.partition("::")[0].removeprefix("tests/")) or nodeid
