"""``python run.py task=inverse_benchmark``: every method of inverse design on the same targets."""

from collections.abc import Mapping
from functools import partial
from pathlib import Path
from typing import Any

from experiments.compositions import composed, groups_of
from experiments.inverse_benchmark.figure import draw_benchmark
from experiments.inverse_benchmark.methods import METHODS, PAPER
from experiments.inverse_benchmark.table import readme_block, solved, summary_row, unsolved
from snapjump.checks import ParameterError, check_integer
from snapjump.members import make_member, member_group
from snapjump.studies.base import OK, Cell, Conclusion, Done, Figure, Row, Table
from snapjump.studies.study import Study

BLOCK = 10  # problems of a cell, which are lost together if it is stopped


class InverseBenchmark(Study):
    """Random environments with targets that a hidden random design reaches."""

    options = ("problems", "methods", "checkpoint")
    sources = ("experiments.inverse_benchmark.compute",)

    def plan(self, config: Mapping[str, Any]) -> list[Cell]:
        """Each method on each ten problems."""
        from snapjump.learning.trained import checkpoint_path

        from snapjump.learning.forward_model import open_forward_model

        task = config["task"]
        check_integer("task.problems", task["problems"], 1, 100_000)
        self.methods = chosen(task["methods"])
        groups = groups_of(config)
        simulation = composed(groups)
        if simulation.scene_name != "jump":
            raise ParameterError("sim", simulation.scene_name, "jump with task=inverse_benchmark")
        path = Path(checkpoint_path(task["checkpoint"]))
        forward = open_forward_model(path)
        forward.check_model(simulation)
        count = task["problems"]
        return [
            Cell(
                f"{name}: {first} to {min(first + BLOCK, count) - 1}",
                {
                    "method": name,
                    "inverse": dict(group),
                    "groups": groups,
                    "checkpoint": str(path),
                    "checkpoint_sha256": forward.sha256,
                    "seed": config["seed"],
                    "first": first,
                    "last": min(first + BLOCK, count),
                },
            )
            for name, group in self.methods.items()
            for first in range(0, count, BLOCK)
        ]

    def compute(self, cell: Cell) -> list[Row]:
        """A row for each problem."""
        from experiments.inverse_benchmark.compute import solve_block

        return solve_block(cell.inputs)

    def conclude(self, done: Mapping[str, Done]) -> Conclusion:
        """The table, beside the paper's."""
        rows: dict[str, list[Row]] = {name: [] for name in self.methods}
        for one in done.values():
            if one.status == OK:
                rows[one.cell.inputs["method"]] += one.rows
        rows = {name: found for name, found in rows.items() if found}
        table = [summary_row(name, found) for name, found in rows.items()]
        problems = max((len(found) for found in rows.values()), default=0)
        missed = unsolved(rows)
        return Conclusion(
            title="Inverse design: every method on the same targets",
            findings=[
                *(
                    f"{row['method']}: mean {row['mean_mm_standard']:.2g} mm, largest "
                    f"{row['max_mm_standard']:.2g} mm judged at standard; mean "
                    f"{row['mean_mm_reference']:.2g} mm judged at reference; "
                    f"{row['solved']} of {row['problems']} solved; "
                    f"{row['seconds_median']:.2g} s and {row['simulations_mean']:.3g} simulations "
                    "a target."
                    for row in table
                ),
            ],
            tables={
                "methods": Table("Misses in mm at L = 20 mm", table),
                "unsolved": Table("Targets that methods with the simulator in them missed", missed),
                "paper": Table("The paper, judged by its own program", PAPER),
            },
            figures={
                "misses": Figure(
                    "Misses of all targets, judged at `standard` (left) and at `reference`, and "
                    "what they cost",
                    partial(draw_benchmark, rows),
                )
            },
            summary={
                f"{key}_{row['method'].replace(', ', '_').replace(' ', '_')}": row[source]
                for row in table
                for key, source in (
                    ("mean_mm", "mean_mm_standard"),
                    ("mean_mm_reference", "mean_mm_reference"),
                    ("max_mm", "max_mm_standard"),
                    ("seconds", "seconds_median"),
                    ("solved", "solved"),
                )
            },
            metrics={
                name: {"solved": float(sum(solved(row) for row in one.rows))}
                for name, one in done.items()
                if one.status == OK
            },
            blocks={"inverse": readme_block(table, problems)},
        )


def chosen(methods: Any) -> dict[str, Mapping[str, Any]]:
    """Groups of the methods by their names in the table, with every field; None for all."""
    names = list(METHODS) if methods is None else methods
    if not isinstance(names, list) or not names or not set(names) <= set(METHODS):
        raise ParameterError("task.methods", methods, "null, or a list of " + "; ".join(METHODS))
    full = {}
    for name in names:
        options = completed(METHODS[name])
        full[name] = member_group("inverse", options)
    return full


def completed(group: Mapping[str, Any]) -> Any:
    """Options of a group that leaves fields at their defaults."""
    from snapjump.members import member_class

    defaults = member_group("inverse", member_class("inverse", str(group["name"]))())
    return make_member("inverse", {**defaults, **group})
