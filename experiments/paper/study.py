"""``python run.py task=paper``: every figure and every testable statement of the paper."""

import re
from collections.abc import Mapping, Sequence
from dataclasses import replace
from datetime import datetime
from typing import Any

from experiments.compositions import composed, described, groups_of
from experiments.paper.asymmetry.part import Asymmetry
from experiments.paper.base import VERDICTS, Part, Statement, paragraphs, statement_rows
from experiments.paper.bifurcation.part import Bifurcation
from experiments.paper.causes.part import Causes
from experiments.paper.designs.part import Designs
from experiments.paper.forward_model.part import ForwardModels
from experiments.paper.imperfections.part import Imperfections
from experiments.paper.influences.part import Influences
from experiments.paper.limits import limit_rows
from experiments.paper.regions.part import Regions
from experiments.paper.released_energy.part import ReleasedEnergy
from experiments.paper.snaps.part import Snaps
from experiments.paper.trajectories.part import Trajectories
from snapjump.checks import ParameterError, check_choice
from snapjump.composition import with_tier
from snapjump.dataset.specification import first_difference
from snapjump.files.sources import Source, combined_hash
from snapjump.run.studies.base import OK, Cell, Conclusion, Done, Row, Section, Table
from snapjump.run.studies.fingerprint import sources
from snapjump.run.studies.study import Study
from snapjump.show.terminal.block import markdown_table
from snapjump.tiers import TIERS

# In the order of the report; a new one is a folder and a name here.
PARTS: dict[str, type[Part]] = {
    part.name: part
    for part in (Bifurcation, ReleasedEnergy, Snaps, Asymmetry, Trajectories, Influences, Causes,
                 Regions, Designs, Imperfections, ForwardModels)
}  # fmt: skip

# Of the tier `paper`, as in conf/accuracy/paper.yaml.
SETTINGS = (
    f"implicit Euler at {TIERS['paper'].numbers['stepping.step_s']:g} s, lagged friction, clamps "
    "of two fixed nodes, contact stiffness per node, no material damping"
)
TITLE = "The paper, reproduced and judged"
INTRODUCTION = paragraphs(f"""The paper is *Inverse Design of Snap-Actuated Jumping Robots Powered
    by Mechanics-Aided Machine Learning* (Tong, Hao, Liu, Huang, arXiv 2408.10470). Every figure
    below is simulated anew by this library and every number is computed by the command above, at
    the tier `standard` unless it says otherwise; `paper` is the tier of the paper's settings:
    {SETTINGS}. (Lagged friction and clamps of two fixed nodes are the released program's: the text
    writes all forces at the end of a step, and does not say how clamps hold the beam.) A verdict
    is decided by the program from the numbers beside it, by the limits in the second table. Where
    these are ours, they say what still counts as linear, flat or alike, and were in places chosen
    when the numbers were known: read the numbers, not the verdict alone.

    Statements are in our words. Where the paper assumes something, or draws a curve without a
    claim, the statement is our reading of it, and says so.

    The converged model differs from the paper's in three respects. Its material damps
    (Kelvin-Voigt with η = 1e-5 s, the size of the paper's time step; the paper's implicit Euler
    damps what oscillates too, but not what buckles). Its frame is rigid, also at the tier `paper`;
    the paper's is an elastic chain of 1000 EI. And the ground is as stiff on every mesh as on the
    paper's, whose nodes have a spring each. What these do to a jump, and what the numerical
    choices do, is taken apart below.""")


def readme_block(statements: Sequence[Statement]) -> str:
    """Statements and verdicts alone, for the README."""
    rows = [[str(k), one.says.rstrip("."), one.verdict] for k, one in enumerate(statements, 1)]
    return (
        markdown_table(["", "the paper says", "verdict"], rows) + f"\n\n{counts(statements)}; "
        "the numbers, figures and causes: [docs/paper.md](docs/paper.md).\n"
        "`python run.py task=paper publish=docs` makes this table and that report."
    )


ALL = "all"


