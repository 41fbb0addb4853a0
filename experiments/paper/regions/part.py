"""``figure=regions``: the achievable region against the robot's mass and the ground's friction."""

from collections.abc import Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import Any

from experiments.paper.base import Found, Part
from experiments.paper.baseline import BASELINE
from experiments.paper.learned import shipped_inputs
from experiments.paper.regions import judge, texts
from experiments.paper.regions.figure import draw_regions, draw_settings
from experiments.paper.regions.outlines import Region, region_of
from experiments.paper.tiers import groups_at
from experiments.paper.unfinished import unfinished
from snapjump.studies.base import Cell, Done, Figure, Row, Section, Table

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
            "regions": Figure(texts.CAPTION, partial(draw_regions, masses, frictions)),
            "regions_settings": Figure(texts.SETTINGS, partial(_settings, standard, other)),
        }
        section = Section(
            TITLE,
            texts.paragraphs(masses, frictions, other),
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
