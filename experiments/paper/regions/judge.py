"""What areas, widths and heights say about the paper's statements."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import shapely
from numpy.typing import NDArray

from experiments.paper.statement import Statement, verdict
from snapjump.inverse.gauss_newton import grid_triangles
from snapjump.run.studies.base import Done, Row

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Region:
    """``apexes``, ``predicted`` (n, n, 2): of the grid of controls, in L, delta_alpha along the
    first axis, NaN where the robot does not jump; ``outline``, ``learned``: their regions."""

    mass_bar: float
    mu: float
    apexes: Array
    predicted: Array
    outline: Any
    learned: Any

    def width_bar(self, height_bar: float) -> float:
        """How much of a horizontal line at a height (L) is in the region, in L."""
        low, _, high, _ = self.outline.bounds
        line = shapely.LineString([(low, height_bar), (high, height_bar)])
        return float(self.outline.intersection(line).length)

    @property
    def coarser(self) -> Any:
        """The region by every second design alone."""
        return outline_of(self.apexes[::2, ::2])

    @property
    def cone_share(self) -> float:
        """The largest share of 2 mu y that an x is, which is what the friction cone allows."""
        return float(np.nanmax(self.apexes[..., 0] / (2.0 * self.mu * self.apexes[..., 1])))


def outline_of(apexes: Array) -> Any:
    """The region of a grid (n, n, 2) of apexes; triangles with a NaN are left out.

    Holes are filled: where the map folds there are slivers, narrower than the grid can tell.
    """
    triangles = grid_triangles(apexes)
    known = triangles[np.isfinite(triangles).all(axis=(1, 2))]
    whole = shapely.union_all(shapely.make_valid(shapely.polygons(known)))
    parts = [part for part in shapely.get_parts(whole) if part.geom_type == "Polygon"]
    return shapely.union_all([shapely.Polygon(part.exterior) for part in parts])


def region_of(done: Done) -> Region:
    """The region of a cell."""
    inputs = done.cell.inputs
    apexes, predicted = (
        np.stack([done.column(f"{kind}{axis}_bar") for axis in "xy"], axis=-1).reshape(
            inputs["points"], inputs["points"], 2
        )
        for kind in ("", "predicted_")
    )
    outlines = outline_of(apexes), outline_of(predicted)
    return Region(inputs["mass_bar"], inputs["mu"], apexes, predicted, *outlines)


LEVELS = {"low": 0.25, "middle": 0.5, "high": 0.75}  # of the baseline region's heights
# Saturated: the lower half of the frictions' range has done so much of the widening.
SATURATED = 0.8
# Left alone: a limit of the heights moves by less than this share over all frictions; within a
# limit: by less than the second, which is little beside the widths, as these change severalfold.
ALONE, NEARLY_ALONE = 0.05, 0.2
COMMAND = "task=paper figure=regions"


def heights(baseline: Region) -> dict[str, float]:
    """The heights (L) that widths are told at."""
    _, low, _, high = baseline.outline.bounds
    return {name: low + share * (high - low) for name, share in LEVELS.items()}


def line(region: Region, levels: Mapping[str, float]) -> Row:
    """A region as a line of the table."""
    _, low, right, high = region.outline.bounds
    common = region.outline.intersection(region.learned).area
    return {
        "m̄": region.mass_bar,
        "μ": region.mu,
        "area": region.outline.area,
        "area by every 2nd design": region.coarser.area,
        "area by the forward model": region.learned.area,
        "shared with it (%)": 100.0 * common / region.outline.union(region.learned).area,
        "largest x": right,
        "least y": low,
        "largest y": high,
        **{f"width at y = {y:.3g}": region.width_bar(y) for y in levels.values()},
        "largest x / 2μy": region.cone_share,
    }


def agreement(standard: Mapping[Any, Region], reference: Mapping[Any, Region]) -> str:
    """How far the designs that both tiers have simulated are apart."""
    errors = []
    for environment, exact in reference.items():
        every = (len(standard[environment].apexes) - 1) // (len(exact.apexes) - 1)
        ours = standard[environment].apexes[::every, ::every]
        errors.append(np.abs(ours - exact.apexes) / exact.apexes)
    x, y = (100.0 * np.nanquantile(np.stack(errors)[..., k], 0.95) for k in (0, 1))
    count = np.stack(errors)[..., 0].size
    return (
        f"`standard`, {count} of the designs against `reference`: 95 % of x within {x:.2g} %, of y "
        f"within {y:.2g} %; the extremes at `paper` too"
    )


def falls(values: Sequence[float]) -> bool:
    """Whether each is less than the one before."""
    return all(b < a for a, b in zip(values, values[1:], strict=False))


def mass_exponent(masses: Sequence[Region]) -> float:
    """The power of m_bar that the area goes with."""
    areas = [region.outline.area for region in masses]
    slope, _ = np.polyfit(np.log([region.mass_bar for region in masses]), np.log(areas), 1)
    return float(slope)


def held(inner: Region, outer: Region) -> float:
    """The share of a region's area that another one holds."""
    return float(inner.outline.intersection(outer.outline).area / inner.outline.area)