class Paper(Study):
    """The parts, each with cells of its own, and the table of all statements."""

    choices = ("figure",)
    # Cells name the sources of their own part among their inputs, so that an edited part is done
    # again and no other.
    sources = ("experiments.paper.settings",)

    def plan(self, config: Mapping[str, Any]) -> list[Cell]:
        """The cells of the part that is asked for, or of all."""
        figure = config["figure"]
        check_choice("figure", figure, (ALL, *PARTS))
        if config["publish"] is not None and figure != ALL:
            allowed = f"{ALL} with publish={config['publish']}, whose report is of all parts"
            raise ParameterError("figure", figure, allowed)
        groups = groups_of(config)
        check_standard(groups)
        self.parts: dict[str, Part] = {
            name: part() for name, part in PARTS.items() if figure in (ALL, name)
        }
        return [
            cell
            for name, part in self.parts.items()
            for cell in labelled(part.plan(groups, config["seed"]), name, source_digest(part))
        ]

    def compute(self, cell: Cell) -> list[Row]:
        """The rows of a cell, by its part."""
        return self.parts[cell.inputs["part"]].compute(cell.inputs)

    def conclude(self, done: Mapping[str, Done]) -> Conclusion:
        """The table of statements, then a section for each part."""
        of: dict[str, dict[str, Done]] = {name: {} for name in self.parts}
        for label, one in done.items():
            name = one.cell.inputs["part"]
            of[name][label.removeprefix(f"{name}: ")] = one
        found = {name: part.conclude(of[name]) for name, part in self.parts.items()}
        statements = [one for part in found.values() for one in part.statements]
        judged = Section(
            "Statement by statement",
            INTRODUCTION,
            tables={
                "statements": Table("The paper's statements", statement_rows(statements)),
                "limits": Table("The limits of the verdicts, and whose they are", limit_rows()),
            },
        )
        return Conclusion(
            title=TITLE,
            findings=[f"Of {len(statements)} statements: {counts(statements)}.", duration(done)],
            tables={},
            figures={},
            sections=[judged, *(part.section for part in found.values())],
            summary={
                **{f"statements_{v.replace(' ', '_')}": count(statements, v) for v in VERDICTS},
                **{key: value for part in found.values() for key, value in part.summary.items()},
            },
            blocks={"paper": readme_block(statements)} if self._whole(done) else {},
        )

    def _whole(self, done: Mapping[str, Done]) -> bool:
        """Whether nothing is missing from the table of all statements."""
        return len(self.parts) == len(PARTS) and all(one.status == OK for one in done.values())


def check_standard(groups: Mapping[str, Any]) -> None:
    """Raise ParameterError for settings other than those of ``accuracy=standard``.

    The parts set what the paper's figures vary themselves, and name what they set.
    """
    chosen = described(composed(groups))
    expected = described(with_tier("standard"))
    for found in (chosen, expected):
        found.pop("backend")
    different = first_difference(chosen, expected)
    if different is not None:
        key, value, standard = different
        raise ParameterError(key, value, f"{standard} with task=paper, as accuracy=standard has it")


def labelled(cells: Sequence[Cell], part: str, digest: str) -> list[Cell]:
    """A part's cells among those of all parts, with the hash of what computes them."""
    return [
        replace(
            cell,
            name=f"{part}: {cell.name}",
            inputs={**cell.inputs, "part": part, "sources": digest},
        )
        for cell in cells
    ]


def count(statements: Sequence[Statement], verdict: str) -> int:
    """How many statements have this verdict."""
    return sum(one.verdict == verdict for one in statements)


def counts(statements: Sequence[Statement]) -> str:
    """How many statements came to which verdict."""
    return ", ".join(f"{count(statements, verdict)} {verdict}" for verdict in VERDICTS)


def duration(done: Mapping[str, Done]) -> str:
    """How long all cells took, whenever they were done."""
    seconds = sum(
        (datetime.fromisoformat(one.finished_at) - datetime.fromisoformat(one.started_at))
        .total_seconds()
        for one in done.values()
    )  # fmt: skip
    return f"The {len(done)} computations behind them took {seconds / 60.0:.0f} minutes in all."


# Modules that say what was found, draw it and judge it: no row depends on them, nor on words.md.
TOLD = re.compile(r"experiments\.paper\.((\w+\.)?words|\w+\.figure|limits)")


def row_sources(part: Part) -> list[Source]:
    """The modules that compute a part, and those that they import."""
    used = sources(part.sources or (type(part).__module__,))
    return [one for one in used if not TOLD.fullmatch(one.name)]


def source_digest(part: Part) -> str:
    """A hash of these."""
    return combined_hash(row_sources(part))[:16]
