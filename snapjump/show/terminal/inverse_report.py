"""The closing block of an inverse design: the design, where it leads, how sure that is."""

import re
from collections.abc import Mapping
from typing import Any

from snapjump.show.terminal.block import number
from snapjump.show.terminal.build_line import build_line
from snapjump.show.terminal.scene_report import accuracy_line

MOST_LISTED = 5
NAMES = ("robust", "plain")
COST = re.compile(r"one_percent_\w+_bar")


def inverse_report(config: Mapping[str, Any], summary: Mapping[str, Any]) -> list[tuple[str, str]]:
    """Lines of (heading, text); numbers that there are not are left out."""
    title = (
        f"target {point(summary, 'target')}, mu {number(config['environment']['mu'])}, "
        f"mass_bar {number(config['environment']['mass_bar'])}, {sloping(summary)}"
        f"by {config['inverse']['name']}"
    )
    if "target_x_bar" not in summary:  # it was interrupted
        return [("inverse", f"by {config['inverse']['name']}")]
    length_mm = 1e3 * config["robot"]["length_m"]
    return [
        ("inverse", title),
        ("design", controls(summary, "")),
        ("predicted", point(summary, "predicted")),
        ("simulated", point(summary, "simulated", length_mm)),
        ("on level", point(summary, "level", length_mm)),
        ("error", length(summary["error_bar"], length_mm)),
        ("build", built(config, summary)),
        ("1 % of", costs(summary, length_mm)),
        ("others", others(summary)),
        ("plain", controls(summary, "plain_")),
        ("robust", robust(summary, length_mm)),
        ("accuracy", accuracy_line(config, summary)),
        ("cost", cost(summary)),
    ]


def sloping(summary: Mapping[str, Any]) -> str:
    """The ground's slope, along and across which apexes are; nothing on level ground."""
    slope_rad = summary.get("slope_rad")
    return "" if slope_rad is None else f"slope {number(slope_rad)} rad, "


def length(value: float | None, length_mm: float) -> str:
    """A length in L and mm, or nothing."""
    return "" if value is None else f"{value:.3g} L ({value * length_mm:.3g} mm)"


def point(summary: Mapping[str, Any], name: str, length_mm: float | None = None) -> str:
    """An apex in L, and in mm with a length; nothing where there is none."""
    x, y = summary.get(f"{name}_x_bar"), summary.get(f"{name}_y_bar")
    if x is None or y is None:
        return ""
    if length_mm is None:
        return f"x {x:.4g} L, y {y:.4g} L"
    return f"x {x:.4g} L ({x * length_mm:.4g} mm), y {y:.4g} L ({y * length_mm:.4g} mm)"


def controls(summary: Mapping[str, Any], prefix: str) -> str:
    """A design, to what a machine could set; nothing where there is none."""
    delta_alpha = summary.get(f"{prefix}delta_alpha_rad")
    epsilon = summary.get(f"{prefix}epsilon")
    if delta_alpha is None or epsilon is None:
        return ""
    return f"delta_alpha {delta_alpha:.6g} rad, epsilon {epsilon:.6g}"


def built(config: Mapping[str, Any], summary: Mapping[str, Any]) -> str:
    """The robot to be built; nothing where there is no design."""
    epsilon, delta_alpha = summary.get("epsilon"), summary.get("delta_alpha_rad")
    if epsilon is None or delta_alpha is None:
        return ""
    return build_line(config, epsilon, delta_alpha, summary.get("mount_height_bar"))


def costs(summary: Mapping[str, Any], length_mm: float) -> str:
    """Changes of the apex by errors of one percent, in the order of the summary; those that are
    less than the numerical error by name alone."""
    because = summary.get("one_percent_unknown_because")
    if because:
        return f"not known: {because}"
    least = summary.get("numerical_error_bar") or 0.0
    found = {key: v for key, v in summary.items() if v is not None and COST.fullmatch(key)}
    named = {key.removeprefix("one_percent_")[:-4]: value for key, value in found.items()}
    told = ", ".join(f"{name} {length(v, length_mm)}" for name, v in named.items() if v > least)
    less = ", ".join(name for name, v in named.items() if v <= least)
    if less:
        less = f"less than the numerical error, {length(least, length_mm)}: {less}"
    return "; ".join(part for part in (told, less) if part)


def others(summary: Mapping[str, Any]) -> str:
    """Further designs for the same target."""
    count = summary["solutions"]
    listed = [controls(summary, f"solution_{k}_") for k in range(2, min(count, MOST_LISTED) + 1)]
    more = [f"and {count - MOST_LISTED} more"] if count > MOST_LISTED else []
    return "; ".join([*listed, *more])


def robust(summary: Mapping[str, Any], length_mm: float) -> str:
    """Expected misses with and without allowance for the tolerances."""
    if "robust_radius90_bar" not in summary:
        return ""
    ours, plain = (length(summary[f"{name}_expected_miss_bar"], length_mm) for name in NAMES)
    near, far = (length(summary[f"{name}_radius90_bar"], length_mm) for name in NAMES)
    return f"expected miss {ours} instead of {plain}, 90 % within {near} instead of {far}"


def cost(summary: Mapping[str, Any]) -> str:
    """Time and simulations of the search, and time of the robust design."""
    seconds, simulations = summary["solve_seconds"], summary["simulations"]
    took = f"{seconds:.3g} s" if seconds >= 1.0 else f"{1e3 * seconds:.3g} ms"
    search = f"{took} and {simulations} simulations for the search"
    more = summary.get("robust_seconds")
    return search if more is None else f"{search}, {more:.2g} s for the robust design"
