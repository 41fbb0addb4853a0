"""What is said of the dataset, the forward model, inverse design, and what they take."""

from collections.abc import Mapping

from experiments.inverse_benchmark.methods import PAPER
from experiments.paper.statement import paragraphs, prose
from snapjump.run.studies.base import Row
from snapjump.tiers import TIERS

TITLE = "Dataset, forward model, inverse design"
# The paper: its dataset, on an i9-12900H, which has 20 threads; its forward model.
PAPER_JUMPS, PAPER_HOURS, PAPER_THREADS = 50_625, 4.0, 20
PAPER_MAE_BAR = 0.07
(OWN, BAYESIAN, DIFFERENCES) = PAPER
PAPER_MEAN_MM, PAPER_SECONDS = OWN["mean_mm"], OWN["seconds"]
PAPER_RATIOS = {
    name: float(str(row["seconds"])) / float(str(PAPER_SECONDS))
    for name, row in (("bayesian", BAYESIAN), ("finite_difference", DIFFERENCES))
}
PLANNED_S = 0.5
PACED = ("paper", "standard")
REAL_TIME = "The simulation runs in real time"
MADE = (
    f"A dataset of {PAPER_JUMPS:,} simulated jumps can be made in {PAPER_HOURS:g} hours on "
    f"{PAPER_THREADS} threads"
)
PREDICTS = f"The forward model predicts the apex with a mean absolute error of {PAPER_MAE_BAR} L"
MISSES = (
    f"Inverse design by the forward model misses its target by {PAPER_MEAN_MM} ± "
    f"{OWN['std_mm']} mm (L = 20 mm)"
)
TAKES = f"A design by the forward model takes {PAPER_SECONDS} s in the mean"
PLANS = f"A jump is planned with an error of millimetres in less than {PLANNED_S:g} s"
FASTER = (
    f"Bayesian optimisation on the simulator takes {PAPER_RATIOS['bayesian']:,.0f} times as long "
    f"as a design by the forward model, finite-difference descent "
    f"{PAPER_RATIOS['finite_difference']:,.0f} times (a table that the text of arXiv 2408.10470 "
    "does not have)"
)
STANDARD = f"`standard` ({TIERS['standard'].promise_percent:g} % for 95 % of the designs)"
FIGURE = (
    "How far predicted apexes are off, of jumps that the network has not seen; and the "
    "simulated misses of designs (number of targets in brackets)"
)
METHODS = "Misses of random reachable targets, in mm at L = 20 mm"
PACE = "Jumps one at a time on one core: how long they last, and how long they take to compute"
PACE_ACCURACY = "the paper's settings and `standard`; times of one core of this machine"
PARAGRAPHS = paragraphs("""The paper's grid of 15 values of each of the four inputs, its network of
    three layers of 372 neurons, and its search by Adam from the best point of a grid, beside the
    library's own methods. Each target is the apex of a hidden random design in a random
    environment, so that it can be reached.

    More methods, more targets and the time of each: `python run.py task=inverse_benchmark`; more
    forward models: `python run.py task=compare_surrogates`.""")


def real_time(rows: Mapping[str, Row]) -> str:
    """Times of jumps by tier."""
    told = "; ".join(
        f"{words} {row['computed_median_s']:.2g} s in the median and {row['computed_most_s']:.2g} "
        f"s at most, which is at most {100.0 * row['most_of_time_to_apex']:.2g} % of the time to "
        f"the apex and {100.0 * row['most_of_time_to_liftoff']:.2g} % of that to lift-off"
        for words, row in (
            ("at the paper's settings", rows["paper"]),
            ("at `standard`", rows["standard"]),
        )
    )
    own = rows["paper"]
    theirs = PAPER_HOURS * 3600.0 * PAPER_THREADS / PAPER_JUMPS
    return prose(f"""Of {own["jumps"]} designs over the paper's ranges a jump lasts
        {own["apex_median_s"]:.2g} s to its apex in the median, {own["liftoff_median_s"]:.2g} s to
        lift-off, after which it is a parabola. One core computes it, alone, {told}. The paper's
        own dataset took {theirs:.1f} s of a thread a jump: its program is in real time with all
        threads together, one jump with another, and not for one jump""")


