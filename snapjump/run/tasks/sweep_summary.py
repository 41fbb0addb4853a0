"""The summary of a sweep: a table on the terminal and on disk, a figure, and the parent record."""

import os
import sys
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from snapjump.files.atomic import write_text
from snapjump.files.provenance import git_state, now, source_hash
from snapjump.files.result_folder import ResultFolder
from snapjump.run.tasks import base
from snapjump.run.tasks.base import FINISHED
from snapjump.run.tasks.names import cell_name
from snapjump.run.tasks.sweep import Sweep, cell_folder
from snapjump.show.plots import palette
from snapjump.show.plots.saving import picture
from snapjump.show.terminal.block import markdown_table, number, table
from snapjump.tracking.base import Record, TrackingError
from snapjump.tracking.parts.tracked import milliseconds, numbers_of, record_folder

NOT_STARTED = "not_started"
# Results worth a column and an axis where a scene has them; else its first numbers.
FAVOURITES = ("x_bar", "y_bar")
SECONDS = "wall_seconds"
PANEL_INCHES, TITLE_INCHES = (3.6, 2.8), 0.5


@dataclass
class Cell:
    """A cell of a sweep, as its folder tells."""

    name: str
    folder: ResultFolder
    inputs: dict[str, str]
    result: dict[str, Any] = field(default_factory=dict)
    kept: bool = False

    @property
    def status(self) -> str:
        return str(self.result["status"])

    @property
    def numbers(self) -> dict[str, float]:
        return numbers_of(self.result)


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


def by_status(cells: Sequence[Cell]) -> Counter[str]:
    """Counts of cells by status."""
    return Counter(cell.status for cell in cells)


def read_cells(sweep: Sweep) -> list[Cell]:
    """Every cell of the sweep, as its folder tells."""
    cells = []
    for overrides, inputs in zip(sweep.cells, swept_inputs(sweep.cells), strict=True):
        name = cell_name(overrides)
        cell = Cell(name, ResultFolder(cell_folder(sweep.folder, name)), inputs)
        origin = cell.folder.provenance() or {}
        cell.result = cell.folder.result() or {"status": NOT_STARTED}
        before = str(origin.get("finished_at", "")) < sweep.started_at
        if before and origin.get("source_sha256") != source_hash():
            cell.result = {"status": NOT_STARTED}
        cell.kept = before and cell.status in FINISHED
        cells.append(cell)
    return cells


def mark_lost(cells: Sequence[Cell]) -> None:
    """Give a status to cells whose process was killed before it could write one."""
    for cell in cells:
        if cell.folder.config() is not None and cell.folder.result() is None:
            cell.result = {"status": base.INTERRUPTED, "message": "ended without a result"}
            cell.folder.write_result(cell.result)


def swept_inputs(cells: Sequence[Sequence[str]]) -> list[dict[str, str]]:
    """Per cell, the keys that differ between cells, with their values."""
    parsed = [dict(text.lstrip("+").split("=", 1) for text in cell) for cell in cells]
    keys = list(dict.fromkeys(key for cell in parsed for key in cell))
    swept = [key for key in keys if len({cell.get(key) for cell in parsed}) > 1]
    return [{key: cell.get(key, "") for key in swept} for cell in parsed]


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


def main_results(cells: Sequence[Cell]) -> list[str]:
    """The two results that say most."""
    keys = list(dict.fromkeys(key for cell in cells for key in cell.numbers))
    favourites = [key for key in FAVOURITES if key in keys]
    return favourites or [key for key in keys if key != SECONDS][:2]


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


def draw(sweep: Sweep, cells: Sequence[Cell]) -> bool:
    """Draw the inputs against the main results, if there is anything to draw."""
    done = [cell for cell in cells if cell.status in FINISHED]
    results = [key for key in main_results(cells) if any(key in cell.numbers for cell in done)]
    if not results or not cells[0].inputs:
        return False
    columns = {key: [cell.inputs[key] for cell in done] for key in cells[0].inputs}
    values = {key: [cell.numbers.get(key) for cell in done] for key in results}
    return ResultFolder(sweep.folder).write_figures(
        lambda folder: sweep_figure(folder / "summary.png", columns, values)
    )


def sweep_figure(
    path: Path, inputs: Mapping[str, Sequence[str]], results: Mapping[str, Sequence[float | None]]
) -> None:
    """One panel for each input and result; words stand at equal distances in their order."""
    size = (PANEL_INCHES[0] * len(inputs), PANEL_INCHES[1] * len(results) + TITLE_INCHES)
    with picture(path, size, "sweep") as figure:
        figure.set_layout_engine("constrained", rect=(0, 0, 1, 1 - TITLE_INCHES / size[1]))
        panels = figure.subplots(len(results), len(inputs), squeeze=False)
        for row, (result, values) in zip(panels, results.items(), strict=True):
            for axes, (name, texts) in zip(row, inputs.items(), strict=True):
                places, words = positions(texts)
                pairs = [(x, y) for x, y in zip(places, values, strict=True) if y is not None]
                axes.plot(*zip(*pairs, strict=True), "o", color=palette.BEAM, alpha=0.8)
                if words:
                    axes.set_xticks(range(len(words)), words)
                axes.set_xlabel(name)
                axes.set_ylabel(result)
                axes.grid(alpha=0.3)


def positions(texts: Sequence[str]) -> tuple[list[float], list[str]]:
    """Positions of an input's values on its axis, and the words to write there if any."""
    try:
        return [float(text) for text in texts], []
    except ValueError:
        words = list(dict.fromkeys(texts))
        return [float(words.index(text)) for text in texts], words


def _record(sweep: Sweep, cells: Sequence[Cell], files: Sequence[str], interrupted: bool) -> bool:
    """Record cells whose own process could not, then complete the parent; False if in vain."""
    if sweep.parent_id is None:
        return True
    counts = {f"cells_{status}": float(n) for status, n in by_status(cells).items()}
    done = bool(cells) and all(cell.status in FINISHED for cell in cells)
    record = Record(
        name=sweep.folder.name,
        state="KILLED" if interrupted else "FINISHED" if done else "FAILED",
        started_ms=milliseconds(sweep.started_at),
        ended_ms=milliseconds(now()),
        metrics={"cells": float(len(cells)), **counts},
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
