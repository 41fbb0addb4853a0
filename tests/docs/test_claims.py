"""README and pages: their Python runs, their numbers stand where they come from."""

import re
import tomllib
from pathlib import Path

import pytest
import yaml

ROOT = Path(__file__).resolve().parents[2]
PAGES = [ROOT / "README.md"]
FENCE = re.compile(r"^```(\w*)\n(.*?)^```$", re.DOTALL | re.MULTILINE)
LINK = re.compile(r"\]\(([^)\s]+)\)")
LAW_PAGE = (ROOT / "docs" / "adding_a_contact_law.md").read_text(encoding="utf-8")


README = PAGES[0].read_text(encoding="utf-8")
PYTHON = {
    content: str(page.relative_to(ROOT))
    for page in (PAGES[0], *(ROOT / "docs" / f"{page}.md" for page in ("designing", "datasets")))
    for kind, content in FENCE.findall(page.read_text(encoding="utf-8"))
    if kind == "python" and "outputs/" not in content  # which only the reader's machine has
}


# What the blocks of a page begin to print.
PRINTED = {"README.md": "ok 5.3", "docs/designing.md": "True [", "docs/datasets.md": "[21.8"}


@pytest.mark.parametrize(("source", "page"), PYTHON.items(), ids=PYTHON.values())
def test_every_python_block_runs(source, page, capsys):
    if "ContactLaw" in source:
        assert source in LAW_PAGE
        return
    exec(compile(source, page, "exec"), {})
    assert capsys.readouterr().out.startswith(PRINTED[page])


def test_its_figures_stand_where_they_come_from():
    """The table against the paper: each number of ours on the page that its row links to (which
    may have more digits), and each factor the ratio of the numbers, whichever way is better."""
    table = README.partition("| | theirs |")[2].partition("\n\n")[0]
    rows = [[cell.strip() for cell in r.strip("|").split("|")] for r in table.splitlines()[2:]]
    assert len(rows) >= 7
    checked = 0
    for title, theirs, ours, factor, source in rows:
        (page,) = LINK.findall(source)
        text = (ROOT / page).read_text(encoding="utf-8")
        written = re.findall(r"(?<![\w.])\d+(?:\.\d+)?", text)
        for number in numbers(ours):
            places = len(number.partition(".")[2])
            assert any(f"{float(n):.{places}f}" == number for n in written), (title, number)
        pairs = zip(numbers(theirs, first=True), numbers(ours, first=True), numbers(factor),
                    strict=False)  # fmt: skip
        for before, now, told in pairs:
            ratio = float(before) / float(now)
            assert float(told) == pytest.approx(max(ratio, 1.0 / ratio), rel=0.06) or (
                float(told) == pytest.approx(ratio, rel=0.06)
            ), title
            checked += 1
    assert checked >= 10


def numbers(cell: str, first: bool = False) -> list[str]:
    """Numbers of a cell, without what is in brackets; ``first``: those that spreads follow only."""
    plain = re.sub(r"\([^)]*\)|(?<=\d),(?=\d{3})", "", cell)
    plain = re.sub(r" ± [\d.]+", "", plain) if first else plain
    return re.findall(r"\d+(?:\.\d+)?", plain)


def test_generated_sections_are_there():
    models = (ROOT / "docs/forward_models.md").read_text(encoding="utf-8")
    for text, section in (
        (README, "inverse"),
        (README, "tiers"),
        (README, "paper"),
        (models, "surrogates"),
    ):
        assert text.index(f"<!-- {section}:begin -->") < text.index(f"<!-- {section}:end -->")


def test_the_citation_is_of_this_version():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    citation = yaml.safe_load((ROOT / "CITATION.cff").read_text(encoding="utf-8"))
    assert citation["version"] == project["version"]
    assert citation["license"] == project["license"]["text"]
    assert citation["authors"] == project["authors"]
    assert f"Version {project['version']}" in README
