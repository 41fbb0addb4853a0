"""The accuracy tiers as compositions, their promises, and their table for README.md."""

from collections.abc import Mapping
from typing import Any

from experiments.compositions import Groups, changed, described
from experiments.errors import FINEST_ELEMENTS, FINEST_START, FINEST_STEPPING
from experiments.tradeoff.points import Point
from snapjump.accuracy import TIERS
from snapjump.composition import with_tier
from snapjump.terminal.block import markdown_table

# Error of x and y (%, 95th percentile) and roughness (L) that a tier promises: design.md section 4.
PROMISES = {"draft": (3.0, 0.03), "standard": (0.5, 0.005), "reference": (0.05, 0.0005)}
CHOSEN = ("integrator", "stepping", "discretization", "friction", "sim")
BLOCK = "tiers"


def tier_groups(base: Groups, name: str) -> Groups:
    """A tier of the configured physical model; ``paper`` is a model of its own."""
    tier = described(with_tier(name))
    if name == "paper":
        return {**tier, "robot": base["robot"]}
    return changed(base, {group: tier[group] for group in CHOSEN})


def finest(base: Groups) -> Groups:
    """The limit that all others are judged by."""
    return changed(
        tier_groups(base, "reference"),
        {
            "discretization": {"elements": FINEST_ELEMENTS},
            "stepping": FINEST_STEPPING,
            "sim": {"start_fraction": FINEST_START},
        },
    )


def kept(point: Point, name: str) -> str:
    """Whether a tier keeps its promise, or what it breaks."""
    if name not in PROMISES:
        return "none made"
    error, rough = PROMISES[name]
    figures = {
        "x error": (point.x_p95_percent, error),
        "y error": (point.y_p95_percent, error),
        "x roughness": (point.x_roughness_bar, rough),
        "y roughness": (point.y_roughness_bar, rough),
    }
    broken = [key for key, (value, most) in figures.items() if not value <= most]
    return "kept" if not broken else "broken: " + ", ".join(broken)


def tier_rows(points: Mapping[str, Point]) -> list[dict[str, Any]]:
    """A row a tier."""
    return [
        {
            "tier": name,
            **{k: v for k, v in points[name].row().items() if k not in ("curve", "level")},
            "promise": kept(points[name], name),
        }
        for name in TIERS
    ]


def tier_block(points: Mapping[str, Point], designs: int) -> str:
    """The table of README.md, with what its columns mean."""
    header = ["tier", "error of x, y: median", "95 % of designs", "roughness of x, y (L)",
              "ms a jump and core"]  # fmt: skip
    order = [name for name in PROMISES if name in points] + ["paper"]
    rows = []
    for name in order:
        p = points[name]
        rows.append(
            [
                f"`{name}`" + (" (default)" if name == "standard" else ""),
                f"{p.x_median_percent:.2g} %, {p.y_median_percent:.2g} %",
                f"{p.x_p95_percent:.2g} %, {p.y_p95_percent:.2g} %",
                f"{p.x_roughness_bar:.1g}, {p.y_roughness_bar:.1g}",
                f"{p.ms:.2g}",
            ]
        )
    return (
        f"{markdown_table(header, rows)}\n\n"
        f"Errors are against the converged limit of the model, over {designs} designs spread over\n"
        "the paper's ranges; those of x relative to max(|x|, 0.1 y). Roughness is the standard\n"
        "deviation of the result about the converged one when delta_alpha moves in steps of\n"
        "0.001. Times are of one core with eight lanes, starts included.\n"
        "`python run.py task=tradeoff publish=docs/studies` measures all of it."
    )
