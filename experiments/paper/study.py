"""``python run.py task=paper``: every figure and every testable statement of the paper."""

from collections.abc import Mapping, Sequence
from datetime import datetime
from typing import Any

from snapjump.checks import ParameterError, check_choice
from snapjump.composition import with_tier
from snapjump.dataset.specification import first_difference
from snapjump.robot.robot import Robot
from snapjump.run.studies.base import OK, Cell, Conclusion, Done, Section, Table
from snapjump.run.tasks.base import SIMULATION
from snapjump.show.terminal.block import markdown_table
from snapjump.tiers import TIERS

from ..compositions import composed, described, groups_of
from ..parted import Parted
from .asymmetry.part import Asymmetry
from .base import VERDICTS, Part, Statement, statement_rows
from .bifurcation.part import Bifurcation
from .causes.part import Causes
from .designs.part import Designs
from .forward_model.part import ForwardModels
from .imperfections.part import Imperfections
from .influences.part import Influences
from .limits import limit_rows
from .regions.part import Regions
from .released_energy.part import ReleasedEnergy
from .snaps.part import Snaps
from .trajectories.part import Trajectories
from .words import Words

# In the order of the report; a new one is a folder, with its words.md, and a name here.
PARTS: dict[str, type[Part]] = {
    part.name: part
    for part in (Bifurcation, ReleasedEnergy, Snaps, Asymmetry, Trajectories, Influences, Causes,
                 Regions, Designs, Imperfections, ForwardModels)
}  # fmt: skip

WORDS = Words(__file__)
TITLE = "The paper, reproduced and judged"


def readme_block(statements: Sequence[Statement]) -> str:
    """Statements and verdicts alone, for a guide."""
    rows = [[str(k), one.says.rstrip("."), one.verdict] for k, one in enumerate(statements, 1)]
    table = markdown_table(["", "the paper says", "verdict"], rows)
    return f"{table}\n\n{WORDS.filled('readme', {'counts': counts(statements)})}"


ALL = "all"


class Paper(Parted):
    """The parts, each with cells of its own, and the table of all statements."""

    keys = (*SIMULATION, "figure")

    choices = ("figure",)
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
        chosen = [part for name, part in PARTS.items() if figure in (ALL, name)]
        return self.cells_of(chosen, groups, config["seed"])

    def conclude(self, done: Mapping[str, Done]) -> Conclusion:
        """The table of statements, then a section for each part."""
        found = self.found(done)
        statements = [one for part in found.values() for one in part.statements]
        gravity = Robot().gravity_m_s2
        judged = Section(
            "Statement by statement",
            WORDS.paragraphs("introduction", paper=TIERS["paper"].numbers, gravity=gravity),
            tables={
                "statements": Table(WORDS("caption statements"), statement_rows(statements)),
                "limits": Table(WORDS("caption limits"), limit_rows()),
            },
        )
        return Conclusion(
            title=TITLE,
            findings=[f"Of {len(statements)} statements: {counts(statements)}.", duration(done)],
            tables={},
            figures={},
            sections=[judged, *(part.section for part in found.values())],
            summary={
                "gravity_m_s2": gravity,
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
