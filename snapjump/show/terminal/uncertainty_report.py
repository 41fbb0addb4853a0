"""Lines of a closing block: what a jump may be off by, by its model and by its numbers."""

from collections.abc import Mapping
from typing import Any


def uncertainty_lines(summary: Mapping[str, Any], length_mm: float) -> list[tuple[str, str]]:
    """How far the apex may be off either way, the inputs that do most, and what is left out; none
    where that was not asked for."""
    if "model_spread_x_bar" not in summary:
        return []
    model, numerical = (
        both(summary, name, length_mm) or "not known here"
        for name in ("model_spread", "numerical_error")
    )
    return [
        ("off by", f"model {model}; numerical {numerical}"),
        ("most by", summary["model_spread_most"]),
        ("without", summary["model_left_out"]),
    ]


def both(summary: Mapping[str, Any], name: str, length_mm: float) -> str:
    """Of x and y either way; nothing where they are not known."""
    values = {axis: summary.get(f"{name}_{axis}_bar") for axis in "xy"}
    told = [
        f"{axis} +- {value:.2g} L ({value * length_mm:.2g} mm)"
        for axis, value in values.items()
        if value is not None
    ]
    return ", ".join(told)
