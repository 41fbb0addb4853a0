"""``figure=regions``: the achievable region against the robot's mass and the ground's friction."""

from collections.abc import Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from experiments.paper.base import Found, Part, unfinished
from experiments.paper.learned import shipped_inputs
from experiments.paper.regions import judge
from experiments.paper.regions.figure import draw_regions, draw_settings
from experiments.paper.regions.judge import Region, mass_exponent, region_of
from experiments.paper.settings import BASELINE, RANGES, groups_at
from snapjump.run.studies.base import Cell, Done, Figure, Row, Section, Table

TITLE = "Achievable regions"
MASS_BAR, MU = BASELINE[2:]
MASSES, FRICTIONS = (0.3, 0.5, 0.768, 1.2, 2.0), (0.1, 0.2, 0.3, 0.45, 0.6)
# Of the grids of designs, per control. The reference's is every third design of the others'.
POINTS = {"standard": 25, "paper": 25, "reference": 9}
Environment = tuple[float, float]
BY_MASS: Sequence[Environment] = [(mass_bar, MU) for mass_bar in MASSES]
BY_FRICTION: Sequence[Environment] = [(MASS_BAR, mu) for mu in FRICTIONS]
EXTREMES = (BY_MASS[0], (MASS_BAR, MU), BY_MASS[-1], BY_FRICTION[0], BY_FRICTION[-1])


class Regions(Part):
    """A cell for each environment and tier."""

    name = "regions"
    sources = ("experiments.paper.regions.compute",)

    def plan(self, groups: Mapping[str, Any], seed: int) -> Sequence[Cell]:
        """All environments at standard, the extremes at the other tiers."""
        learned = shipped_inputs(groups_at(groups, "standard"))
        everywhere = dict.fromkeys([*BY_MASS, *BY_FRICTION])
        return [
            Cell(
                cell_name(tier, environment),
                {
                    **learned,
                    "groups": groups_at(groups, tier),
                    "tier": tier,
                    "mass_bar": environment[0],
                    "mu": environment[1],
                    "points": POINTS[tier],
                },
            )
            for tier in POINTS
            for environment in (everywhere if tier == "standard" else EXTREMES)
        ]

    def compute(self, inputs: Mapping[str, Any]) -> list[Row]:
        """The grid of designs."""
        from experiments.paper.regions.compute import region_rows

        return region_rows(inputs)

    def conclude(self, done: Mapping[str, Done]) -> Found:
        """Figures of outlines, a table of areas and extents, two statements."""
        missing = unfinished(TITLE, done)
        if missing:
            return missing
        regions: dict[str, dict[Environment, Region]] = {tier: {} for tier in POINTS}
        for one in done.values():
            region = region_of(one)
            regions[one.cell.inputs["tier"]][region.mass_bar, region.mu] = region
        standard = regions["standard"]
        masses, frictions = ([standard[e] for e in row] for row in (BY_MASS, BY_FRICTION))
        other = regions["paper"]
        theirs = [[other[e] for e in row if e in other] for row in (BY_MASS, BY_FRICTION)]
        heights = judge.heights(standard[MASS_BAR, MU])
        rows = [
            {"settings": tier, **judge.line(region, heights)}
            for tier in ("standard", "paper")
            for region in regions[tier].values()
        ]
        accuracy = judge.agreement(standard, regions["reference"])
        statements = [
            judge.shrinks(masses, theirs[0], accuracy),
            judge.widens(frictions, theirs[1], heights, accuracy),
        ]
        figures = {
            "regions": Figure(CAPTION, partial(draw_regions, masses, frictions)),
            "regions_settings": Figure(SETTINGS, partial(_settings, standard, other)),
        }
        section = Section(
            TITLE,
            paragraphs(masses, frictions, other),
            figures,
            {"regions": Table("Achievable regions: areas in L², the rest in L", rows)},
        )
        return Found(section, statements, judge.summary(masses, frictions))


def _settings(
    standard: Mapping[Environment, Region], paper: Mapping[Environment, Region], path: Path
) -> None:
    draw_settings([(standard[environment], other) for environment, other in paper.items()], path)


def cell_name(tier: str, environment: Environment) -> str:
    """What a cell is called."""
    return f"{tier}, m_bar {environment[0]:g}, mu {environment[1]:g}"


CAPTION = (
    "Achievable regions of the simulated robots (filled) and by the forward model (dashed). Left: "
    "five masses; middle: the same, both axes times m̄; right: five frictions, with the lines "
    "x = 2μy of the cone of friction (dotted). Marks: the four corners of the controls"
)
SETTINGS = (
    "The extremes at `standard` (filled, with lines of constant mismatch, which rise, and of "
    "constant pre-compression, which cross them) and at the paper's settings (black outline)"
)


def paragraphs(
    masses: Sequence[Region],
    frictions: Sequence[Region],
    paper: Mapping[tuple[float, float], Region],
) -> list[str]:
    """What is shown, what is found, what differs and why."""
    points = len(masses[0].apexes)
    (low_lag, high_lag), (low, high) = RANGES["delta_alpha_rad"], RANGES["epsilon"]
    areas = np.array([region.outline.area for region in masses])
    scaled = areas * np.array([region.mass_bar for region in masses]) ** 2
    shares = [region.cone_share for region in frictions]
    ours = {(region.mass_bar, region.mu): region for region in [*masses, *frictions]}
    changes = [100.0 * (p.outline.area / ours[e].outline.area - 1.0) for e, p in paper.items()]
    return [
        f"The region of a robot and a ground is the image of the rectangle of Δα in "
        f"[{low_lag:g}, {high_lag:g}] rad and ε in [{low:g}, {high:g}], here by {points} × "
        f"{points} simulated jumps, mapped linearly in between.",
        "The energy that a snap releases does not depend on the mass, so that a heavier robot "
        "rises less. Places would go as 1/m̄, and areas as m̄⁻², if all of the energy were height; "
        f"the areas go as m̄ to the power {mass_exponent(masses):.2f}. With both axes times m̄ they "
        f"differ by a factor of {scaled.max() / scaled.min():.2g} instead of "
        f"{areas.max() / areas.min():.2g}. Where the rest of the energy "
        "goes is followed at three masses among the influences of the parameters.",
        "Friction limits how oblique a jump can be: the ground pushes sideways at most μ times as "
        "hard as upwards, so that apexes stay this side of x = 2μy. The largest x/(2μy) is "
        f"{shares[0]:.2f} at μ = {frictions[0].mu:g}, where friction alone draws the boundary, and "
        f"{min(shares):.2f} to {shares[-1]:.2f} for the largest μ. There high jumps are limited by "
        "the mismatch, and more friction widens the region no further; low ones of a large "
        "mismatch reach ever farther, in a flap of the map that unfolds to the right.",
        "At the paper's settings the areas differ from these by "
        f"{min(changes):+.0f} to {max(changes):+.0f} %, and the edges are uneven: at its time step "
        "neighbouring designs scatter.",
    ]
