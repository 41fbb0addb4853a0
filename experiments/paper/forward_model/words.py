"""What is said of the dataset, the forward model, inverse design, and what they take."""

from collections.abc import Mapping

from experiments.inverse_benchmark.methods import PAPER
from experiments.paper.base import Said, paragraphs
from snapjump.run.studies.base import Row
from snapjump.tiers import TIERS

TITLE = "Dataset, forward model, inverse design"
# The paper: its dataset, on an i9-12900H, which has 20 threads; its forward model.
PAPER_JUMPS, PAPER_HOURS, PAPER_THREADS = 50_625, 4.0, 20
PAPER_MAE_BAR = 0.07
OWN = PAPER[0]
PAPER_RATIOS = {
    name: float(str(row["seconds"])) / float(str(OWN["seconds"]))
    for name, row in zip(("bayesian", "finite_difference"), PAPER[1:], strict=True)
}
PACED = ("paper", "standard")
STANDARD = f"`standard` ({TIERS['standard'].promise_percent:g} % for 95 % of the designs)"
FIGURE = (
    "How far predicted apexes are off, of jumps that the network has not seen; and the "
    "simulated misses of designs (number of targets in brackets)"
)
METHODS = "Misses of random reachable targets, in mm at L = 20 mm"
PACE = "Jumps one at a time on one core: how long they last, and how long they take to compute"
PARAGRAPHS = paragraphs("""The paper's grid of 15 values of each of the four inputs, its network of
    three layers of 372 neurons, and its search by Adam from the best point of a grid, beside the
    library's own methods. Each target is the apex of a hidden random design in a random
    environment, so that it can be reached.

    More methods, more targets and the time of each: `python run.py task=inverse_benchmark`; more
    forward models: `python run.py task=compare_surrogates`.""")


def real_time(rows: Mapping[str, Row]) -> Said:
    """Times of jumps by tier."""
    own = rows["paper"]
    told = "; ".join(
        f"{words} {row['computed_median_s']:.2g} s in the median and {row['computed_most_s']:.2g} "
        f"s at most, which is at most {100.0 * row['most_of_time_to_apex']:.2g} % of the time to "
        f"the apex and {100.0 * row['most_of_time_to_liftoff']:.2g} % of that to lift-off"
        for words, row in (("at the paper's settings", own), ("at `standard`", rows["standard"]))
    )
    clock = PAPER_HOURS * 3600.0 / PAPER_JUMPS
    return Said(
        "The simulation runs in real time",
        f"""Of {own["jumps"]} designs over the paper's ranges a jump lasts
        {own["apex_median_s"]:.2g} s to its apex in the median, {own["liftoff_median_s"]:.2g} s to
        lift-off, after which it is a parabola. One core computes it, alone, {told}. The paper's
        own dataset took {clock:.2g} s a jump by the clock, on {PAPER_THREADS} threads, which is
        {clock * PAPER_THREADS:.2g} s of a thread: its own program was not in real time with one
        jump""",
        "the paper's settings and `standard`; times of one core of this machine",
    )


def dataset(row: Row, factor: float) -> Said:
    """What the jumps cost."""
    by_clock = ""
    if row["wall_seconds"] is not None:
        by_clock = f" ({row['wall_seconds']:.0f} s by the clock on {row['cores']} cores)"
    return Said(
        f"""A dataset of {PAPER_JUMPS:,} simulated jumps can be made in {PAPER_HOURS:g} hours on
        {PAPER_THREADS} threads""",
        f"""{row["ok"]:,} of {row["jumps"]:,} jumps succeed, and cost
        {row["kernel_core_seconds"] / 60.0:.1f} core minutes{by_clock}: {factor:,.0f} times fewer
        thread seconds than the paper's. The cost is the program's, not the problem's: fewer and
        cheaper Newton iterations, eight robots at a time""",
        STANDARD,
    )


def error(row: Row) -> Said:
    """What the network has learned, and what it would of rougher jumps."""
    return Said(
        f"The forward model predicts the apex with a mean absolute error of {PAPER_MAE_BAR} L",
        f"""{row["mae_bar"]:.2g} L with a network of the paper's size on {row["rows_train"]:,}
        jumps of the converged model, measured on {row["rows_test"]:,} others. Jumps at the paper's
        settings are rougher, and the same network learns them less well, if better than this
        number (docs/studies/compare_surrogates.md): the rest of the difference is the
        training's""",
        STANDARD,
    )


def inverse(rows: Mapping[str, Row], own: Row, ratios: Mapping[str, float]) -> dict[str, Said]:
    """Misses and times of designs in the paper's way, and of others, by their keys; ratios: of
    the medians of searches on the simulator to that of ``own``."""
    learned, best = rows["gauss_newton"], rows["physics"]
    means = [f"{row['mean_mm_reference']:.2g}" for row in (own, learned, best)]
    timed = f"""{STANDARD}; times of one core, of {rows["bayesian"]["problems"]} targets (searches
        on the simulator) and {own["problems"]}"""
    return {
        "accuracy": Said(
            f"""Inverse design by the forward model misses its target by {OWN["mean_mm"]} ±
            {OWN["std_mm"]} mm (L = 20 mm)""",
            f"""{own["mean_mm_standard"]:.2g} ± {own["std_mm_standard"]:.2g} mm in the same way on
            {own["problems"]} random targets; with this library's forward model
            {learned["mean_mm_standard"]:.2g} mm, and corrected by simulation (`inverse=physics`)
            {best["mean_mm_standard"]:.2g} mm""",
            f"{STANDARD}; judged at `reference` {means[0]}, {means[1]} and {means[2]} mm",
        ),
        "time": Said(
            f"A design by the forward model takes {OWN['seconds']} s in the mean",
            f"""In the same way a design takes {own["seconds_mean"]:.2g} s in the mean and
            {own["seconds_median"]:.2g} s in the median. `physics`, which corrects the forward
            model by {best["simulations_mean"]:.0f} simulations in the mean, takes
            {best["seconds_median"]:.2g} s, and the forward model alone by Gauss-Newton
            {learned["seconds_median"]:.2g} s""",
            timed,
        ),
        "plan": Said(
            "A jump is planned with an error of millimetres in less than 0.5 s",
            f"""{own["seconds_mean"]:.2g} s in the mean, at most {own["seconds_max"]:.2g} s, and
            {own["mean_mm_standard"]:.2g} mm in the mean, at most {own["max_mm_standard"]:.2g} mm,
            by the paper's network and search on one core""",
            timed,
        ),
        "speed": Said(
            f"""Bayesian optimisation on the simulator takes {PAPER_RATIOS["bayesian"]:,.0f} times
            as long as a design by the forward model, finite-difference descent
            {PAPER_RATIOS["finite_difference"]:,.0f} times (a table that the text of arXiv
            2408.10470 does not have)""",
            f"""A design takes {own["seconds_median"]:.2g} s in the median, Bayesian optimisation
            {ratios["bayesian"]:.2g} times as long, finite differences
            {ratios["finite_difference"]:.2g} times. The ratio is that of a slow simulator: with a
            fast one, simulation can have the last word""",
            timed,
        ),
    }
