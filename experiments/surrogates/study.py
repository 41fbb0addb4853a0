"""``python run.py task=compare_surrogates``: what forward models learn from how many jumps."""

from collections.abc import Mapping
from dataclasses import asdict
from functools import partial
from typing import Any

import numpy as np

from experiments.compositions import described
from experiments.surrogates.figures import draw_curves, draw_places
from snapjump.checks import ParameterError
from snapjump.composition import with_tier
from snapjump.members import make_member, member_class, member_group, member_names
from snapjump.studies.base import OK, Cell, Conclusion, Done, Figure, Row, Table
from snapjump.studies.study import Study
from snapjump.terminal.block import markdown_table

# Jumps to learn from, (quick, full); beside them as many as there are.
SIZES = ((500, 2000, 8000), (500, 1000, 2000, 4000, 8000, 16000))
# Quick trains these on fewer jumps as well; the others on all of them only.
CURVES = ("mlp", "resnet", "rbf")
PAPER_MLP, PAPER_MAE_BAR = "mlp", 0.07
FLOOR_CELLS = (48, 256)
FLOOR = "floor at {}"
LONGEST, SMALLEST_BATCH = 1200, 16  # epochs, and jumps
COLUMNS = ("mae_bar", "mae_x_bar", "mae_y_bar", "p95_bar", "coverage", "parameters", "epochs",
           "train_seconds", "inference_us")  # fmt: skip


class CompareSurrogates(Study):
    """Error against jumps; what the paper's data cost; the floor; where the error sits."""

    options = ("standard", "paper", "slopes")
    sources = ("experiments.surrogates.compute",)

    def plan(self, config: Mapping[str, Any]) -> list[Cell]:
        """Every member on its numbers of jumps, and the floors of the tiers."""
        from snapjump.learning.data import JumpData
        from snapjump.learning.training import Training

        datasets = {key: opened(key, config["task"][key]) for key in self.options}
        standard = datasets["standard"]
        if standard is None:
            raise ParameterError("task.standard", None, "the folder of a dataset at standard")
        seed = config["seed"]
        jumps = {
            key: len(data.train.designs) + len(data.validation.designs)
            for key, dataset in datasets.items()
            if dataset is not None
            for data in (JumpData(dataset, Training(), seed),)
        }

        def cell(name: str, member: str, key: str, rows: int | None, **options: Any) -> Cell:
            dataset = datasets[key]
            assert dataset is not None
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
        if datasets["paper"] is not None:
            name = f"{PAPER_MLP}, {jumps['paper']} jumps of the paper's tier"
            cells.append(cell(name, PAPER_MLP, "paper", None))
        if datasets["slopes"] is not None:
            for member in filter(needs_slopes, member_names("surrogate")):
                name = f"{member}, {jumps['slopes']} jumps with slopes"
                cells.append(cell(name, member, "slopes", None))
                name = f"{member}, {jumps['slopes']} jumps, slopes left out"
                cells.append(cell(name, member, "slopes", None, slope_weight=0.0))
        self.tiers = ["standard"] + ["paper"] * (datasets["paper"] is not None)
        plan = standard.specification["plan"]
        ranges = [plan[axis] for axis in ("delta_alpha_rad", "epsilon", "mass_bar", "mu")]
        for tier in self.tiers:
            groups = {
                "groups": described(with_tier(tier)),
                "ranges": ranges,
                "cells": FLOOR_CELLS[self.full],
                "seed": seed,
            }
            cells.append(Cell(FLOOR.format(tier), groups))
        return cells

    def compute(self, cell: Cell) -> list[Row]:
        """See :mod:`experiments.surrogates.compute`."""
        from experiments.surrogates.compute import floor_of, trained_rows

        return trained_rows(cell.inputs) if "surrogate" in cell.inputs else floor_of(cell.inputs)

    def conclude(self, done: Mapping[str, Done]) -> Conclusion:
        """The table, the learning curves, and where the best member is off."""
        trained = {
            name: one
            for name, one in done.items()
            if "surrogate" in one.cell.inputs and one.status == OK
        }
        table = [summary(name, one) for name, one in trained.items()]
        floors = [floor_summary(tier, done[FLOOR.format(tier)]) for tier in self.tiers]
        whole = {name: one for name, one in trained.items() if one.cell.inputs["places"]}
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


