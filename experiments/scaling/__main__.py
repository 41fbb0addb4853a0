"""Lanes, threads and where the time goes: ``python -m experiments.scaling`` prints one JSON object.

With ``--table docs/studies/scaling.md`` it writes the table too. Settings take turns and medians
are taken, so that ratios hold on a machine that does other things as well.
"""

import sys
from dataclasses import asdict
from pathlib import Path
from typing import Any

from snapjump.batch import variants
from snapjump.checks import check_integer
from snapjump.composition import with_tier
from snapjump.files.atomic import write_text
from snapjump.files.cores import own_cores
from snapjump.scenes.jump_start import jump_model
from snapjump.statics.threshold_curve import ThresholdCurve

from ..command import measured
from ..designs import HIGH, LOW, spread_designs
from ..grid import RELEASED_SECONDS
from .clock_rate import cycles_per_microsecond
from .floors import roofline
from .measure import measure
from .split import split
from .table import page

WIDTHS = (1, 4, 8, 16)
WIDTH = 8


def report(
    tier: str = "standard",
    designs: int = 256,
    repeats: int = 5,
    threads: int = len(own_cores()),
    table: str = "",
) -> dict[str, Any]:
    """All figures; ``table``: a Markdown file to write as well."""
    for name, number in (("designs", designs), ("repeats", repeats), ("threads", threads)):
        check_integer(f"--{name}", number, 1, 100_000)
    base = with_tier(tier)
    curve = ThresholdCurve.through(base.robot, base.discretization, LOW[1], HIGH[1])
    settings = [(width, 1) for width in WIDTHS] + [(WIDTH, threads)]
    print("measuring throughput ...", file=sys.stderr)
    found = measure(base, curve, settings, designs, repeats)
    one, lanes, crew = found[1, 1], found[WIDTH, 1], found[WIDTH, threads]
    simulations = variants(base, spread_designs(64))
    models = [jump_model(simulation) for simulation in simulations]
    parts, rates, roofs = {}, {}, {}
    for width in (1, WIDTH):
        print(f"splitting the time at width {width} ...", file=sys.stderr)
        parts[str(width)] = split(simulations, models, width)
        rates[str(width)] = cycles_per_microsecond()
        print(f"counting operations at width {width} ...", file=sys.stderr)
        roofs[str(width)] = roofline(simulations, models, width)
    figures = {
        "tier": tier,
        "designs": designs,
        "repeats": repeats,
        "threads": threads,
        "throughput": [
            {"lanes": width, "threads": crew_size, **asdict(values)}
            for (width, crew_size), values in found.items()
        ],
        "lanes_over_scalar": one.us_per_iteration / lanes.us_per_iteration,
        "threads_over_one": crew.jumps_per_second / lanes.jumps_per_second,
        # The same for cores that nothing else uses: by core time and passes, not by the clock.
        "threads_over_one_undisturbed": threads * lanes.us_per_pass / crew.us_per_pass,
        "jumps_per_second_core": crew.jumps_per_second_core,
        "released_over_ours": RELEASED_SECONDS * crew.jumps_per_second_core,
        "us_of_a_lane_and_pass": parts,
        "cycles_of_a_node": cycles(parts, len(base.discretization.masses()), rates),
        "cycles_a_microsecond": rates,
        "rooflines": roofs,
    }
    if table:
        write_text(Path(table), page(figures))
    return figures


def cycles(
    parts: dict[str, dict[str, float]], nodes: int, rates: dict[str, float]
) -> dict[str, dict[str, int]]:
    """Cycles of a core for a node of all lanes together, by width and part of a pass; ``rates``:
    cycles a microsecond."""
    return {
        width: {part: round(rates[width] * us * int(width) / nodes) for part, us in row.items()}
        for width, row in parts.items()
    }


if __name__ == "__main__":
    measured(report)
