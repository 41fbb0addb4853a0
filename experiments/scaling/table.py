"""The figures as a page of Markdown."""

import platform
from typing import Any

from snapjump.run.studies.base import Table
from snapjump.run.studies.report import markdown

PARTS = {
    "assembly": "assembly",
    "contact": "contact and friction",
    "solve": "solution of the linear system",
    "correction": "correction and its gap filter",
    "stages": "stages and steps: begin, end, judge",
    "pass": "a pass in all",
}
NODES = "cycles a node"


def split_rows(figures: dict[str, Any]) -> list[dict[str, Any]]:
    """A row a part: microseconds of a lane and pass at both widths, their ratio, and cycles that a
    node of all lanes takes."""
    parts = figures["us_of_a_lane_and_pass"]
    scalar, lanes = parts.values()
    of_one, of_many = figures["cycles_of_a_node"].values()
    one, many = (f"us, {width} lanes" for width in parts)
    return [
        {
            "part": name,
            one: scalar[key],
            many: lanes[key],
            "ratio": round(scalar[key] / lanes[key], 2) if lanes[key] > 0.0 else float("nan"),
            "share_percent": round(100.0 * lanes[key] / lanes["pass"], 1),
            f"{NODES}, {one[4:]}": of_one[key],
            f"{NODES}, {many[4:]}": of_many[key],
        }
        for key, name in PARTS.items()
    ]


def page(figures: dict[str, Any]) -> str:
    """The page."""
    widest = list(figures["us_of_a_lane_and_pass"])[-1]
    lines = [
        "# Lanes and threads",
        "`python -m experiments.scaling --table docs/studies/scaling.md`",
        f"{platform.processor() or platform.machine()}, `{figures['tier']}`, "
        f"{figures['designs']} designs spread over the paper's ranges, medians of "
        f"{figures['repeats']} runs that took turns.",
        f"- {widest} lanes over 1, in time of a Newton iteration: "
        f"{figures['lanes_over_scalar']:.2f} times (target 4).",
        f"- {figures['threads']} threads over 1, in jumps per second: "
        f"{figures['threads_over_one']:.2f} times (target 1.9); "
        f"{figures['threads_over_one_undisturbed']:.2f} by the time of the cores alone.",
        f"- {figures['jumps_per_second_core']:.1f} jumps per second and core: "
        f"{figures['released_over_ours']:.0f} times the released program's, at 26 s a jump.",
        markdown(Table("Throughput", figures["throughput"])),
        "A pass is a Newton iteration of all lanes; times are of one lane, that is of one robot. "
        "Lanes without a robot are in the throughput's idle share, not in these.",
        markdown(Table("Where a pass goes", split_rows(figures))),
    ]
    return "\n\n".join(lines) + "\n"
