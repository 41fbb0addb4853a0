"""Studies' cells that are done, studies that are run, and the pictures of a conclusion."""

from pathlib import Path
from typing import Any

from small_datasets import CONFIG, silent

from experiments.compositions import described
from snapjump.composition import with_tier
from snapjump.files.result_folder import ResultFolder
from snapjump.run.studies.base import OK, Cell, Done
from snapjump.simulation import build

STANDARD = described(with_tier("standard"))
COARSE = described(build(CONFIG))
# What every study is given besides its task.
GIVEN: dict[str, Any] = {"effort": "quick", "figures": True, "publish": None, "seed": 0}


def done(cell: Any, rows: Any, status: str = OK, message: str = "") -> Done:
    """A cell, or one of that name, with its rows."""
    cell = Cell(cell, {}) if isinstance(cell, str) else cell
    return Done(cell, status, message, rows, "run", "", "")


def all_done(part: Any, groups: Any, rows_of: Any = None) -> dict[str, Done]:
    """The cells that a part plans, computed or with rows that are made up."""
    rows_of = rows_of or (lambda cell: part.compute(cell.inputs))
    return {cell.name: done(cell, rows_of(cell)) for cell in part.plan(groups, 0)}


def check_figures(found: Any, folder: Path, least: int = 10_000) -> None:
    """Every figure of a part can be drawn, and is not empty."""
    for name, figure in found.section.figures.items():
        figure.draw(folder / f"{name}.png")
        assert (folder / f"{name}.png").stat().st_size > least


def run_study(study: Any, config: Any, path: Path) -> Any:
    """The outcome of a study in a new folder, and the folder."""
    study.prepare(config)
    path.mkdir()
    folder = ResultFolder(path)
    folder.begin()
    return study.run(folder, silent), folder
