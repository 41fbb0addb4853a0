"""The figure of a sweep: each input against each main result."""

from collections.abc import Mapping, Sequence
from pathlib import Path

PANEL_INCHES = (3.6, 2.8)


def sweep_figure(
    path: Path, inputs: Mapping[str, Sequence[str]], results: Mapping[str, Sequence[float | None]]
) -> None:
    """One panel for each input and result; words stand at equal distances in their order."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    size = (PANEL_INCHES[0] * len(inputs), PANEL_INCHES[1] * len(results))
    figure = Figure(figsize=size, layout="constrained")
    FigureCanvasAgg(figure)
    panels = figure.subplots(len(results), len(inputs), squeeze=False)
    for row, (result, values) in zip(panels, results.items(), strict=True):
        for axes, (name, texts) in zip(row, inputs.items(), strict=True):
            places, words = positions(texts)
            pairs = [(x, y) for x, y in zip(places, values, strict=True) if y is not None]
            axes.plot(*zip(*pairs, strict=True), "o", color="#1f77b4", alpha=0.8)
            if words:
                axes.set_xticks(range(len(words)), words)
            axes.set_xlabel(name)
            axes.set_ylabel(result)
            axes.grid(alpha=0.3)
    figure.savefig(path, dpi=150)


def positions(texts: Sequence[str]) -> tuple[list[float], list[str]]:
    """Positions of an input's values on its axis, and the words to write there if any."""
    try:
        return [float(text) for text in texts], []
    except ValueError:
        words = list(dict.fromkeys(texts))
        return [float(words.index(text)) for text in texts], words
