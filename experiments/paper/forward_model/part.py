"""The dataset, the forward model and inverse design, as the paper makes them and as we do."""

import re
from collections.abc import Mapping
from dataclasses import asdict
from functools import partial
from typing import Any

from experiments.paper.forward_model.compute import (
    METHODS,
    NETWORK,
    PLAN,
    SHARD_SIZE,
    dataset_rows,
    forward_rows,
    inverse_rows,
)
from experiments.paper.forward_model.judge import (
    accuracy_statement,
    dataset_statement,
    error_statement,
    speed_statement,
)

from experiments.inverse_benchmark.study import stretches
from experiments.inverse_benchmark.table import summary_row
from experiments.paper.base import Found, Part, unfinished
from experiments.paper.forward_model.figure import draw_forward_model
from experiments.paper.learned import shipped_inputs
from snapjump.declare.members import make_member, member_class, member_group
from snapjump.learning.training import Training
from snapjump.run.studies.base import Cell, Done, Figure, Row, Section, Table

DATASET, NETWORK_CELL = "dataset", "forward model"
SHOWN = ("method", "problems", "mean_mm_standard", "std_mm_standard", "p95_mm_standard",
         "max_mm_standard", "mean_mm_reference", "seconds_median", "simulations_mean")  # fmt: skip
BLOCK = 10  # problems of a cell, which are lost together if it is stopped


TITLE = "Dataset, forward model, inverse design"
PARAGRAPHS = (
    "The paper's grid of 15 values of each of the four inputs, its network of three layers of 372 "
    "neurons, and its search by Adam from the best point of a grid, beside the library's own "
    "methods. Each target is the apex of a hidden random design in a random environment, so that "
    "it can be reached.",
    "More methods, more targets and the time of each: `python run.py task=inverse_benchmark`; more "
    "forward models: `python run.py task=compare_surrogates`.",
)


class ForwardModels(Part):
    """From nothing: 50,625 jumps, the paper's network on them, and designs for random targets."""

    name = "forward_model"
    sources = ("experiments.paper.forward_model.compute",)

    def plan(self, groups: Mapping[str, Any], seed: int) -> list[Cell]:
        """The dataset, the network, then each method on its targets, ten at a time."""
        options = member_class("plan", PLAN["name"])()
        data = {
            "groups": groups,
            "plan": {**PLAN, **asdict(options)},
            "shard_size": SHARD_SIZE,
            "seed": seed,
        }
        learned = {
            **data,
            "training": asdict(Training()),
            "surrogate": member_group(member_class("surrogate", NETWORK)()),
        }
        cells = [Cell(DATASET, data), Cell(NETWORK_CELL, learned)]
        for name, method in METHODS.items():
            shipped = {} if method.network else {"surrogate": None, **shipped_inputs(groups)}
            asked = {**learned, **shipped}
            inverse = member_group(make_member("inverse", method.inverse))
            cells += [
                Cell(
                    f"{name}: targets {first} to {last - 1}",
                    {**asked, "method": name, "inverse": inverse, "first": first, "last": last},
                )
                for first, last in stretches(method.problems, BLOCK)
            ]
        return cells

    def compute(self, inputs: Mapping[str, Any]) -> list[Row]:
        """The rows of one of the three kinds of cells."""
        if "method" in inputs:
            return inverse_rows(inputs)
        return forward_rows(inputs) if "surrogate" in inputs else dataset_rows(inputs)

    def conclude(self, done: Mapping[str, Done]) -> Found:
        """Four statements."""
        missing = unfinished(TITLE, done)
        if missing:
            return missing
        methods: dict[str, list[Row]] = {name: [] for name in METHODS}
        for one in done.values():
            if "method" in one.cell.inputs:
                methods[one.cell.inputs["method"]] += one.rows
        made, (learned, *predictions) = done[DATASET].rows, done[NETWORK_CELL].rows
        judged = {name: summary_row(name, rows) for name, rows in methods.items()}
        figure = Figure(
            "How far predicted apexes are off, of jumps that the network has not seen; and the "
            "simulated misses of designs (number of targets in brackets)",
            partial(draw_forward_model, predictions, methods),
        )
        tables = {
            "dataset_cost": Table("The dataset", made),
            "network": Table("The paper's network", [measures(learned)]),
            "inverse_methods": Table(
                "Misses of random reachable targets, in mm at L = 20 mm",
                [{key: row[key] for key in SHOWN} for row in judged.values()],
            ),
        }
        return Found(
            Section(TITLE, PARAGRAPHS, {"forward_model": figure}, tables),
            [
                dataset_statement(made[0]),
                error_statement(learned),
                accuracy_statement(judged),
                speed_statement(judged),
            ],
            summary={
                **{f"dataset_{key}": value for key, value in made[0].items()},
                **{f"network_{key}": value for key, value in measures(learned).items()},
                **{
                    f"mean_mm_{snake_case(name)}": row["mean_mm_standard"]
                    for name, row in judged.items()
                },
            },
        )


def measures(row: Row) -> Row:
    """The numbers of the network's row."""
    return {key: value for key, value in row.items() if key != "kind"}


def snake_case(name: str) -> str:
    """A method's name as a key."""
    return re.sub(r"\W+", "_", name)
