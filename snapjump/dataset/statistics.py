"""Statistics of a dataset, gathered shard by shard: memory is that of one shard and some bins."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import Any

import numpy as np

from snapjump.arrays import Array
from snapjump.dataset.columns import APEX
from snapjump.dataset.read import Dataset
from snapjump.plan.parts.axes import Axis

KNOWN = ("ok", "no_jump")  # statuses with an apex
FEWEST_BINS, MOST_BINS = 5, 24
LEVELS = 500  # bins of an outcome, from which its quantiles are taken


@dataclass
class Statistics:
    """Counts and sums over bins.

    ``axes``: the I inputs; ``pairs``: the P pairs of them, of one alone with itself; ``edges``:
    bins of each input (I, B + 1); ``levels``: of each outcome (2, LEVELS + 1); ``spread``
    (2, I, B, LEVELS): rows by outcome and bin of an input; over bins of each pair of inputs
    (P, B, B): ``rows``, ``marked`` rows (failed, or less exact than their tier promises), and
    ``known`` rows with the ``sums`` (2, P, B, B) of their outcomes.
    """

    axes: tuple[Axis, ...]
    pairs: tuple[tuple[int, int], ...]
    edges: Array
    levels: Array
    spread: Array
    rows: Array
    marked: Array
    known: Array
    sums: Array

    def quantiles(self, outcome: int, axis: int, shares: Sequence[float]) -> Array:
        """Quantiles of an outcome in the bins of an input (len(shares), B); NaN where empty."""
        counts = self.spread[outcome, axis]
        below = np.cumsum(counts, axis=1)
        middles = 0.5 * (self.levels[outcome, 1:] + self.levels[outcome, :-1])
        found = np.full((len(shares), len(counts)), np.nan)
        for j in np.nonzero(below[:, -1])[0]:
            places = np.searchsorted(below[j], np.array(shares) * below[j, -1])
            found[:, j] = middles[np.minimum(places, LEVELS - 1)]
        return found

    def means(self, outcome: int, pair: int) -> Array:
        """Mean of an outcome over the bins of a pair of inputs (B, B), NaN where empty."""
        with np.errstate(invalid="ignore"):
            return np.asarray(self.sums[outcome, pair] / self.known[pair])

    def marked_percent(self, pair: int) -> Array:
        """Share of marked rows over the bins of a pair (B, B), NaN where empty."""
        with np.errstate(invalid="ignore"):
            return np.asarray(100.0 * self.marked[pair] / self.rows[pair])


def bin_edges(axes: Sequence[Axis], plan: dict[str, Any], rows: int) -> Array:
    """Bins of each input (I, B + 1): one a value of a grid, if these are not too many."""
    points = plan.get("points", MOST_BINS + 1)
    low, high = np.array([axis.range for axis in axes]).T
    if points <= MOST_BINS:
        half = 0.5 * (high - low) / (points - 1)
        return np.linspace(low - half, high + half, points + 1, axis=1)
    bins = int(np.clip(np.sqrt(rows) / 3.0, FEWEST_BINS, MOST_BINS))
    return np.linspace(low, high, bins + 1, axis=1)


def outcome_levels(dataset: Dataset) -> Array:
    """Bins of the outcomes (2, LEVELS + 1), from the least to the greatest."""
    low, high = np.full(len(APEX), np.inf), np.full(len(APEX), -np.inf)
    for table in dataset.shards(APEX):
        for k, name in enumerate(APEX):
            values = table[name].drop_null().to_numpy()
            if len(values):
                low[k], high[k] = min(low[k], values.min()), max(high[k], values.max())
    nothing = low > high
    low[nothing], high[nothing] = 0.0, 1.0
    high = np.where(high > low, high, low + 1.0)
    return np.linspace(low, high, LEVELS + 1, axis=1)


def gather(dataset: Dataset) -> Statistics:
    """The statistics of all rows, in two passes."""
    axes = dataset.axes
    edges = bin_edges(axes, dataset.specification["plan"], dataset.rows)
    bins = edges.shape[1] - 1
    both = tuple(combinations(range(len(axes)), 2)) or ((0, 0),)
    pairs = (len(both), bins, bins)
    found = Statistics(
        axes=axes,
        pairs=both,
        edges=edges,
        levels=outcome_levels(dataset),
        spread=np.zeros((len(APEX), len(axes), bins, LEVELS)),
        rows=np.zeros(pairs),
        marked=np.zeros(pairs),
        known=np.zeros(pairs),
        sums=np.zeros((len(APEX), *pairs)),
    )
    for table in dataset.shards([*(a.column for a in axes), *APEX, "status", "within_tier"]):
        _add(found, table)
    return found


def _add(found: Statistics, table: Any) -> None:
    """Count the rows of one shard."""
    inputs = [table[axis.column].to_numpy() for axis in found.axes]
    outcomes = [table[name].to_numpy() for name in APEX]
    known = np.isin(np.array(table["status"].to_pylist()), KNOWN)
    marked = ~(known & table["within_tier"].fill_null(False).to_numpy())
    for k, (i, j) in enumerate(found.pairs):
        edges = found.edges[i], found.edges[j]
        for counts, rows in ((found.rows, ...), (found.marked, marked), (found.known, known)):
            counts[k] += np.histogram2d(inputs[i][rows], inputs[j][rows], edges)[0]
        for sums, outcome in zip(found.sums, outcomes, strict=True):
            weights = outcome[known]
            sums[k] += np.histogram2d(inputs[i][known], inputs[j][known], edges, weights=weights)[0]
    for spread, levels, outcome in zip(found.spread, found.levels, outcomes, strict=True):
        for counts, values, edges in zip(spread, inputs, found.edges, strict=True):
            counts += np.histogram2d(values[known], outcome[known], (edges, levels))[0]