def dataset(row: Row, factor: float) -> str:
    """What the jumps cost."""
    by_clock = ""
    if row["wall_seconds"] is not None:
        by_clock = f" ({row['wall_seconds']:.0f} s by the clock on {row['cores']} cores)"
    return prose(f"""{row["ok"]:,} of {row["jumps"]:,} jumps succeed, and cost
        {row["kernel_core_seconds"] / 60.0:.1f} core minutes{by_clock}: {factor:,.0f} times fewer
        thread seconds than the paper's. The cost is the program's, not the problem's: fewer and
        cheaper Newton iterations, eight robots at a time""")


def error(row: Row) -> str:
    """What the network has learned, and what it would of rougher jumps."""
    return prose(f"""{row["mae_bar"]:.2g} L with a network of the paper's size on
        {row["rows_train"]:,} jumps of the converged model, measured on {row["rows_test"]:,}
        others. Jumps at the paper's settings are rougher, and the same network learns them less
        well, if better than this number (docs/studies/compare_surrogates.md): the rest of the
        difference is the training's""")


def accuracy(rows: Mapping[str, Row], own: Row) -> str:
    """Misses of the paper's way, and of others."""
    learned, best = (rows[name]["mean_mm_standard"] for name in ("gauss_newton", "physics"))
    return prose(f"""{own["mean_mm_standard"]:.2g} ± {own["std_mm_standard"]:.2g} mm in the same way
        on {own["problems"]} random targets; with this library's forward model {learned:.2g} mm,
        and corrected by simulation (`inverse=physics`) {best:.2g} mm""")


def judged_at(rows: Mapping[str, Row], own: Row) -> str:
    """The misses at reference."""
    learned, best = (rows[name]["mean_mm_reference"] for name in ("gauss_newton", "physics"))
    return prose(f"""{STANDARD}; judged at `reference` {own["mean_mm_reference"]:.2g},
        {learned:.2g} and {best:.2g} mm""")


def times(rows: Mapping[str, Row], own: Row) -> str:
    """How times were taken."""
    return prose(f"""{STANDARD}; times of one core, of {rows["bayesian"]["problems"]} targets
        (searches on the simulator) and {own["problems"]}""")


def time(rows: Mapping[str, Row], own: Row) -> str:
    """Of designs without simulation, and of those that simulation corrects."""
    physics = rows["physics"]
    return prose(f"""In the same way a design takes {own["seconds_mean"]:.2g} s in the mean and
        {own["seconds_median"]:.2g} s in the median. `physics`, which corrects the forward model by
        {physics["simulations_mean"]:.0f} simulations in the mean, takes
        {physics["seconds_median"]:.2g} s, and the forward model alone by Gauss-Newton
        {rows["gauss_newton"]["seconds_median"]:.2g} s""")


def plan(own: Row) -> str:
    """Time and miss together."""
    return prose(f"""{own["seconds_mean"]:.2g} s in the mean, at most {own["seconds_max"]:.2g} s,
        and {own["mean_mm_standard"]:.2g} mm in the mean, at most {own["max_mm_standard"]:.2g} mm,
        by the paper's network and search on one core""")


def speed(rows: Mapping[str, Row], own: Row, ratios: Mapping[str, float]) -> str:
    """Ratios of medians."""
    return prose(f"""A design takes {own["seconds_median"]:.2g} s in the median, Bayesian
        optimisation {ratios["bayesian"]:.2g} times as long, finite differences
        {ratios["finite_difference"]:.2g} times. The ratio is that of a slow simulator: with a fast
        one, simulation can have the last word""")