def opened(key: str, path: Any) -> Any:
    """A dataset, or None. Raises ParameterError that names the key."""
    from snapjump.dataset.read import open_dataset

    if path is None:
        return None
    if not isinstance(path, str):
        raise ParameterError(f"task.{key}", path, "null, or the folder of a dataset")
    try:
        return open_dataset(path)
    except ParameterError as error:
        raise ParameterError(f"task.{key}", path, error.allowed) from None


def needs_slopes(member: str) -> bool:
    """Whether a surrogate learns from derivatives."""
    return bool(member_class("surrogate", member)().network().needs_slopes)


def completed(member: str, changes: Mapping[str, Any]) -> dict[str, Any]:
    """The group of a surrogate with its defaults, some of them changed."""
    group = {**member_group("surrogate", member_class("surrogate", member)()), **changes}
    make_member("surrogate", group)
    return group


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


def summary(name: str, done: Done) -> Row:
    """One line of the table."""
    row = done.rows[0]
    return {
        "surrogate": name,
        "jumps": row["jumps"],
        **{key: row.get(key) for key in COLUMNS},
        "own_mae_bar": row["own_mae_bar"],
    }


def floor_summary(tier: str, done: Done) -> Row:
    """Both outputs averaged, over the cells."""
    x, y = done.column("x_bar"), done.column("y_bar")
    both = 0.5 * (x + y)
    return {
        "tier": tier,
        "cells": len(both),
        "mean_bar": float(np.mean(both)),
        "median_bar": float(np.median(both)),
        "p95_bar": float(np.quantile(both, 0.95)),
        "mean_x_bar": float(np.mean(x)),
        "mean_y_bar": float(np.mean(y)),
    }


def readme_block(table: list[Row], floors: list[Row]) -> str:
    """The table for people: what was trained on most jumps, and on few."""
    header = ["trained on", "error (L)", "of x, y", "training (s)", "a design (us)"]
    lines = [
        [
            f"`{row['surrogate'].split(',')[0]}`,{row['surrogate'].partition(',')[2]}",
            f"{row['mae_bar']:.2g}",
            f"{row['mae_x_bar']:.2g}, {row['mae_y_bar']:.2g}",
            f"{row['train_seconds']:.0f}",
            f"{row['inference_us']:.0f}",
        ]
        for row in sorted(table, key=lambda row: float(row["mae_bar"]))
    ]
    below = "; ".join(f"{row['mean_bar']:.2g} L at `{row['tier']}`" for row in floors)
    return markdown_table(header, lines) + (
        "\n\nError: mean absolute, x and y averaged, on the held-out 20 % of the `standard` grid\n"
        "(the paper: 0.07 on its own data). What a cubic through 128 more jumps within a cell\n"
        f"of the grid still leaves, in the mean: {below}.\n"
        "`python run.py task=compare_surrogates publish=docs/studies` makes this table."
    )


def findings(table: list[Row], floors: list[Row], best: str, worst: Row) -> list[str]:
    """Sentences."""
    told = [
        f"{row['surrogate']}: MAE {row['mae_bar']:.3g} L"
        + (f", 90 % intervals hold {100 * row['coverage']:.3g} %" if row["coverage"] else "")
        + f"; {row['train_seconds']:.3g} s of training, {row['inference_us']:.3g} us a design."
        for row in table
    ]
    for row in floors:
        told.append(
            f"Floor at {row['tier']}: a cubic through 128 jumps in a cell of the grid leaves "
            f"{row['mean_bar']:.2g} L in the mean over {row['cells']} cells, "
            f"{row['median_bar']:.2g} in the median, {row['p95_bar']:.2g} at 95 %."
        )
    shares = {k: v for k, v in worst.items() if k.startswith("share_of_worst_")}
    words = [f"{key.split('_')[3]} % of the designs have {100 * value:.0f} %"
             for key, value in shares.items()]  # fmt: skip
    told.append(f"The error of {best} sits in few places: the worst {', '.join(words)} of it.")
    return told
