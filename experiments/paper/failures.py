"""Jumps that failed: to be told wherever something is concluded from the others."""

from collections.abc import Sequence

from snapjump.engine.status import NAMES, NO_JUMP, OK
from snapjump.studies.base import Row


def failed(rows: Sequence[Row]) -> list[Row]:
    """Jumps that did not end as jumps do, which have no numbers; what has no status is none."""
    return [row for row in rows if row.get("status", NAMES[OK]) not in (NAMES[OK], NAMES[NO_JUMP])]
