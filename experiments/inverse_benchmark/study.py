"""``python run.py task=inverse_benchmark``: every method of inverse design on the same targets."""

import hashlib
from collections.abc import Mapping
from functools import partial
from typing import Any

from snapjump.checks import ParameterError, check_integer
from snapjump.declare.members import make_member, member_group
from snapjump.run.studies.base import OK, Cell, Conclusion, Done, Figure, Row, Table
from snapjump.run.studies.study import Study

from ..compositions import composed, groups_of
from .figure import draw_benchmark
from .methods import METHODS, PAPER
from .table import readme_block, solved, summary_row, unsolved

# Problems and environments of a cell, which are lost together if it is stopped.
BLOCK, REGIONS = 10, 2


class InverseBenchmark(Study):
    """Random environments with targets that a hidden random design reaches."""

    scene = "jump"
    options = ("problems", "environments", "methods", "checkpoint")
    sources = ("experiments.inverse_benchmark.compute", "experiments.inverse_benchmark.region")

    def plan(self, config: Mapping[str, Any]) -> list[Cell]:
        """Each method on each ten problems, and the regions of the environments."""
        from snapjump.targets.request import checkpoint_path, trained_forward

        task = config["task"]
        check_integer("task.problems", task["problems"], 1, 100_000)
        check_integer("task.environments", task["environments"], 0, 100_000)
        self.methods = chosen(task["methods"])
        groups = groups_of(config)
        path = checkpoint_path(task["checkpoint"])
        trained_forward(path).check_model(composed(groups))
        shared = {
            "groups": groups,
            "checkpoint": str(path),
            "checkpoint_sha256": hashlib.sha256(path.read_bytes()).hexdigest(),
            "seed": config["seed"],
        }
        cells = []
        for name, group in self.methods.items():
            inputs = {**shared, "method": name, "inverse": dict(group)}
            cells += block_cells(f"{name}: targets", inputs, task["problems"], BLOCK)
        return cells + block_cells("region: environments", shared, task["environments"], REGIONS)

    def compute(self, cell: Cell) -> list[Row]:
        from .compute import solve_block
        from .region import region_rows

        return solve_block(cell.inputs) if "method" in cell.inputs else region_rows(cell.inputs)

    def conclude(self, done: Mapping[str, Done]) -> Conclusion:
        rows: dict[str, list[Row]] = {name: [] for name in self.methods}
        regions: list[Row] = []
        for one in done.values():
            if one.status == OK:
                rows.get(str(one.cell.inputs.get("method")), regions).extend(one.rows)
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
                *region_findings(regions),
            ],
            tables={
                "methods": Table("Misses in mm at L = 20 mm", table),
                "unsolved": Table(
                    "Targets that physics missed, and the least miss of 64 designs around", missed
                ),
                "region": Table("Random targets and what was decided about them", regions),
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
                if one.status == OK and "method" in one.cell.inputs
            },
            blocks={"inverse": readme_block(table, problems)},
        )


def stretches(count: int, size: int) -> list[tuple[int, int]]:
    """Numbers 0 to count - 1 in stretches of so many: first, and the one after the last."""
    return [(first, min(first + size, count)) for first in range(0, count, size)]


def block_cells(name: str, inputs: Mapping[str, Any], count: int, size: int) -> list[Cell]:
    """Cells of so many problems or environments each."""
    return [
        Cell(f"{name} {first} to {last - 1}", {**inputs, "first": first, "last": last})
        for first, last in stretches(count, size)
    ]


def region_findings(regions: list[Row]) -> list[str]:
    """One sentence, if there are any."""
    if not regions:
        return []
    targets, accepts, rejects = (
        sum(row[key] for row in regions) for key in ("targets", "false_accepts", "false_rejects")
    )
    farthest = max(row["farthest_wrong_bar"] for row in regions)
    return [
        f"Achievable region: of {targets} random targets in {len(regions)} environments "
        f"{100 * accepts / targets:.2g} % are reached (within 0.03 L) that lie outside of a grid "
        f"of simulations, {100 * rejects / targets:.2g} % called unreachable that lie inside; all "
        f"of them within {farthest:.2g} L of its boundary."
    ]


def chosen(methods: Any) -> dict[str, Mapping[str, Any]]:
    """Groups of the methods by their names in the table, with every field; None for all."""
    names = list(METHODS) if methods is None else methods
    if not isinstance(names, list) or not names or any(name not in [*METHODS] for name in names):
        raise ParameterError("task.methods", methods, "null, or a list of " + "; ".join(METHODS))
    return {name: member_group(make_member("inverse", METHODS[name])) for name in names}
