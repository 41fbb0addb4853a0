"""What a part comes to when cells of it are missing: a section that says so, and no verdict."""

from collections.abc import Mapping

from experiments.paper.base import Found
from snapjump.studies.base import OK, Done, Section


def unfinished(title: str, done: Mapping[str, Done]) -> Found | None:
    """The section that names the cells without rows; None if there is none."""
    missing = [f"`{name}`: {one.message}" for name, one in done.items() if one.status != OK]
    if not missing:
        return None
    return Found(
        Section(title, [f"Not judged, because cells have no rows: {'; '.join(missing)}"]), []
    )
