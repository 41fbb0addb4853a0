"""A table of measured clamp angles, as a CSV file or as rows."""

import csv
import math
from itertools import pairwise
from pathlib import Path
from typing import Any

from snapjump.checks import ParameterError, check_number

COLUMNS = ("time_s", "left_rad", "right_rad")
FEWEST, MOST = 3, 2000
Rows = tuple[tuple[float, float, float], ...]


def read_rows(file: Any) -> Rows:
    """The rows of a CSV file. Raises ParameterError."""
    allowed = (
        f"a CSV file with a line of headings, {', '.join(COLUMNS)}, and {FEWEST} rows at least"
    )
    if not isinstance(file, str):
        raise ParameterError("drive.file", file, allowed)
    try:
        text = Path(file).read_text(encoding="utf-8-sig")
    except (OSError, ValueError) as error:
        why = getattr(error, "strerror", None) or "no text"
        raise ParameterError("drive.file", file, f"{allowed} ({why})") from error
    table = csv.DictReader(text.splitlines(), skipinitialspace=True)
    missing = [name for name in COLUMNS if name not in (table.fieldnames or ())]
    if missing:
        raise ParameterError("drive.file", file, f"{allowed} (it lacks {', '.join(missing)})")
    rows = []
    for count, row in enumerate(table, 2):
        try:
            rows.append([float(row[name]) for name in COLUMNS])
        except (TypeError, ValueError) as error:
            told = f"numbers in line {count} ({row})"
            raise ParameterError("drive.file", file, told) from error
    return checked_rows("drive.file", rows)


def checked_rows(key: str, rows: Any) -> Rows:
    """The rows as tuples, times ascending, angles between both right angles. Raises
    ParameterError."""
    if isinstance(rows, str) or not hasattr(rows, "__len__") or not FEWEST <= len(rows) <= MOST:
        count = len(rows) if hasattr(rows, "__len__") else rows
        raise ParameterError(key, count, f"{FEWEST} to {MOST} rows of {', '.join(COLUMNS)}")
    for row in rows:
        if isinstance(row, str) or not hasattr(row, "__len__") or len(row) != len(COLUMNS):
            raise ParameterError(key, row, f"rows of {', '.join(COLUMNS)}")
        check_number(f"{key} (time_s)", row[0], -1e9, 1e9, unit="s")
        for name, angle in zip(COLUMNS[1:], row[1:], strict=True):
            check_number(f"{key} ({name})", angle, -math.pi / 2, math.pi / 2, unit="rad")
    for before, after in pairwise(rows):
        if not before[0] < after[0]:
            allowed = f"times that ascend (after {before[0]:g} s)"
            raise ParameterError(f"{key} (time_s)", after[0], allowed)
    return tuple((float(row[0]), float(row[1]), float(row[2])) for row in rows)
