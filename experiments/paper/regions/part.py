"""``figure=regions``: the achievable region against the robot's mass and the ground's friction."""

from collections.abc import Mapping, Sequence
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from snapjump.run.studies.base import Cell, Done, Row, column
from snapjump.targets.region import SimulatedRegion as Region
from snapjump.targets.region import filled_outline

from ...compositions import groups_at
from ...trends import power
from ..base import Found, Part, Statement, span, weakest
from ..cells import apexes_of, jumps, shipped_forward, shipped_inputs
from ..limits import LIMITS, judged
from ..settings import BASELINE, NAMES, RANGES
from ..words import Words
from . import figure

Array = NDArray[np.float64]
Environment = tuple[float, float]  # mass_bar, mu
ByEnvironment = Mapping[Environment, Region]
WORDS = Words(__file__)
MASS_BAR, MU = BASELINE[2:]
BY_MASS = [(mass_bar, MU) for mass_bar in (0.3, 0.5, MASS_BAR, 1.2, 2.0)]
BY_FRICTION = [(MASS_BAR, mu) for mu in (0.1, 0.2, MU, 0.45, 0.6)]
EXTREMES = [BY_MASS[0], (MASS_BAR, MU), BY_MASS[-1], BY_FRICTION[0], BY_FRICTION[-1]]
# Of the grids of designs, per control. The reference's is every third design of the others'.
POINTS = {"standard": 25, "paper": 25, "reference": 9}
LEVELS = (0.25, 0.5, 0.75)  # of the baseline region's heights


def grid(environment: Environment, points: int) -> list[list[float]]:
    """Designs of the rectangle of controls, delta_alpha along the slow axis."""
    lags, epsilons = (np.linspace(*RANGES[name], points).tolist() for name in NAMES[:2])
    return [[lag, epsilon, *environment] for lag in lags for epsilon in epsilons]


def region_of(rows: Sequence[Row]) -> Region:
    """The region of a grid's jumps, and the forward model's."""
    designs = np.stack([column(rows, name) for name in NAMES], axis=-1)
    shape = (round(len(rows) ** 0.5), -1, 2)
    predicted = shipped_forward().predict(designs).reshape(shape)
    mass_bar, mu = designs[0, 2:].tolist()
    return Region(mass_bar, mu, apexes_of(rows).reshape(shape), predicted)


def row_of(region: Region, levels: Sequence[float]) -> Row:
    """A line of the table."""
    common = region.outline.intersection(region.learned).area
    return {
        "m̄": region.mass_bar,
        "μ": region.mu,
        "area": region.outline.area,
        "area by every 2nd design": filled_outline(region.apexes[::2, ::2]).area,
        "area by the forward model": region.learned.area,
        "shared with it (%)": 100.0 * common / region.outline.union(region.learned).area,
        "largest x": region.largest_x,
        "least y": region.least_y,
        "largest y": region.largest_y,
        **{f"width at y = {y:.3g}": region.width_bar(y) for y in levels},
        "largest x / 2μy": region.cone_share,
    }


def heights(baseline: Region) -> list[float]:
    """The heights (L) that widths are told at."""
    low, high = baseline.least_y, baseline.largest_y
    return [low + share * (high - low) for share in LEVELS]


def against(values: Sequence[float], rising: bool = False) -> int:
    """Steps at which values do not fall, or do not rise."""
    steps = np.diff(values) if rising else -np.diff(values)
    return int((steps <= 0.0).sum())


def mass_exponent(masses: Sequence[Region]) -> float:
    """The power of mass_bar that the area goes with."""
    values = [(region.mass_bar, region.outline.area) for region in masses]
    return power(*np.array(values).T)


def changes(regions: Sequence[Region]) -> tuple[float, float]:
    """By how much of itself the least and the largest y change over the regions."""
    ends = np.array([(region.least_y, region.largest_y) for region in regions])
    low, high = (np.ptp(ends, axis=0) / ends[0]).tolist()
    return low, high


def agreement(standard: ByEnvironment, reference: ByEnvironment) -> tuple[int, float, float]:
    """How many designs both tiers have, and how far 95 % of their x and y are apart (%)."""
    every = (POINTS["standard"] - 1) // (POINTS["reference"] - 1)
    exact = np.stack([region.apexes for region in reference.values()])
    ours = np.stack([standard[one].apexes[::every, ::every] for one in reference])
    x, y = (100.0 * np.nanquantile(np.abs(ours / exact - 1.0)[..., k], 0.95) for k in (0, 1))
    return exact[..., 0].size, float(x), float(y)


# The paper's text states neither of the two: its figure of the regions comes without a claim.


def shrinks(
    masses: Sequence[Region], paper: Sequence[Region], near: tuple[int, float, float]
) -> Statement:
    """The statement about the mass; regions in the order of their masses, ``paper`` at the paper's
    settings; ``near``: :func:`agreement`."""
    both = (masses, paper)
    areas = [[region.outline.area for region in one] for one in both]
    came = weakest(
        judged("regions.mass.area", *(against(one) for one in areas)),
        judged("regions.mass.extent",
               *(against([r.extent[k] for r in one]) for one in both for k in (0, 1))),
    )  # fmt: skip
    shares = [100 * after.held(one) for one, after in zip(masses, masses[1:], strict=False)]
    return WORDS.statement(
        "mass", came, first=masses[0], last=masses[-1],
        goes="goes" if against(areas[0]) else "falls at every step", exponent=mass_exponent(masses),
        paper=[paper[0], paper[-1]], shares=span(shares), near=near,
    )  # fmt: skip


