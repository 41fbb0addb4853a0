"""What a part comes to when cells of it have failed: no verdict without all of its numbers."""

from collections.abc import Mapping

from experiments.paper.base import Found
from experiments.paper.failures import failed
from snapjump.studies.base import OK, Done, Section


def unfinished(title: str, done: Mapping[str, Done], jumps: bool = False) -> Found | None:
    """A section that names the cells without rows, and why; None if there are none.

    jumps: so do cells in which a jump failed, for statements that need all of a sweep.
    """
    told = [f"{name} ({one.status}: {one.message})" for name, one in done.items()
            if one.status != OK]  # fmt: skip
    if jumps:
        told += [incomplete(name, one) for name, one in done.items() if failed(one.rows)]
    if not told:
        return None
    return Found(Section(title, [f"Not judged, for want of these cells: {'; '.join(told)}."]), [])


def incomplete(name: str, one: Done) -> str:
    """A cell with failed jumps, for reading."""
    lost = failed(one.rows)
    reasons = ", ".join(sorted({row["status"] for row in lost}))
    return f"{name} ({len(lost)} of {len(one.rows)} jumps failed: {reasons})"
