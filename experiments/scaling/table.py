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
KINDS = {
    "sums": "sum, difference",
    "products": "product",
    "fused": "fused product and sum",
    "turns": "sums and products in turns",
    "quotients": "quotient",
    "roots": "square root",
    "lines_read": "line of 64 bytes, read",
    "lines_written": "line of 64 bytes, read or not, and written back",
}


def split_rows(figures: dict[str, Any]) -> list[dict[str, Any]]:
    """A row a part: microseconds of a lane and pass at both widths, their ratio, cycles that a
    node of all lanes takes, and its floor."""
    parts = figures["us_of_a_lane_and_pass"]
    scalar, lanes = parts.values()
    of_one, of_many = figures["cycles_of_a_node"].values()
    least_one, least_many = (roof["floors"] for roof in figures["rooflines"].values())
    one, many = (f"us, {width} lanes" for width in parts)
    return [
        {
            "part": name,
            one: scalar[key],
            many: lanes[key],
            "ratio": round(scalar[key] / lanes[key], 2) if lanes[key] > 0.0 else float("nan"),
            "share_percent": round(100.0 * lanes[key] / lanes["pass"], 1),
            f"{NODES}, {one[4:]}": of_one[key],
            f"floor, {one[4:]}": round(least_one[key]["floor"]),
            f"{NODES}, {many[4:]}": of_many[key],
            f"floor, {many[4:]}": round(least_many[key]["floor"]),
            f"busiest, {many[4:]}": busiest(least_many[key]),
        }
        for key, name in PARTS.items()
    ]


def busiest(floor: dict[str, float]) -> str:
    """The units of the processor that a floor is of."""
    return max((unit for unit in floor if unit != "floor"), key=floor.__getitem__)


def roofline_rows(roofs: dict[str, Any]) -> list[dict[str, Any]]:
    """A row a kind of operation: its cycles, and how many of it a node has in a pass."""
    return [
        {
            "what": name,
            **{f"cycles, {w} lanes": roof["cycles"][key] for w, roof in roofs.items()},
            **{
                f"of a node, {w} lanes": roof["of_a_node"]["pass"].get(key, float("nan"))
                for w, roof in roofs.items()
            },
        }
        for key, name in KINDS.items()
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
        "The floor is the least that a node's operations and lines can cost this processor: those "
        "that the compiled programs have, counted as they run, times what each costs among others "
        "of its kind, of whichever is busy longest, the units for sums and products, the one that "
        "divides or the caches. It leaves out what waits for what, comparisons and choices, and "
        "numbers parked on the stack. Parts are differences of programs that are compiled apart, "
        "so that a small one may come out below nothing.",
        markdown(Table("What a pass is made of", roofline_rows(figures["rooflines"]))),
    ]
    return "\n\n".join(lines) + "\n"
