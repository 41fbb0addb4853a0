"""The dataset, the forward model and inverse design, as the paper makes them and as we do; and how
long a jump takes to simulate."""

import re
from collections.abc import Mapping
from dataclasses import asdict
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

from snapjump.declare.members import make_member, member_class, member_group
from snapjump.learning.training import Training
from snapjump.run.studies.base import Cell, Done, Row
from snapjump.tiers import TIERS

from ...compositions import groups_at
from ...designs import spread_designs
from ...inverse_benchmark.methods import PAPER
from ...inverse_benchmark.study import stretches
from ...inverse_benchmark.table import summary_row
from ...pace import pace_row, pace_rows
from ...surrogates.from_nothing import dataset_rows, forward_rows, trained
from ..base import Found, Part, Statement, weakest
from ..cells import shipped_inputs
from ..limits import judged
from ..words import Words
from .figure import draw_forward_model

WORDS = Words(__file__)
# The paper: its dataset, on an i9-12900H, which has 20 threads; how much slower its searches
# on the simulator are.
PAPER_JUMPS, PAPER_HOURS, PAPER_THREADS = 50_625, 4.0, 20
PAPER_RATIOS = {
    name: float(str(row["seconds"])) / float(str(PAPER[0]["seconds"]))
    for name, row in zip(("bayesian", "finite_difference"), PAPER[1:], strict=True)
}
THEIRS = {
    "jumps": PAPER_JUMPS,
    "hours": PAPER_HOURS,
    "threads": PAPER_THREADS,
    "theirs": PAPER[0],
    "their_ratios": PAPER_RATIOS,
    "standard": WORDS("standard", promise_percent=TIERS["standard"].promise_percent),
}
PACED_AT = ("paper", "standard")


class Method(NamedTuple):
    """``inverse``: its group; ``network``: the forward model it asks, None for the one that comes
    with the library; ``problems``: how many random targets it is given (the first of them)."""

    inverse: dict[str, Any]
    network: str | None
    problems: int


NETWORK = "mlp"  # the paper's: 3 x 372 neurons with ReLU
DATA_DRIVEN = "adam, the paper's network"
SEARCHES = ("bayesian", "finite_difference")  # on the simulator
METHODS = {
    DATA_DRIVEN: Method({"name": "adam"}, NETWORK, 100),
    "gauss_newton": Method({"name": "gauss_newton"}, None, 100),
    "physics": Method({"name": "physics"}, None, 100),
    **{name: Method({"name": name}, None, 6) for name in SEARCHES},
}
PLAN = {"name": "grid"}  # with its defaults the paper's: 15 values of each of the four inputs
SHARD_SIZE = 4096
BLOCK = 10  # problems of a cell, which are lost together if it is stopped
PACED = 16  # designs that are timed
DATASET, TRAINED, PACE = "dataset", "forward model", "pace"
SHOWN = ("method", "problems", "mean_mm_standard", "std_mm_standard", "p95_mm_standard",
         "max_mm_standard", "mean_mm_reference", "seconds_median", "simulations_mean")  # fmt: skip


def inverse_rows(inputs: Mapping[str, Any]) -> list[Row]:
    """A row for each target (:func:`experiments.inverse_benchmark.compute.solve_block`), by the
    forward model that comes with the library or by the one trained here."""
    from snapjump.targets.request import checkpoint_path

    from ...inverse_benchmark.compute import solve_block

    shipped = inputs["surrogate"] is None
    file = checkpoint_path(None) if shipped else Path(trained(inputs)[0].file)
    return solve_block({**inputs, "checkpoint": str(file)})


