"""What a part comes to when cells of it have failed: no verdict without all of its numbers."""

from collections.abc import Mapping

from experiments.paper.base import Found
from snapjump.studies.base import OK, Done, Section


def unfinished(title: str, done: Mapping[str, Done]) -> Found | None:
    """A section that names the cells without rows, and why; None if there are none."""
    told = [f"{name} ({one.status}: {one.message})" for name, one in done.items()
            if one.status != OK]  # fmt: skip
    if not told:
        return None
    return Found(Section(title, [f"Not judged, for want of these cells: {'; '.join(told)}."]), [])