def shrinks(masses: Sequence[Region], paper: Sequence[Region], accuracy: str) -> Statement:
    """The statement about the mass; regions in the order of their masses, ``paper`` at the paper's
    settings. Confirmed if areas, widths and heights all fall with every step; within a limit if
    only areas do."""

    def extents(regions: Sequence[Region]) -> list[Any]:
        bounds = np.array([region.outline.bounds for region in regions])
        return [bounds[:, 2] - bounds[:, 0], bounds[:, 3] - bounds[:, 1]]

    areas, others = ([r.outline.area for r in regions] for regions in (masses, paper))
    all_fall = falls(areas) and falls(others)
    narrower = all(falls(one) for regions in (masses, paper) for one in extents(regions))
    first, last = masses[0], masses[-1]
    shares = [held(b, a) for a, b in zip(masses, masses[1:], strict=False)]
    return Statement(
        says="The achievable region shrinks as the robot gets heavier.",
        verdict=verdict(all_fall and narrower, all_fall),
        found=(
            f"From m̄ = {first.mass_bar:g} to {last.mass_bar:g} the area "
            f"{'falls at every step' if falls(areas) else 'goes'} from {areas[0]:.3g} to "
            f"{areas[-1]:.2g} L², "
            f"as m̄ to the power {mass_exponent(masses):.2f} "
            f"(paper's settings: {others[0]:.3g} to {others[-1]:.2g} L²). Of its area a heavier "
            f"robot's region has {100 * min(shares):.0f} to {100 * max(shares):.0f} % within the "
            f"next lighter one's; the least y goes from {first.outline.bounds[1]:.2g} to "
            f"{last.outline.bounds[1]:.2g} L."
        ),
        accuracy=accuracy,
        command=COMMAND,
    )


def grown(regions: Sequence[Region], height_bar: float) -> float:
    """The share of a width's whole change that the frictions up to the middle one bring."""
    widths = [region.width_bar(height_bar) for region in regions]
    return (widths[len(widths) // 2] - widths[0]) / (widths[-1] - widths[0])


def moved(regions: Sequence[Region]) -> tuple[float, float]:
    """By how much of itself the least and the largest y change over the frictions."""
    bounds = np.array([region.outline.bounds for region in regions])
    low, high = ((bounds[:, k].max() - bounds[:, k].min()) / bounds[0, k] for k in (1, 3))
    return float(low), float(high)


def widens(
    frictions: Sequence[Region],
    paper: Sequence[Region],
    levels: Mapping[str, float],
    accuracy: str,
) -> Statement:
    """The statement about friction; regions in the order of their frictions.

    Confirmed if the largest x grows with every step, the widening has come to its end at every
    height, and the heights are left alone; within a limit if the largest x grows, the widening has
    come to its end at some height, and the heights nearly are.
    """
    right = [region.outline.bounds[2] for region in frictions]
    widths = [[region.width_bar(levels[name]) for region in frictions] for name in LEVELS]
    ended = [grown(frictions, levels[name]) >= SATURATED for name in LEVELS]
    low, high = moved(frictions)
    left = max(low, high) < ALONE
    wider = falls([-x for x in right])
    at_paper = [region.outline.bounds[2] for region in paper]
    first, middle, last = frictions[0], frictions[len(frictions) // 2], frictions[-1]
    k = len(frictions) // 2
    told = "; ".join(
        f"at y = {levels[name]:.3g} L {row[0]:.2g}, {row[k]:.2g}, {row[-1]:.2g} L "
        f"({'saturated' if done else 'not saturated'})"
        for name, row, done in zip(LEVELS, widths, ended, strict=True)
    )
    return Statement(
        says=(
            "A larger friction coefficient widens the achievable region in x, until it saturates, "
            "and leaves its heights alone."
        ),
        verdict=verdict(
            wider and all(ended) and left,
            wider and any(ended) and max(low, high) < NEARLY_ALONE,
        ),
        found=(
            f"From μ = {first.mu:g} to {last.mu:g} the largest x {'grows' if wider else 'goes'} "
            f"from {right[0]:.2g} to {right[-1]:.2g} L (paper's settings: {at_paper[0]:.2g} to "
            f"{at_paper[-1]:.2g} L). The widths, at μ = {first.mu:g}, {middle.mu:g} and "
            f"{last.mu:g}: {told}. Meanwhile the largest y changes by {100 * high:.0f} % "
            f"({100 * moved(paper)[1]:.0f} % at the paper's settings) and the least by "
            f"{100 * low:.0f} %, {'within' if left else 'beyond'} the {100 * ALONE:g} % that count "
            f"as left alone. Saturated: {100 * SATURATED:g} % of the widening done by "
            f"μ = {middle.mu:g}."
        ),
        accuracy=accuracy,
        command=COMMAND,
    )


def summary(masses: Sequence[Region], frictions: Sequence[Region]) -> dict[str, float]:
    """Flat numbers of both statements."""
    low, high = moved(frictions)
    return {
        "region_area_lightest_bar2": masses[0].outline.area,
        "region_area_heaviest_bar2": masses[-1].outline.area,
        "region_area_mass_exponent": mass_exponent(masses),
        "region_largest_x_least_friction_bar": frictions[0].outline.bounds[2],
        "region_largest_x_most_friction_bar": frictions[-1].outline.bounds[2],
        "region_largest_y_change_over_friction": high,
        "region_least_y_change_over_friction": low,
    }
