"""The cells of a sweep, as their folders tell, and the results that are shown of them."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

from snapjump.files.provenance import source_hash
from snapjump.files.result_folder import ResultFolder
from snapjump.run.tasks import base
from snapjump.run.tasks.base import FINISHED
from snapjump.run.tasks.names import cell_name
from snapjump.run.tasks.sweep import Sweep, cell_folder, cells_of
from snapjump.tracking.parts.tracked import numbers_of

NOT_STARTED = "not_started"
# Results worth a column and an axis where a scene has them; else its first numbers.
FAVOURITES = ("x_bar", "y_bar")
SECONDS = "wall_seconds"


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


def read_cells(sweep: Sweep) -> list[Cell]:
    """Every cell of the sweep, as its folder tells."""
    cells = []
    found = cells_of(sweep)
    for overrides, inputs in zip(found, swept_inputs(found), strict=True):
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


def main_results(cells: Sequence[Cell]) -> list[str]:
    """The two results that say most."""
    keys = list(dict.fromkeys(key for cell in cells for key in cell.numbers))
    favourites = [key for key in FAVOURITES if key in keys]
    return favourites or [key for key in keys if key != SECONDS][:2]
