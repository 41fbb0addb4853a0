"""dataset.png and status.png: what a dataset's jumps come to, and where they are not to be had."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from snapjump.dataset.statistics import KNOWN, Statistics
from snapjump.plan.parts.axes import labels_of
from snapjump.show.plots import palette
from snapjump.show.plots.saving import picture

OUTCOMES = ("apex distance $x / L$", "apex height $y / L$")
COLOURS = (palette.BEAM, palette.FORCE)
SHARES = (0.05, 0.25, 0.5, 0.75, 0.95)
Place = tuple[float, float, float, float]  # left, bottom, width, height: shares of a page
WIDTH = 14.0  # inches of all pages
MAPS_IN_A_ROW, MAP_ROW = 6, 2.835  # how many have room, and the inches of a row
MEANS, MARKED = "viridis", "Oranges"  # maps of colours
SHORT_NUMBERS = (-3, 4)  # powers of ten between which an axis writes its numbers out
EMPTY = palette.PALE  # a bin without a jump


def draw_dataset(statistics: Statistics, title: str, path: Path) -> None:
    """Outcomes against each input, their distribution, and their means over pairs of inputs."""
    rows = rows_of_maps(statistics)
    page = Page(12.6, 2 * (rows - 1) * MAP_ROW)
    with picture(path, (WIDTH, page.height), title) as figure:
        heading = "Against each input: median, middle half and 5 to 95 % of the jumps"
        _heading(figure, page.up(0.947), heading)
        stride = 0.78 / len(statistics.axes)
        for row, outcome in enumerate((1, 0)):
            bottom = 0.76 - 0.2 * row
            for axis, label in enumerate(labels_of(statistics.axes)):
                place = (0.055 + stride * axis, bottom, stride - 0.035, 0.16)
                axes = figure.add_axes(page.place(*place))
                _spread(axes, statistics, outcome, axis)
                axes.tick_params(labelleft=axis == 0, labelbottom=row == 1)
                if axis == 0:
                    axes.set_ylabel(OUTCOMES[outcome])
                if row == 1:
                    axes.set_xlabel(label)
            axes = figure.add_axes(page.place(0.835, bottom, 0.145, 0.16))
            _distribution(axes, statistics, outcome)
            axes.tick_params(labelleft=False, labelbottom=row == 1)
            if row == 1:
                axes.set_xlabel("share of jumps (% per L)")
        _heading(figure, page.up(0.468), "Over each pair of inputs: mean of the jumps")
        for row, outcome in enumerate((1, 0)):
            maps = [statistics.means(outcome, pair) for pair in range(len(statistics.pairs))]
            places = page.maps(len(maps), 0.275 - 0.225 * row * rows, 0.165)
            _maps(figure, statistics, maps, places, (OUTCOMES[outcome], MEANS))


def draw_status(
    statistics: Statistics, statuses: Mapping[str, int], title: str, path: Path
) -> None:
    """Jumps by status, and where those are that failed or are less exact than promised."""
    page = Page(6.4, (rows_of_maps(statistics) - 1) * MAP_ROW)
    with picture(path, (WIDTH, page.height), title) as figure:
        _heading(figure, page.up(0.88), "Jumps by status")
        _bars(figure.add_axes(page.place(0.16, 0.61, 0.8, 0.24)), statistics, statuses)
        doubted = "jumps that failed or estimate a larger error than their accuracy tier promises"
        _heading(figure, page.up(0.51), f"Over each pair of inputs: {doubted}")
        maps = [statistics.marked_percent(pair) for pair in range(len(statistics.pairs))]
        places = page.maps(len(maps), 0.11, 0.34)
        _maps(figure, statistics, maps, places, ("share of jumps (%)", MARKED), 0.0)


def rows_of_maps(statistics: Statistics) -> int:
    """Rows that the maps of all pairs take."""
    return -(-len(statistics.pairs) // MAPS_IN_A_ROW)


class Page(NamedTuple):
    """A page laid out in shares of ``usual`` inches of height, and ``more`` below that."""

    usual: float
    more: float

    @property
    def height(self) -> float:
        return self.usual + self.more

    def up(self, share: float) -> float:
        """A height of the usual page on this one."""
        return 1.0 - (1.0 - share) * self.usual / self.height

    def place(self, left: float, bottom: float, width: float, height: float) -> Place:
        """A place of the usual page on this one."""
        return left, self.up(bottom), width, height * self.usual / self.height

    def maps(self, count: int, bottom: float, height: float) -> list[Place]:
        """Places of so many maps, the first row at the usual one, and of their bar of colours."""
        found = []
        for k in range(count):
            row, column = divmod(k, MAPS_IN_A_ROW)
            down = row * MAP_ROW / self.usual
            found.append(self.place(0.055 + 0.147 * column, bottom - down, 0.105, height))
        return [*found, self.place(0.94, bottom, 0.012, height)]


def _bars(axes: Any, statistics: Statistics, statuses: Mapping[str, int]) -> None:
    """Counts on a logarithmic scale; those that doubt themselves apart from the rest."""
    failed = sum(count for name, count in statuses.items() if name not in KNOWN)
    doubtful = round(float(statistics.marked[0].sum())) - failed
    rows = [
        (name, count, palette.QUIET if name in KNOWN else palette.FORCE)
        for name, count in statuses.items()
        if name != "ok"
    ]
    rows.sort(key=lambda row: row[1])
    rows.append(("ok, larger error", doubtful, palette.CLAMP))
    rows.append(("ok, as promised", max(0, statuses.get("ok", 0) - doubtful), palette.CENTRE))
    counts = [count for _, count, _ in rows]
    axes.barh([name for name, *_ in rows], counts, color=[one for *_, one in rows], height=0.6)
    axes.set(ylim=(min(-0.6, len(rows) - 4.5), len(rows) - 0.4))
    axes.set(xscale="log", xlim=(0.5, 5.0 * max(counts)))
    axes.xaxis.set_major_formatter("{x:,.0f}")
    axes.grid(True, axis="x")
    for place, count in enumerate(counts):
        text = f" {count:,} ({100.0 * count / sum(counts):.3g} %)"
        axes.text(max(count, 0.5), place, text, va="center", color=palette.INK)


def _heading(figure: Any, y: float, text: str) -> None:
    figure.text(0.013, y, text, fontsize=11.5, color=palette.QUIET, va="center")


def _spread(axes: Any, statistics: Statistics, outcome: int, axis: int) -> None:
    """Bands of quantiles over the bins of an input."""
    edges = statistics.edges[axis]
    middles = 0.5 * (edges[1:] + edges[:-1])
    lowest, low, median, high, highest = statistics.quantiles(outcome, axis, SHARES)
    colour = COLOURS[outcome]
    axes.fill_between(middles, lowest, highest, color=colour, alpha=0.15, lw=0)
    axes.fill_between(middles, low, high, color=colour, alpha=0.3, lw=0)
    axes.plot(middles, median, "o-", color=colour, lw=2.0, ms=3.5)
    axes.set(xlim=(edges[0], edges[-1]), ylim=_shown(statistics, outcome))
    axes.locator_params(axis="x", nbins=4)
    axes.ticklabel_format(axis="x", scilimits=SHORT_NUMBERS)
    axes.grid(True)


def _distribution(axes: Any, statistics: Statistics, outcome: int) -> None:
    """The share of all jumps at each height of the axis."""
    counts = statistics.spread[outcome, 0].sum(axis=0)
    levels = statistics.levels[outcome]
    low, high = _shown(statistics, outcome)
    edges = np.linspace(low, high, 41)
    middles = 0.5 * (levels[1:] + levels[:-1])
    share, _ = np.histogram(middles, edges, weights=counts)
    share = 100.0 * share / max(counts.sum(), 1.0) / (edges[1] - edges[0])
    look = {"fill": True, "color": COLOURS[outcome], "alpha": 0.5}
    axes.stairs(share, edges, orientation="horizontal", **look)
    axes.set(xlim=(0.0, None), ylim=(low, high))
    axes.grid(True)


def _shown(statistics: Statistics, outcome: int) -> tuple[float, float]:
    """The heights that an axis shows: all but the outermost in a thousand."""
    counts = statistics.spread[outcome, 0].sum(axis=0)
    levels = statistics.levels[outcome]
    below = np.cumsum(counts) / max(counts.sum(), 1.0)
    low = levels[np.searchsorted(below, 0.001)]
    high = levels[min(np.searchsorted(below, 0.999) + 1, len(levels) - 1)]
    margin = 0.04 * (high - low)
    return float(min(0.0, low) - margin), float(high + margin)


def _maps(
    figure: Any,
    statistics: Statistics,
    maps: list[Any],
    places: list[Place],
    scale: tuple[str, str],
    low: float | None = None,
) -> None:
    """Pairs of inputs, on one scale of colours: its label and its name."""
    values = np.concatenate([np.ravel(one) for one in maps])
    values = values[np.isfinite(values)]
    least = (float(values.min()) if len(values) else 0.0) if low is None else low
    most = float(values.max()) if len(values) else 1.0
    most = most if most > least else least + 1.0
    mesh = None
    for place, (i, j), means in zip(places[:-1], statistics.pairs, maps, strict=True):
        axes = figure.add_axes(place)
        axes.set_facecolor(EMPTY)
        mesh = axes.pcolormesh(
            statistics.edges[i], statistics.edges[j], means.T, cmap=scale[1], vmin=least, vmax=most
        )
        axes.set_xlabel(statistics.axes[i].short, labelpad=1)
        axes.set_ylabel(statistics.axes[j].short, labelpad=1)
        axes.locator_params(nbins=3)
        axes.ticklabel_format(scilimits=SHORT_NUMBERS)
    bar = figure.add_axes(places[-1])
    figure.colorbar(mesh, cax=bar).set_label(scale[0])
