"""Tables and sentences of the comparison, and README's block."""

import numpy as np

from snapjump.run.studies.base import Done, Row
from snapjump.show.terminal.block import markdown_table

COLUMNS = ("jumps", "mae_bar", "mae_x_bar", "mae_y_bar", "p95_bar", "coverage", "coverage_x",
           "coverage_y", "parameters", "epochs", "train_seconds", "inference_us", "own_mae_bar",
           "own_mae_x_bar", "own_mae_y_bar")  # fmt: skip


def summary(name: str, done: Done) -> Row:
    """One line of the table."""
    return {"surrogate": name, **{key: done.rows[0].get(key) for key in COLUMNS}}


def floor_summary(tier: str, done: Done) -> Row:
    """Mean, median and 95th percentile of the floor over the cells that are known."""
    x, y = (column[np.isfinite(column)] for column in map(done.column, ("x_bar", "y_bar")))
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
    header = ["trained on", "error (L)", "of x, y", "on its own test set", "training (s)",
              "a design (us)"]  # fmt: skip
    lines = [
        [
            f"`{row['surrogate'].split(',')[0]}`,{row['surrogate'].partition(',')[2]}",
            f"{row['mae_bar']:.2g}",
            f"{row['mae_x_bar']:.2g}, {row['mae_y_bar']:.2g}",
            f"{row['own_mae_bar']:.2g}",
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
    told = []
    for row in table:
        held = ""
        if row["coverage"]:
            x, y = (f"{100 * row[f'coverage_{name}']:.3g} % of {name}" for name in ("x", "y"))
            held = f", 90 % intervals hold {x} and {y}"
        told.append(
            f"{row['surrogate']}: MAE {row['mae_bar']:.3g} L{held}; {row['train_seconds']:.3g} s "
            f"of training, {row['inference_us']:.3g} us a design."
        )
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
