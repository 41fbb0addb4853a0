"""``python run.py task=compare_surrogates``: what forward models learn from how many jumps."""

from collections.abc import Mapping
from dataclasses import asdict
from functools import partial
from typing import Any

import numpy as np

from snapjump.checks import ParameterError
from snapjump.declare.members import make_member, member_class, member_group, member_names
from snapjump.plan.parts.axes import default_axes
from snapjump.run.studies.base import OK, Cell, Conclusion, Done, Figure, Row, Table
from snapjump.run.studies.study import Study

from .figures import draw_curves, draw_places
from .table import findings, floor_summary, readme_block, summary

# Jumps to learn from, (quick, full); beside them as many as there are.
SIZES = ((500, 2000, 8000), (500, 1000, 2000, 4000, 8000, 16000))
# Quick trains these on fewer jumps as well; the others on all of them only.
CURVES = ("mlp", "resnet", "rbf")
PAPER_MLP, PAPER_MAE_BAR = "mlp", 0.07
FLOOR_CELLS = (48, 256)
FLOOR = "floor at {}"
LONGEST, SMALLEST_BATCH = 1200, 16  # epochs, and jumps


class CompareSurrogates(Study):
    """Error against jumps; what the paper's data cost; the floor; where the error sits."""

    keys = ()

    options = ("standard", "paper", "slopes")
    sources = ("experiments.surrogates.compute",)

    def plan(self, config: Mapping[str, Any]) -> list[Cell]:
        """Every member on its numbers of jumps, and the floors of the tiers."""
        from snapjump.learning.data import JumpData
        from snapjump.learning.training import Training

        given = {key: path for key in self.options if (path := config["task"][key]) is not None}
        datasets = {key: opened(key, path) for key, path in given.items()}
        check_datasets(datasets)
        standard, seed = datasets["standard"], config["seed"]
        parts = {key: JumpData(one, Training(), seed) for key, one in datasets.items()}
        jumps = {k: len(p.train.designs) + len(p.validation.designs) for k, p in parts.items()}

        def cell(name: str, member: str, key: str, rows: int | None, **options: Any) -> Cell:
            dataset = datasets[key]
            inputs = {
                "surrogate": completed(member, options),
                "training": asdict(training_of(rows, jumps[key])),
                "dataset": str(dataset.folder.path),
                "dataset_sha256": dataset.sha256,
                "judge": str(standard.folder.path),
                "judge_sha256": standard.sha256,
                "places": key == "standard" and rows is None,
                "seed": seed,
            }
            return Cell(name, inputs)

        cells = []
        for member in member_names("surrogate"):
            if needs_slopes(member):
                continue
            sizes = SIZES[self.full] if self.full or member in CURVES else ()
            for rows in (*sizes, None):
                if rows is None or rows < jumps["standard"]:
                    count = rows or jumps["standard"]
                    cells.append(cell(f"{member}, {count} jumps", member, "standard", rows))
        if "paper" in datasets:
            name = f"{PAPER_MLP}, {jumps['paper']} jumps of the paper's tier"
            cells.append(cell(name, PAPER_MLP, "paper", None))
        if "slopes" in datasets:
            for member in filter(needs_slopes, member_names("surrogate")):
                name = f"{member}, {jumps['slopes']} jumps with slopes"
                cells.append(cell(name, member, "slopes", None))
                if "slope_weight" in completed(member, {}):
                    name = f"{member}, {jumps['slopes']} jumps, slopes left out"
                    cells.append(cell(name, member, "slopes", None, slope_weight=0.0))
        self.floors = [key for key in ("standard", "paper") if key in datasets]
        for key in self.floors:
            inputs = {
                "groups": datasets[key].specification["configuration"],
                "ranges": [list(axis.range) for axis in datasets[key].axes],
                "cells": FLOOR_CELLS[self.full],
                "seed": seed,
            }
            cells.append(Cell(FLOOR.format(key), inputs))
        return cells

    def compute(self, cell: Cell) -> list[Row]:
        from .compute import floor_of, trained_rows

        return trained_rows(cell.inputs) if "surrogate" in cell.inputs else floor_of(cell.inputs)

    def conclude(self, done: Mapping[str, Done]) -> Conclusion:
        trained = {
            name: one
            for name, one in done.items()
            if "surrogate" in one.cell.inputs and one.status == OK
        }
        table = [summary(name, one) for name, one in trained.items()]
        looked = {key: done[FLOOR.format(key)] for key in self.floors}
        floors = [floor_summary(key, one) for key, one in looked.items() if one.status == OK]
        whole = {name: one for name, one in trained.items() if one.cell.inputs["places"]}
        if not whole:
            raise RuntimeError("no surrogate was trained on all jumps: see failures.txt")
        best = min(whole, key=lambda name: whole[name].rows[0]["mae_bar"])
        places = [row for row in whole[best].rows if row["kind"] == "place"]
        return Conclusion(
            title="Forward models compared",
            findings=findings(table, floors, best, whole[best].rows[0]),
            tables={
                "surrogates": Table("Errors on the held-out 20 % of the standard grid (L)", table),
                "floors": Table(
                    "What a cubic through 128 jumps leaves within a cell of the grid (L)", floors
                ),
                "places": Table(
                    f"Where {best} is off (L)",
                    [{k: v for k, v in row.items() if k != "kind"} for row in places],
                ),
            },
            figures={
                "curves": Figure(
                    "Error on the held-out 20 % of the standard grid against the jumps that were "
                    "learned from, and against the time of training",
                    partial(draw_curves, table, floors, PAPER_MAE_BAR),
                ),
                "places": Figure(
                    f"Where {best} is off: mean absolute error in fifths of each input",
                    partial(draw_places, places),
                ),
            },
            summary={
                f"mae_bar_{row['surrogate'].replace(', ', '_').replace(' ', '_')}": row["mae_bar"]
                for row in table
            }
            | {f"floor_bar_{row['tier']}": row["mean_bar"] for row in floors},
            blocks={"surrogates": readme_block(table, floors)},
        )


