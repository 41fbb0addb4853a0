"""training.png: learning curves of a forward model, parity, and errors by input."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from snapjump.arrays import Array
from snapjump.show.plots import palette
from snapjump.show.plots.saving import picture

NAMES = ("x", "y")
COLOURS = (palette.BEAM, palette.FORCE)
BINS = 15  # of each input
SHOWN = 4000  # points of a parity plot
TAIL = 0.995  # share of the errors that the histogram shows


def draw_training(
    curves: Sequence[Mapping[str, float]],
    labels: Sequence[str],
    designs: Array,
    apexes: Array,
    errors: Array,
    title: str,
    path: Path,
) -> None:
    """Curves by epoch (none for what has no epochs); of the test set, ``designs`` (N, I), whose
    columns have ``labels``, simulated ``apexes`` (N, 2) and ``errors`` (N, 2) of the prediction, in
    L."""
    stride = 0.96 / len(labels)
    with picture(path, (14.0, 8.4), title) as figure:
        _descent(figure.add_axes((0.055, 0.52, 0.225, 0.36)), curves)
        for i in (0, 1):
            axes = figure.add_axes((0.37 + 0.217 * i, 0.52, 0.165, 0.36))
            _parity(axes, apexes[:, i], apexes[:, i] + errors[:, i], i)
        _histogram(figure.add_axes((0.815, 0.52, 0.165, 0.36)), errors)
        most = 0.0
        places = []
        heading = "Where the error sits: its mean over each value, or range of values, of an input"
        figure.text(0.013, 0.425, heading, fontsize=11.5, color=palette.QUIET, va="center")
        for axis, label in enumerate(labels):
            axes = figure.add_axes((0.055 + stride * axis, 0.075, stride - 0.04, 0.315))
            most = max(most, _by_input(axes, designs[:, axis], np.abs(errors)))
            axes.set_xlabel(label)
            places.append(axes)
        for axes in places:
            axes.set_ylim(0.0, 1.1 * most or 1.0)
        places[0].set_ylabel("mean absolute error (L)")
        places[0].legend(loc="upper right", ncols=2)


def _descent(axes: Any, curves: Sequence[Mapping[str, float]]) -> None:
    """Loss and validation error on one logarithmic scale, and the batch size behind them."""
    axes.set_title("training")
    if not curves:
        axes.text(0.5, 0.5, "not trained by descent", ha="center", color=palette.QUIET)
        axes.set_axis_off()
        return
    epochs = [row["epoch"] for row in curves]
    validation = [row["validation_mae_bar"] for row in curves]
    axes.plot(epochs, [row["train_loss"] for row in curves], color=palette.QUIET, label="loss")
    axes.plot(epochs, validation, color=palette.CENTRE, label="validation MAE (L)")
    best = int(np.argmin(validation))
    axes.plot(epochs[best], validation[best], "o", color=palette.CENTRE, ms=5)
    axes.set(yscale="log", xlabel="epoch")
    axes.grid(True)
    rate = axes.twinx()
    rates = [row["learning_rate"] for row in curves]
    axes.plot([], [], color=palette.CLAMP, lw=1.0, ls="--", label="learning rate, right")
    rate.plot(epochs, rates, color=palette.CLAMP, lw=1.0, ls="--")
    rate.set_ylim(0.0, 3.0 * max(rates))
    rate.set_yticks([0.0, max(rates)], ["0", f"{max(rates):.0e}"])
    rate.tick_params(colors=palette.CLAMP, labelcolor=palette.CLAMP)
    rate.spines["right"].set_visible(True)
    axes.legend(loc="upper right")


def _parity(axes: Any, simulated: Array, predicted: Array, i: int) -> None:
    """Predicted against simulated; a perfect model lies on the diagonal."""
    some = slice(None, None, -(-len(simulated) // SHOWN))
    ends = [float(simulated.min()), float(simulated.max())]
    axes.plot(ends, ends, color=palette.PALE, lw=6.0)
    axes.plot(simulated[some], predicted[some], ".", ms=2.5, color=COLOURS[i])
    residual = ((predicted - simulated) ** 2).sum() / ((simulated - simulated.mean()) ** 2).sum()
    name = f"${NAMES[i]} / L$"
    axes.set(xlabel=f"simulated {name}", ylabel=f"predicted {name}")
    axes.set_title(f"{NAMES[i]}:  $1 - R^2$ = {residual:.1e}")
    axes.grid(True)


def _histogram(axes: Any, errors: Array) -> None:
    """A histogram of the errors, but for the largest."""
    end = float(np.quantile(np.abs(errors), TAIL)) or 1.0
    edges = np.linspace(-end, end, 61)
    for i in (0, 1):
        counts, _ = np.histogram(errors[:, i], edges)
        axes.stairs(100.0 * counts / len(errors), edges, color=COLOURS[i], label=NAMES[i], lw=1.4)
    axes.set_title(f"errors; largest {np.abs(errors).max():.2g} L")
    axes.set(xlabel="predicted less simulated (L)", ylabel="share of jumps (%)")
    axes.locator_params(axis="x", nbins=4)
    axes.grid(True)
    axes.legend(loc="upper right")


def _by_input(axes: Any, values: Array, off: Array) -> float:
    """Mean absolute error over bins of an input; returns the largest."""
    found = np.unique(values)
    if len(found) <= BINS:  # a grid: its own values
        where, middles = np.searchsorted(found, values), found
    else:
        edges = np.linspace(values.min(), values.max(), BINS + 1)
        where = np.clip(np.searchsorted(edges, values, side="right") - 1, 0, BINS - 1)
        middles = 0.5 * (edges[1:] + edges[:-1])
    counts = np.bincount(where, minlength=len(middles))
    most = 0.0
    for i in (0, 1):
        sums = np.bincount(where, off[:, i], minlength=len(middles))
        means = sums[counts > 0] / counts[counts > 0]
        axes.plot(middles[counts > 0], means, "o-", color=COLOURS[i], ms=3.5, label=NAMES[i])
        most = max(most, float(means.max()))
    axes.grid(True)
    return most