def widens(
    frictions: Sequence[Region],
    paper: Sequence[Region],
    levels: Sequence[float],
    near: tuple[int, float, float],
) -> Statement:
    """The statement about friction; regions in the order of their frictions."""
    middle, saturated = len(frictions) // 2, LIMITS["regions.friction.share"].confirmed
    three = [frictions[k] for k in (0, middle, -1)]
    ended = {}
    for y in levels:
        widths = [region.width_bar(y) for region in frictions]
        ended[y] = (widths[middle] - widths[0]) / (widths[-1] - widths[0]) >= saturated
    moved = [changes(frictions), changes(paper)]
    came = weakest(
        judged("regions.friction.wider", against([r.largest_x for r in frictions], rising=True)),
        judged("regions.friction.saturated", sum(ended.values())),
        judged("regions.friction.heights", *moved[0]),
    )
    right, alone = [r.largest_x for r in frictions], LIMITS["regions.friction.heights"].confirmed
    told = [
        {"y": y, "widths": [one.width_bar(y) for one in three], "so": "" if done else "not "}
        for y, done in ended.items()
    ]
    return WORDS.statement(
        "friction", came, goes="grows" if right == sorted(right) else "goes", three=three,
        paper=[paper[0], paper[-1]], widths=WORDS.each("width", told), moved=100 * np.array(moved),
        within="within" if max(moved[0]) <= alone else "beyond", alone=100 * alone,
        saturated=100 * saturated, near=near,
    )  # fmt: skip


def values(
    masses: Sequence[Region], frictions: Sequence[Region], pairs: Sequence[tuple[Region, Region]]
) -> dict[str, Any]:
    """Values of the text; ``pairs``: regions at standard and with the paper's settings."""
    areas = np.array([region.outline.area for region in masses])
    scaled = areas * np.array([region.mass_bar for region in masses]) ** 2
    shares = [region.cone_share for region in frictions]
    apart = [100.0 * (paper.outline.area / own.outline.area - 1.0) for own, paper in pairs]
    return {
        "ranges": RANGES,
        "points": len(masses[0].apexes),
        "exponent": mass_exponent(masses),
        "scaled": scaled.max() / scaled.min(),
        "areas": areas.max() / areas.min(),
        "least_mu": frictions[0].mu,
        "shares": (shares[0], min(shares), shares[-1]),
        "changes": span(apart),
    }


def cell_name(tier: str, environment: Environment) -> str:
    """What a cell is called."""
    return f"{tier}, mass_bar {environment[0]:g}, mu {environment[1]:g}"


def environments(tier: str) -> list[Environment]:
    """All at standard, the extremes at the other tiers."""
    return [*dict.fromkeys([*BY_MASS, *BY_FRICTION])] if tier == "standard" else EXTREMES


class Regions(Part):
    """A cell for each environment and tier."""

    name = "regions"
    title = "Achievable regions"
    kinds = {"jumps": jumps}

    def plan(self, groups: Mapping[str, Any], seed: int) -> Sequence[Cell]:
        """The grid of controls in every environment."""
        shipped_inputs(groups_at(groups, "standard"))  # that the forward model is of this physics
        return [
            Cell(
                cell_name(tier, one),
                {"kind": "jumps", "groups": groups_at(groups, tier), "designs": grid(one, points)},
            )
            for tier, points in POINTS.items()
            for one in environments(tier)
        ]

    def judge(self, done: Mapping[str, Done]) -> Found:
        """Figures of outlines, a table of areas and extents, two statements."""
        standard, paper, reference = (
            {one: region_of(done[cell_name(tier, one)].rows) for one in environments(tier)}
            for tier in POINTS
        )
        masses, frictions = ([standard[e] for e in row] for row in (BY_MASS, BY_FRICTION))
        few = [[paper[e] for e in row if e in paper] for row in (BY_MASS, BY_FRICTION)]
        pairs = [(standard[environment], other) for environment, other in paper.items()]
        levels = heights(standard[MASS_BAR, MU])
        rows = [
            {"settings": tier, **row_of(region, levels)}
            for tier, regions in (("standard", standard), ("paper", paper))
            for region in regions.values()
        ]
        near = agreement(standard, reference)
        low, high = changes(frictions)
        figures = {
            "regions": partial(figure.draw_regions, masses, frictions),
            "regions_settings": partial(figure.draw_settings, pairs),
        }
        summary = {
            "region_area_lightest_bar2": masses[0].outline.area,
            "region_area_heaviest_bar2": masses[-1].outline.area,
            "region_area_mass_exponent": mass_exponent(masses),
            "region_largest_x_least_friction_bar": frictions[0].largest_x,
            "region_largest_x_most_friction_bar": frictions[-1].largest_x,
            "region_largest_y_change_over_friction": high,
            "region_least_y_change_over_friction": low,
        }
        return Found(
            WORDS.section(
                self.title, figures, {"regions": rows}, **values(masses, frictions, pairs)
            ),
            [shrinks(masses, few[0], near), widens(frictions, few[1], levels, near)],
            summary,
        )