def check_datasets(datasets: Mapping[str, Any]) -> None:
    """Raise ParameterError unless they can be compared: the same plan and split, and slopes."""
    standard, paper, slopes = (datasets.get(key) for key in ("standard", "paper", "slopes"))
    if standard is None:
        raise ParameterError("task.standard", None, "the folder of a dataset at standard")
    for key, dataset in datasets.items():
        if dataset.axes != default_axes([a.range for a in dataset.axes]):
            allowed = "a dataset of the four inputs that are learned from by default"
            raise ParameterError(f"task.{key}", str(dataset.folder.path), allowed)
    if paper is not None:
        ours, theirs = paper.specification, standard.specification
        same = all(ours.get(key) == theirs.get(key) for key in ("plan", "inputs"))
        if not same or paper.statuses != standard.statuses:
            allowed = "null, or a dataset of task.standard's plan with as many jumps that are ok"
            raise ParameterError("task.paper", str(paper.folder.path), allowed)
    if slopes is not None and not slopes.specification["sensitivities"]:
        allowed = "null, or a dataset made with dataset.sensitivities=true"
        raise ParameterError("task.slopes", str(slopes.folder.path), allowed)


def opened(key: str, path: Any) -> Any:
    """A dataset. Raises ParameterError that names the key."""
    from snapjump.dataset.read import load_dataset

    if not isinstance(path, str):
        raise ParameterError(f"task.{key}", path, "null, or the folder of a dataset")
    try:
        return load_dataset(path)
    except ParameterError as error:
        raise ParameterError(f"task.{key}", path, error.allowed) from None


def needs_slopes(member: str) -> bool:
    """Whether a surrogate learns from derivatives."""
    return bool(member_class("surrogate", member)().network().needs_slopes)


def completed(member: str, changes: Mapping[str, Any]) -> dict[str, Any]:
    """The group of a surrogate with its defaults, some of them changed."""
    return member_group(make_member("surrogate", {"name": member, **changes}))


def training_of(rows: int | None, jumps: int) -> Any:
    """The default training; on fewer jumps more epochs of smaller batches, so that descent has its
    steps."""
    from snapjump.learning.training import Training

    standard = Training()
    factor = max(1.0, ((40_500 / (jumps if rows is None else rows)) ** 0.5))
    epochs = min(LONGEST, round(factor * standard.epochs))
    batch = max(SMALLEST_BATCH, 2 ** round(np.log2(standard.batch_first / factor)))
    return Training(
        rows=rows,
        epochs=epochs,
        patience=max(standard.patience, epochs // 4),
        batch_first=batch,
        batch_last=batch * standard.batch_last // standard.batch_first,
    )
