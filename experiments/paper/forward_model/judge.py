"""Verdicts on what the paper says of its dataset, its forward model and its inverse design."""

from collections.abc import Mapping

from experiments.paper.forward_model.methods import (
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
from snapjump.studies.base import Row

COMMAND = "task=paper figure=forward_model"
WITHIN = 2.0  # this factor of a number of the paper's, a statement holds within a limit
STANDARD = "`standard` (0.5 %)"


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
        f"converged model, measured on {row['rows_test']:,} others: the error of the paper's time "
        "step is noise that no network can learn (the same network on jumps at the paper's "
        "settings: docs/studies/compare_surrogates.md)",
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
    factors = {
        name: rows[name]["seconds_median"] / own for name in ("bayesian", "finite_difference")
    }
    paper = {name: PAPER_SECONDS[name] / PAPER_SECONDS["data-driven"] for name in factors}
    told = {name: f"{factors[name]:.2g} (paper: {paper[name]:,.0f})" for name in factors}
    held = all(factors[name] >= paper[name] / WITHIN for name in factors)
    return Statement(
        f"A design takes {PAPER_SECONDS['data-driven']} s by the forward model, "
        f"{PAPER_SECONDS['bayesian']:.0f} s by Bayesian optimisation and "
        f"{PAPER_SECONDS['finite_difference']:.0f} s by finite-difference descent on the simulator",
        verdict(held, min(factors.values()) > 1.0),
        f"{own:.2g} s in the same way; Bayesian optimisation takes {told['bayesian']} times as "
        f"long, finite differences {told['finite_difference']}: with a fast simulator the "
        "advantage is small, and simulation itself can have the last word: `physics` takes "
        f"{rows['physics']['seconds_median']:.2g} s, the forward model alone by Gauss-Newton "
        f"{rows['gauss_newton']['seconds_median']:.2g} s",
        f"{STANDARD}; times of one core, medians of {rows['bayesian']['problems']} targets "
        "(searches on the simulator) and "
        f"{rows[DATA_DRIVEN]['problems']}",
        COMMAND,
    )
