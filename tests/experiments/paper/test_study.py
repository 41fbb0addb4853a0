"""The study of the paper: parts are chosen by name and done again when their own sources change."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import pytest
from cells import GIVEN, STANDARD, done, run_study

from experiments.paper import study as module
from experiments.paper.base import CONFIRMED, Found, Part, Statement
from experiments.paper.study import PARTS, Paper
from experiments.parted import row_sources, source_digest
from snapjump.checks import ParameterError
from snapjump.files.result_folder import ResultFolder
from snapjump.run.studies.base import FAILED, Cell, Done, Section


def configured(figure: Any) -> dict[str, Any]:
    return {**STANDARD, **GIVEN, "task": {"name": "paper"}, "figure": figure, "figures": False}


class Letters(Part):
    """One cell for each letter of a name."""

    name = "letters"
    sources = ("experiments.designs",)
    computed: list[str] = []

    def plan(self, groups: Mapping[str, Any], seed: int) -> list[Cell]:
        return [Cell(letter, {"letter": letter}) for letter in "ab"]

    def compute(self, inputs: Mapping[str, Any]) -> list[dict[str, Any]]:
        self.computed.append(inputs["letter"])
        return [{"letter": inputs["letter"]}]

    def conclude(self, done: Mapping[str, Done]) -> Found:
        letters = [row["letter"] for one in done.values() for row in one.rows]
        told = Statement("letters.all", "Letters", CONFIRMED, f"{[*done]}", "")
        return Found(Section("Letters", ["".join(letters)]), [told], {"letters": len(letters)})


class Others(Letters):
    """The same under another name."""

    name = "others"


@pytest.fixture(autouse=True)
def here(tmp_path, monkeypatch) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(module, "PARTS", {"letters": Letters, "others": Others})
    Letters.computed.clear()


def run(figure: str, name: str) -> tuple[Any, ResultFolder]:
    return run_study(Paper(), configured(figure), Path(name))


def test_one_part_and_then_all_of_them():
    outcome, folder = run("letters", "one")
    assert outcome.summary["letters"] == 2 and outcome.summary["statements_confirmed"] == 1
    assert Letters.computed == ["a", "b"]
    assert not (folder.path / "paper.block.md").exists()
    outcome, folder = run("all", "all")
    assert Letters.computed == ["a", "b"] * 2, "cells of a part are found again, whoever asked"
    assert outcome.summary["cells_kept"] == 2 and outcome.summary["statements_confirmed"] == 2
    report = (folder.path / "report.md").read_text()
    assert report.count("## Letters\n\nab") == 2 and "Of 2 statements: 2 confirmed" in report
    assert "['a', 'b']" in report, "a part knows its cells by its own names"
    assert (folder.path / "paper.block.md").exists()


def test_the_parts_there_are():
    Paper().prepare({**configured("all"), "backend": {"name": "lanes"}})  # which is free
    with pytest.raises(ParameterError, match="figure = 'trees' .* one of all, letters, others"):
        Paper().prepare(configured("trees"))
    with pytest.raises(ParameterError, match="figure = 'letters' .* all with publish=docs"):
        Paper().prepare({**configured("letters"), "publish": "docs"})


@pytest.mark.parametrize(
    ("changes", "told"),
    [
        ({"accuracy": {"name": "draft"}}, "accuracy.name = 'draft' .* standard with task=paper"),
        ({"environment": {"mu": 0.5}}, r"environment.mu = 0.5 .* 0.3 with task=paper"),
        ({"robot": {"length_m": 0.04}}, r"robot.length_m = 0.04 .* 0.02 with task=paper"),
        ({"damping": {"name": "none"}}, "damping.name = 'none' .* kelvin_voigt with task=paper"),
    ],
)
def test_settings_that_the_figures_have_of_their_own(changes, told):
    with pytest.raises(ParameterError, match=told):
        Paper().prepare({**configured("all"), **changes})


def test_no_block_for_the_readme_if_a_cell_failed(monkeypatch):
    def compute(part: Part, inputs: Mapping[str, Any]) -> Any:
        raise ZeroDivisionError(inputs["letter"])

    monkeypatch.setattr(Others, "compute", compute)
    outcome, folder = run("all", "all")
    assert outcome.status == "cells_failed" and not (folder.path / "paper.block.md").exists()


@pytest.mark.parametrize("name", list(PARTS))
def test_every_part_is_whole(name):
    part = PARTS[name]()
    assert part.name == name
    cells = part.plan(STANDARD, 0)
    assert cells and len({cell.name for cell in cells}) == len(cells)
    used = {source.name for source in row_sources(part)}
    assert f"experiments.paper.{name}.part" in used and "experiments.paper.limits" not in used
    told = {
        "experiments.paper.words",
        *(f"experiments.paper.{name}.{m}" for m in ("figure", "words")),
    }
    assert not told & used, "drawing and telling must not do cells again"
    assert len(source_digest(part)) == 16
    broken = done(cells[0], [], FAILED, "it broke")
    found = part.conclude({cells[0].name: broken})
    assert not found.statements
    assert f"{cells[0].name} ({FAILED}: it broke)" in found.section.paragraphs[0]
