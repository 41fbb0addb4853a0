"""``python run.py task=paper``: every figure and every testable statement of the paper."""

import hashlib
from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from experiments.compositions import composed, groups_of
from experiments.paper.base import Part
from experiments.paper.parts import PARTS
from experiments.paper.statement import VERDICTS, Statement, statement_rows
from experiments.paper.texts import INTRODUCTION, TITLE, readme_block
from snapjump.checks import ParameterError, check_choice
from snapjump.studies.base import Cell, Conclusion, Done, Row, Section, Table
from snapjump.studies.fingerprint import sources
from snapjump.studies.study import Study

ALL = "all"


class Paper(Study):
    """The parts, each with cells of its own, and the table of all statements."""

    choices = ("figure",)
    # Cells name the sources of their own part among their inputs, so that an edited part is done
    # again and no other.
    sources = ("experiments.paper.base",)

    def plan(self, config: Mapping[str, Any]) -> list[Cell]:
        """The cells of the part that is asked for, or of all."""
        figure = config["figure"]
        check_choice("figure", figure, (ALL, *PARTS))
        groups = groups_of(config)
        simulation = composed(groups)
        if simulation.scene_name != "jump":
            raise ParameterError("sim", simulation.scene_name, "jump with task=paper")
        self.parts: dict[str, Part] = {
            name: part() for name, part in PARTS.items() if figure in (ALL, name)
        }
        return [
            replace(
                cell,
                name=f"{name}: {cell.name}",
                inputs={**cell.inputs, "part": name, "sources": source_digest(part)},
            )
            for name, part in self.parts.items()
            for cell in part.plan(groups, config["seed"])
        ]

    def compute(self, cell: Cell) -> list[Row]:
        """The rows of a cell, by its part."""
        return self.parts[cell.inputs["part"]].compute(cell.inputs)

    def conclude(self, done: Mapping[str, Done]) -> Conclusion:
        """The table of statements, then a section for each part."""
        found = {
            name: part.conclude(
                {
                    label.removeprefix(f"{name}: "): one
                    for label, one in done.items()
                    if one.cell.inputs["part"] == name
                }
            )
            for name, part in self.parts.items()
        }
        statements = [one for part in found.values() for one in part.statements]
        judged = Section(
            "Statement by statement",
            INTRODUCTION,
            tables={"statements": Table("The paper's statements", statement_rows(statements))},
        )
        return Conclusion(
            title=TITLE,
            findings=[tally(statements)],
            tables={},
            figures={},
            sections=[judged, *(part.section for part in found.values())],
            summary={
                **{f"statements_{v.replace(' ', '_')}": count(statements, v) for v in VERDICTS},
                **{key: value for part in found.values() for key, value in part.summary.items()},
            },
            blocks={"paper": readme_block(statements)} if len(self.parts) == len(PARTS) else {},
        )


def count(statements: list[Statement], verdict: str) -> int:
    """How many statements have this verdict."""
    return sum(one.verdict == verdict for one in statements)


def tally(statements: list[Statement]) -> str:
    """How many statements came to which verdict."""
    told = ", ".join(f"{count(statements, verdict)} {verdict}" for verdict in VERDICTS)
    return f"Of {len(statements)} statements: {told}."


def source_digest(part: Part) -> str:
    """A hash of the modules that compute a part, and of those that they import."""
    digest = hashlib.sha256()
    for file in sources(part.sources):
        digest.update(file.read_bytes())
    return digest.hexdigest()[:16]
