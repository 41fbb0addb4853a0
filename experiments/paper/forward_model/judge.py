"""Verdicts on what the paper says of its dataset, its forward model and its inverse design."""

from collections.abc import Mapping

from experiments.paper.forward_model.compute import (
    DATA_DRIVEN,
    PAPER_HOURS,
    PAPER_JUMPS,
    PAPER_MAE_BAR,
    PAPER_MEAN_MM,
    PAPER_SECONDS,
    PAPER_STD_MM,
    PAPER_THREADS,
)
from experiments.paper.statement import Statement, verdict
from snapjump.run.studies.base import Row
from snapjump.tiers import TIERS

COMMAND = "task=paper figure=forward_model"
WITHIN = 2.0  # this factor of a number of the paper's, a statement holds within a limit
STANDARD = f"`standard` ({TIERS['standard'].promise_percent:g} % for 95 % of the designs)"


def dataset_statement(row: Row) -> Statement:
    """What the dataset costs."""
    paper = PAPER_HOURS * 3600.0 * PAPER_THREADS
    ours = row["kernel_core_seconds"]
    factor = paper / ours
    by_clock = ""
    if row["wall_seconds"] is not None:
        by_clock = f" ({row['wall_seconds']:.0f} s by the clock on {row['cores']} cores)"
    return Statement(
        f"A dataset of {PAPER_JUMPS:,} simulated jumps can be made in {PAPER_HOURS:g} hours on "
        f"{PAPER_THREADS} threads",
        verdict(factor >= 1.0 and row["ok"] == PAPER_JUMPS, factor >= 1.0 / WITHIN),
        f"{row['ok']:,} of {row['jumps']:,} jumps succeed, and cost {ours / 60.0:.1f} core "
        f"minutes{by_clock}: {factor:,.0f} times fewer thread seconds than the paper's. The cost "
        "is the program's, not the problem's: fewer and cheaper Newton iterations, eight robots "
        "at a time",
        STANDARD,
        COMMAND,
    )


def error_statement(row: Row) -> Statement:
    """What the paper's network learns."""
    mae = row["mae_bar"]
    return Statement(
        f"The forward model predicts the apex with a mean absolute error of {PAPER_MAE_BAR} L",
        verdict(mae <= PAPER_MAE_BAR, mae <= WITHIN * PAPER_MAE_BAR),
        f"{mae:.2g} L with a network of the paper's size on {row['rows_train']:,} jumps of the "
        f"converged model, measured on {row['rows_test']:,} others. Jumps at the paper's settings "
        "are rougher, and the same network learns them less well, if better than this number "
        "(docs/studies/compare_surrogates.md): the rest of the difference is the training's",
        STANDARD,
        COMMAND,
    )


def accuracy_statement(rows: Mapping[str, Row]) -> Statement:
    """How near designs by the forward model come."""
    row = rows[DATA_DRIVEN]
    mean, spread = row["mean_mm_standard"], row["std_mm_standard"]
    best = rows["physics"]
    return Statement(
        f"Inverse design by the forward model misses its target by {PAPER_MEAN_MM} ± "
        f"{PAPER_STD_MM} mm (L = 20 mm)",
        verdict(mean <= PAPER_MEAN_MM, mean <= WITHIN * PAPER_MEAN_MM),
        f"{mean:.2g} ± {spread:.2g} mm in the same way on {row['problems']} random targets; with "
        f"this library's forward model {rows['gauss_newton']['mean_mm_standard']:.2g} mm, and "
        f"corrected by simulation (`inverse=physics`) {best['mean_mm_standard']:.2g} mm",
        f"{STANDARD}; judged at `reference` {row['mean_mm_reference']:.2g}, "
        f"{rows['gauss_newton']['mean_mm_reference']:.2g} and "
        f"{best['mean_mm_reference']:.2g} mm",
        COMMAND,
    )


def speed_statement(rows: Mapping[str, Row]) -> Statement:
    """How much faster than search on the simulator."""
    own = rows[DATA_DRIVEN]["seconds_median"]
    searches = ("bayesian", "finite_difference")
    ours = {name: rows[name]["seconds_median"] / own for name in searches}
    paper = {name: PAPER_SECONDS[name] / PAPER_SECONDS["data-driven"] for name in searches}
    shares = [ours[name] / paper[name] for name in searches]
    return Statement(
        f"By the forward model a design takes {PAPER_SECONDS['data-driven']} s; Bayesian "
        f"optimisation on the simulator takes {paper['bayesian']:,.0f} times as long, "
        f"finite-difference descent {paper['finite_difference']:,.0f} times",
        verdict(min(shares) >= 1.0, min(shares) >= 1.0 / WITHIN),
        f"In the same way a design takes {own:.2g} s, Bayesian optimisation "
        f"{ours['bayesian']:.2g} times as long, finite differences "
        f"{ours['finite_difference']:.2g} times. The ratio is that of a slow simulator: with a "
        "fast one, simulation can have the last word. `physics`, which corrects the forward model "
        f"by {rows['physics']['simulations_mean']:.0f} simulations in the mean, takes "
        f"{rows['physics']['seconds_median']:.2g} s, and the forward model alone by Gauss-Newton "
        f"{rows['gauss_newton']['seconds_median']:.2g} s",
        f"{STANDARD}; times of one core, medians of {rows['bayesian']['problems']} targets "
        "(searches on the simulator) and "
        f"{rows[DATA_DRIVEN]['problems']}",
        COMMAND,
    )
