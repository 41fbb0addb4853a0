"""The accuracy tiers as compositions, their promises, and their table for README.md."""

from collections.abc import Mapping
from typing import Any

from snapjump.composition import with_tier
from snapjump.run.studies.base import OK, Done
from snapjump.show.terminal.block import markdown_table
from snapjump.tiers import TIERS

from ..compositions import Groups, changed, composed, described, groups_of
from ..designs import COLUMNS
from ..errors import relative_errors
from .points import Point, split

# Error of x and y (%, 95th percentile) and roughness (L) that a tier promises.
PROMISES = {
    name: (tier.promise_percent, tier.promise_percent / 100.0)
    for name, tier in TIERS.items()
    if name != "paper"
}
# What a tier chooses; all else, such as the friction threshold, is the physical model's.
CHOSEN: dict[str, tuple[str, ...] | None] = {
    "integrator": None,
    "stepping": None,
    "discretization": None,
    "friction": ("name",),
}
# Another integrator, a finer mesh and a tighter tolerance than any tier has: the limit that all are
# judged by.
FINEST = {
    "integrator": {"name": "tr_bdf2"},
    "discretization": {"elements": 896},
    "stepping": {
        "name": "adaptive", "tolerance": 2e-10, "contact_steps": 0.5, "stick_share": 1.0,
    },
}  # fmt: skip
BLOCK = "tiers"


def base_at(config: Mapping[str, Any], tier: str) -> Groups:
    """The configured model as a tier of its own; raises ParameterError where it is none."""
    base = {**tier_groups(groups_of(config), tier), "accuracy": {"name": tier}}
    composed(base)
    return base


def tier_groups(base: Groups, name: str) -> Groups:
    """A tier of the configured physical model; ``paper`` is a model of its own."""
    tier = described(with_tier(name))
    if name == "paper":
        return {**tier, "robot": base["robot"]}
    return changed(
        base,
        {group: {key: tier[group][key] for key in keys or tier[group]}
         for group, keys in CHOSEN.items()},
    )  # fmt: skip


def finest(base: Groups) -> Groups:
    """The limit that all others are judged by."""
    return changed(tier_groups(base, "reference"), FINEST)


def kept(point: Point, name: str) -> str:
    """Whether a tier keeps its promise, or what it breaks."""
    if name not in PROMISES:
        return "none made"
    words = {"error": "p95_percent", "roughness": "roughness_bar"}
    broken = [
        f"{coordinate} {word}"
        for (word, key), most in zip(words.items(), PROMISES[name], strict=True)
        for coordinate in ("x", "y")
        if not getattr(point, f"{coordinate}_{key}") <= most
    ]
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


def beyond(done: Mapping[str, Done], limit: Done) -> list[dict[str, Any]]:
    """The designs at which a tier (the keys) is further off than it promises."""
    found = []
    x_limit, y_limit = split(limit)["design"]
    for name, cell in done.items():
        if name not in PROMISES or cell.status != OK:
            continue
        errors = relative_errors(*split(cell)["design"], x_limit, y_limit)
        rows = [row for row in cell.rows if row["kind"] == "design"]
        for row, x, y in zip(rows, *errors, strict=True):
            if not max(x, y) <= PROMISES[name][0]:
                design = {column: row[column] for column in COLUMNS}
                off = {"x_error_percent": float(x), "y_error_percent": float(y)}
                found.append({"tier": name, "status": row["status"], **design, **off})
    return found


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
