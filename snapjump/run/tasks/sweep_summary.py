"""The summary of a sweep: a table on the terminal and on disk, a figure, and the parent record."""

import os
import sys
from collections import Counter
from collections.abc import Sequence

from snapjump.files.atomic import write_text
from snapjump.files.provenance import git_state, now
from snapjump.run.tasks import base
from snapjump.run.tasks.base import FINISHED
from snapjump.run.tasks.sweep import Sweep
from snapjump.run.tasks.sweep_cells import (
    NOT_STARTED,
    SECONDS,
    Cell,
    main_results,
    mark_lost,
    read_cells,
)
from snapjump.run.tasks.sweep_figure import draw
from snapjump.show.terminal.block import markdown_table, number, table
from snapjump.tracking.base import TrackingError
from snapjump.tracking.parts.tracked import record_folder


def summarise(sweep: Sweep, stopped_by: BaseException | None) -> int:
    """Write and print the table, complete the records; returns the exit code of the sweep."""
    cells = read_cells(sweep)
    mark_lost(cells)
    interrupted = isinstance(stopped_by, KeyboardInterrupt)
    if stopped_by is not None and all(cell.status == NOT_STARTED for cell in cells):
        _record(sweep, [], [], interrupted)
        return base.EXIT_INTERRUPTED if interrupted else base.EXIT_BAD_INPUT
    header, rows = summary_table(cells)
    write_text(sweep.folder / "summary.csv", full_csv(cells))
    write_text(sweep.folder / "summary.md", markdown_table(header, rows) + "\n")
    files = ["summary.csv", "summary.md"]
    if draw(sweep, cells):
        files.append("summary.png")
    recorded = _record(sweep, cells, files, interrupted)
    print(f"\n{table(header, rows)}\n")
    counts = ", ".join(f"{n} {status}" for status, n in by_status(cells).items())
    print(f"{len(cells)} cells: {counts}; files in {os.path.relpath(sweep.folder)}")
    if interrupted:
        return base.EXIT_INTERRUPTED
    code = base.sweep_exit_code([cell.status for cell in cells])
    return code or (0 if recorded else base.EXIT_UNTRACKED)


def best(cells: Sequence[Cell]) -> dict[str, float]:
    """The largest of each main result."""
    return {
        f"largest_{key}": max(cell.numbers[key] for cell in cells if key in cell.numbers)
        for key in main_results(cells)
    }


def by_status(cells: Sequence[Cell]) -> Counter[str]:
    """Counts of cells by status."""
    return Counter(cell.status for cell in cells)


def summary_table(cells: Sequence[Cell]) -> tuple[list[str], list[list[str]]]:
    """The columns for reading: inputs, status, the main results, seconds and any message."""
    inputs = list(cells[0].inputs) if cells else []
    results = main_results(cells)
    header = [*inputs, "status", *results, "seconds", "remark"]
    rows = [
        [
            *cell.inputs.values(),
            cell.status,
            *[number(cell.result.get(key)) for key in results],
            number(cell.result.get(SECONDS)),
            str(cell.result.get("message", "kept from before" if cell.kept else "")),
        ]
        for cell in cells
    ]
    return header, rows


def full_csv(cells: Sequence[Cell]) -> str:
    """Every result of every cell."""
    import pandas as pd

    inputs = list(cells[0].inputs) if cells else []
    results = list(dict.fromkeys(key for cell in cells for key in cell.result))
    rows = [
        [*cell.inputs.values(), *[cell.result.get(key) for key in results], cell.name]
        for cell in cells
    ]
    table = pd.DataFrame(rows, columns=[*inputs, *results, "folder"], dtype=object)
    return str(table.to_csv(index=False))


def _record(sweep: Sweep, cells: Sequence[Cell], files: Sequence[str], interrupted: bool) -> bool:
    """Record cells whose own process could not, then complete the parent; False if in vain."""
    if sweep.parent_id is None:
        return True
    counts = {f"cells_{status}": float(n) for status, n in by_status(cells).items()}
    done = bool(cells) and all(cell.status in FINISHED for cell in cells)
    record = sweep.record(
        "KILLED" if interrupted else "FINISHED" if done else "FAILED",
        now(),
        metrics={"cells": float(len(cells)), **counts, **best(cells)},
        tags={
            "folder": str(sweep.folder),
            "mlflow.source.git.commit": str(git_state()["git_revision"]),
            "git_dirty": str(git_state()["git_dirty"]).lower(),
            "mlflow.note.content": markdown_table(*summary_table(cells)),
        },
        files=[sweep.folder / name for name in files],
    )
    try:
        for cell in cells:
            if cell.status != NOT_STARTED:
                record_folder(sweep.tracker, cell.folder, cell.name, sweep.parent_id)
        sweep.tracker.write(sweep.parent_id, record)
        sweep.tracker.send(sweep.parent_id, record)
    except TrackingError as error:
        print(f"not recorded: {error}", file=sys.stderr)
        return False
    return True
