"""summary.png of a sweep: each main result against what was swept, as lines or as a map."""

import pathlib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from snapjump.arrays import Array
from snapjump.show.plots import palette
from snapjump.show.plots.saving import picture

PANEL_INCHES, TITLE_INCHES, LEGEND_INCHES = (5.2, 3.9), 0.55, 2.0
FINE = 5  # values of two inputs, from which on their grid is drawn as a map
MOST_LINES = len(palette.SERIES)
GEOMETRIC = 8.0  # the ratio of an input's ends from which on its axis may be logarithmic


@dataclass(frozen=True)
class Swept:
    """What a sweep varied and what came of it; each sequence has an item for each of its C cells.

    ``inputs``: texts by label; ``results``: numbers by label, NaN where there is none; ``errors``:
    estimated errors of some of these; ``failed``: words for cells without a result, empty for
    others; ``title``: of the figure.
    """

    title: str
    inputs: Mapping[str, Sequence[str]]
    results: Mapping[str, Array]
    failed: Sequence[str]
    errors: Mapping[str, Array] = field(default_factory=dict)


@dataclass(frozen=True)
class Axis:
    """An input on an axis: places (C); words, if it has no numbers; whether it is logarithmic."""

    label: str
    places: Array
    words: Sequence[str]
    logarithmic: bool

    @classmethod
    def of(cls, label: str, texts: Sequence[str]) -> "Axis":
        """Numbers where they are; words stand at equal distances in their order."""
        try:
            places = np.array([float(text) for text in texts])
        except ValueError:
            words = list(dict.fromkeys(texts))
            return cls(label, np.array([float(words.index(text)) for text in texts]), words, False)
        return cls(label, places, (), is_geometric(np.unique(places)))

    @property
    def values(self) -> Array:
        """The different places, in order."""
        return np.unique(self.places)


def is_geometric(values: Array) -> bool:
    """Whether numbers in order are spread more evenly by their logarithms."""
    if len(values) < 3 or values[0] <= 0.0 or values[-1] < GEOMETRIC * values[0]:
        return False
    plain, logarithmic = np.diff(values), np.diff(np.log(values))
    return bool(np.std(logarithmic) / logarithmic.mean() < np.std(plain) / plain.mean())


def draw_sweep(swept: Swept, path: pathlib.Path) -> None:
    """A panel for each result."""
    axes = [Axis.of(label, texts) for label, texts in swept.inputs.items()]
    # Across goes what has the most values, numbers before words.
    axes.sort(key=lambda axis: (bool(axis.words), -len(axis.values)))
    as_map = len(axes) == 2 and not axes[1].words and len(axes[1].values) >= FINE
    wide = PANEL_INCHES[0] * len(swept.results)
    legend = 0.0 if as_map or len(axes) == 1 else LEGEND_INCHES
    with picture(path, (wide + legend, PANEL_INCHES[1] + TITLE_INCHES), swept.title) as figure:
        high = PANEL_INCHES[1] / (PANEL_INCHES[1] + TITLE_INCHES)
        figure.set_layout_engine("constrained", rect=(0.01, 0, 0.98, high))
        panels = figure.subplots(1, len(swept.results), squeeze=False)[0]
        for panel, (label, values) in zip(panels, swept.results.items(), strict=True):
            if as_map:
                _map(figure, panel, axes[0], axes[1], label, values)
            else:
                _lines(panel, axes, label, values, swept)
        if legend:
            title = ", ".join(axis.label for axis in axes[1:])
            handles, labels = panels[0].get_legend_handles_labels()
            figure.legend(handles, labels, title=title, loc="outside right center")


def _lines(panel: Any, axes: Sequence[Axis], label: str, values: Array, swept: Swept) -> None:
    """A line for each choice of the other inputs, with bars of the estimated errors."""
    across, others = axes[0], list(swept.inputs.items())
    texts = [given for name, given in others if name != across.label]
    groups = list(zip(*texts, strict=True)) if texts else [()] * len(values)
    names = list(dict.fromkeys(groups))
    low = np.nanmin(values) if np.isfinite(values).any() else 0.0
    for k, name in enumerate(names):
        own = np.array([group == name for group in groups])
        order = np.flatnonzero(own)[np.argsort(across.places[own], kind="stable")]
        colour = palette.SERIES[k] if len(names) <= MOST_LINES else palette.QUIET
        bars = swept.errors.get(label)
        panel.errorbar(
            across.places[order], values[order], None if bars is None else bars[order],
            fmt="o-" if not across.words else "o", ms=4, lw=1.4, capsize=2.5, color=colour,
            label=", ".join(name) if len(names) <= MOST_LINES else None,
        )  # fmt: skip
        lost = [cell for cell in order if swept.failed[cell]]
        marks = [low] * len(lost)
        panel.plot(across.places[lost], marks, "x", color=colour, ms=7, mew=1.8)
    _dress(panel, across, label)
    told = list(dict.fromkeys(filter(None, swept.failed)))
    if told:
        panel.text(
            0.02, 0.98, f"× {', '.join(told)}", transform=panel.transAxes, va="top",
            color=palette.QUIET, fontsize=9,
        )  # fmt: skip


def _map(figure: Any, panel: Any, across: Axis, up: Axis, label: str, values: Array) -> None:
    """The result over the grid of two inputs; a cell without one is left blank."""
    table = np.full((len(up.values), len(across.values)), np.nan)
    rows, columns = (
        np.searchsorted(up.values, up.places),
        np.searchsorted(across.values, across.places),
    )
    table[rows, columns] = values
    shown = panel.pcolormesh(across.values, up.values, table, shading="nearest", cmap="viridis")
    figure.colorbar(shown, ax=panel, label=label)
    _dress(panel, across, up.label)
    panel.grid(False)
    if up.logarithmic:
        panel.set_yscale("log")
        panel.set_yticks(up.values, [f"{value:g}" for value in up.values])
        panel.yaxis.minorticks_off()


def _dress(panel: Any, across: Axis, label: str) -> None:
    panel.set(xlabel=across.label, ylabel=label)
    panel.grid(True)
    if across.logarithmic:
        panel.set_xscale("log")
        panel.set_xticks(across.values, [f"{value:g}" for value in across.values])
        panel.xaxis.minorticks_off()
    if across.words:
        panel.set_xticks(range(len(across.words)), across.words)
