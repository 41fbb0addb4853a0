"""Lanes, threads and where the time goes: ``python -m experiments.scaling`` prints one JSON object.

With ``--table docs/studies/scaling.md`` it writes the table too. Settings take turns and medians
are taken, so that ratios hold on a machine that does other things as well.
"""

import argparse
import json
import sys
from dataclasses import asdict
from pathlib import Path
from typing import Any

from experiments.designs import HIGH, LOW, spread_designs
from experiments.scaling.measure import measure
from experiments.scaling.split import split
from experiments.scaling.table import table
from snapjump.backend.lanes import available_cores
from snapjump.batch import variants
from snapjump.checks import check_integer
from snapjump.composition import with_tier
from snapjump.files.atomic import write_text
from snapjump.scenes.jump_start import jump_model
from snapjump.statics.threshold_curve import ThresholdCurve

RELEASED_SECONDS = 26.0  # the released program's CPU time of a jump, at its least
WIDTHS = (1, 4, 8, 16)
WIDTH = 8


def report(tier: str, count: int, repeats: int, threads: int) -> dict[str, Any]:
    """All figures."""
    base = with_tier(tier)
    curve = ThresholdCurve.through(base.robot, base.discretization, LOW[1], HIGH[1])
    settings = [(width, 1) for width in WIDTHS] + [(WIDTH, threads)]
    print("measuring throughput ...", file=sys.stderr)
    found = measure(base, curve, settings, count, repeats)
    one, lanes, crew = found[1, 1], found[WIDTH, 1], found[WIDTH, threads]
    simulations = variants(base, spread_designs(64))
    models = [jump_model(simulation) for simulation in simulations]
    parts = {}
    for width in (1, WIDTH):
        print(f"splitting the time at width {width} ...", file=sys.stderr)
        parts[width] = split(simulations, models, width)
    per_core = crew.jumps_per_second_core
    return {
        "tier": tier,
        "designs": count,
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
        "jumps_per_second_core": per_core,
        "released_over_ours": RELEASED_SECONDS * per_core,
        "us_of_a_lane_and_pass": {str(width): values for width, values in parts.items()},
    }


def main() -> None:
    """Measure, print, and write the table if asked to."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--tier", default="standard", choices=("draft", "standard", "reference"))
    parser.add_argument("--designs", type=int, default=256)
    parser.add_argument("--repeats", type=int, default=5)
    parser.add_argument("--threads", type=int, default=available_cores())
    parser.add_argument("--table", type=Path, help="a Markdown file to write")
    arguments = parser.parse_args()
    for name in ("designs", "repeats", "threads"):
        check_integer(f"--{name}", getattr(arguments, name), 1, 100_000)
    figures = report(arguments.tier, arguments.designs, arguments.repeats, arguments.threads)
    if arguments.table is not None:
        write_text(arguments.table, table(figures))
    print(json.dumps(figures, indent=2))


if __name__ == "__main__":
    main()