class ForwardModels(Part):
    """From nothing: 50,625 jumps, the paper's network on them, and designs for random targets."""

    name = "forward_model"
    title = "Dataset, forward model, inverse design"
    kinds = {DATASET: dataset_rows, TRAINED: forward_rows, "inverse": inverse_rows, PACE: pace_rows}

    def plan(self, groups: Mapping[str, Any], seed: int) -> list[Cell]:
        """The dataset, the network, each method on its targets, ten at a time, and the pace."""
        plan = {**PLAN, **asdict(member_class("plan", PLAN["name"])())}
        data = {"groups": groups, "plan": plan, "shard_size": SHARD_SIZE, "seed": seed}
        surrogate = member_group(member_class("surrogate", NETWORK)())
        learned = {**data, "training": asdict(Training()), "surrogate": surrogate}
        cells = [
            Cell(DATASET, {**data, "kind": DATASET}),
            Cell(TRAINED, {**learned, "kind": TRAINED}),
        ]
        for name, method in METHODS.items():
            shipped = {} if method.network else {"surrogate": None, **shipped_inputs(groups)}
            inverse = member_group(make_member("inverse", method.inverse))
            asked = {**learned, **shipped, "kind": "inverse", "method": name, "inverse": inverse}
            cells += [
                Cell(
                    f"{name}: targets {first} to {last - 1}",
                    {**asked, "first": first, "last": last},
                )
                for first, last in stretches(method.problems, BLOCK)
            ]
        designs = spread_designs(PACED, seed)
        return cells + [
            Cell(f"{PACE}, {tier}", {"kind": PACE, "groups": at, "designs": designs})
            for tier, at in ((tier, groups_at(groups, tier)) for tier in PACED_AT)
        ]

    def judge(self, done: Mapping[str, Done]) -> Found:
        """Seven statements."""
        methods: dict[str, list[Row]] = {name: [] for name in METHODS}
        for one in done.values():
            if "method" in one.cell.inputs:
                methods[one.cell.inputs["method"]] += one.rows
        made, (learned, *predictions) = done[DATASET].rows, done[TRAINED].rows
        pace = {tier: done[f"{PACE}, {tier}"].rows for tier in PACED_AT}
        found = {name: summary_row(name, rows) for name, rows in methods.items()}
        measures = {key: value for key, value in learned.items() if key != "kind"}
        figures = {"forward_model": partial(draw_forward_model, predictions, methods)}
        tables = {
            "dataset_cost": made,
            "network": [measures],
            "inverse_methods": [{key: row[key] for key in SHOWN} for row in found.values()],
            "pace": [{"tier": tier, **pace_row(rows)} for tier, rows in pace.items()],
        }
        return Found(
            WORDS.section(self.title, figures, tables),
            [
                real_time_statement(pace),
                dataset_statement(made[0]),
                error_statement(learned),
                *inverse_statements(found),
            ],
            {
                **{f"dataset_{key}": value for key, value in made[0].items()},
                **{f"network_{key}": value for key, value in measures.items()},
                **{f"mean_mm_{snake_case(k)}": r["mean_mm_standard"] for k, r in found.items()},
            },
        )


def snake_case(name: str) -> str:
    """A method's name as a key."""
    return re.sub(r"\W+", "_", name)


def real_time_statement(pace: Mapping[str, list[Row]]) -> Statement:
    """Whether a jump is computed in less time than it takes, at the paper's settings."""
    rows = {tier: pace_row(found) for tier, found in pace.items()}
    came = weakest(
        judged("forward_model.real_time", rows["paper"]["most_of_time_to_apex"]),
        judged("forward_model.real_time.liftoff", rows["paper"]["most_of_time_to_liftoff"]),
    )
    times = {
        f"{tier}_times": WORDS(
            "real_time: times",
            **row,
            apex_percent=100.0 * row["most_of_time_to_apex"],
            liftoff_percent=100.0 * row["most_of_time_to_liftoff"],
        )
        for tier, row in rows.items()
    }
    clock_s = PAPER_HOURS * 3600.0 / PAPER_JUMPS
    return WORDS.statement(
        "real_time",
        came,
        **THEIRS,
        **times,
        paper=rows["paper"],
        clock_s=clock_s,
        thread_s=clock_s * PAPER_THREADS,
    )


def dataset_statement(row: Row) -> Statement:
    """What the dataset costs."""
    share = row["kernel_core_seconds"] / (PAPER_HOURS * 3600.0 * PAPER_THREADS)
    came = weakest(
        judged("forward_model.dataset.time", share),
        judged("forward_model.dataset.jumps", row["ok"]),
    )
    timed = row["wall_seconds"] is not None
    return WORDS.statement(
        "dataset",
        came,
        **THEIRS,
        row=row,
        minutes=row["kernel_core_seconds"] / 60.0,
        by_clock=f" {WORDS('dataset: by the clock', **row)}" if timed else "",
        factor=1.0 / share,
    )


def error_statement(row: Row) -> Statement:
    """What the paper's network learns."""
    came = judged("forward_model.error", row["mae_bar"])
    return WORDS.statement("error", came, **THEIRS, row=row)


def inverse_statements(rows: Mapping[str, Row]) -> list[Statement]:
    """How near designs by the forward model come, in which time, and how much faster than search
    on the simulator."""
    own = rows[DATA_DRIVEN]
    mean_mm, seconds = own["mean_mm_standard"], own["seconds_mean"]
    ratios = {name: rows[name]["seconds_median"] / own["seconds_median"] for name in SEARCHES}
    shares = [ratio / PAPER_RATIOS[name] for name, ratio in ratios.items()]
    plan = judged("forward_model.plan.time", seconds), judged("forward_model.plan.miss", mean_mm)
    came = {
        "accuracy": judged("forward_model.accuracy", mean_mm),
        "time": judged("forward_model.time", seconds),
        "plan": weakest(*plan),
        "speed": judged("forward_model.speed", *shares),
    }
    timed = WORDS("timed", **THEIRS, rows=rows, own=own)
    values = {**THEIRS, "rows": rows, "own": own, "ratios": ratios, "timed": timed}
    return [WORDS.statement(key, verdict, **values) for key, verdict in came.items()]
