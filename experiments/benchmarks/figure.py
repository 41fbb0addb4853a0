"""Scaling laws in pictures: values against the distance from a limit, and over the law's."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from snapjump.show.plots import palette
from snapjump.show.plots.saving import panels

from ..styles import SERIES, boxes
from .scaling import Scaling

SIZE = (11.5, 4.8)


def draw_scalings(
    scalings: Mapping[str, Scaling], title: str, places: str, values: str, path: Path
) -> None:
    """Both logarithmic, with the laws dashed; and the ratio to the law, which should come to 1."""
    with panels(path, SIZE, title, *boxes(SIZE, 1, 2, left=0.95, across=0.95)) as (left, right):
        for (name, one), (colour, mark, _) in zip(scalings.items(), SERIES, strict=False):
            label = f"{name}: exponent {one.fitted:.3f}, law {one.exponent:.4g}"
            style: Any = {"color": colour, "marker": mark, "ms": 6, "lw": 1.6}
            left.plot(one.places, one.values, ls="", label=label, **style)
            law = one.prefactor * one.places**one.exponent
            left.plot(one.places, law, color=colour, lw=1.4, ls="--")
            right.plot(one.places, one.ratios, label=name, **style)
        left.set(xscale="log", yscale="log", xlabel=places, ylabel=values)
        right.axhline(1.0, color=palette.QUIET, lw=1.2, ls="--")
        right.set(xscale="log", xlabel=places, ylabel="over the amplitude equation's law")
        low, high = left.get_ylim()
        left.set_ylim(low, high * (high / low) ** 0.3)  # room for the legend
        left.legend(loc="upper left")
        right.legend(loc="lower left")
