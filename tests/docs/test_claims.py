"""README and pages: their Python runs, their numbers stand where they come from."""

import ast
import re
import tomllib
from importlib import import_module
from pathlib import Path

import nbformat
import pytest
import yaml
from command_line import ROOT
from pages import LAW_PAGE, LINK, README, blocks, text_of

from snapjump import __version__
from snapjump.run.tasks.publish import replaced
from snapjump.show.terminal.output_table import output_table, status_table

WITH_SNIPPETS = [ROOT / "README.md", *ROOT.glob("docs/**/*.md"), *ROOT.glob("docs/*.ipynb")]
# What the blocks of a page begin to print.
AGAINST = text_of("docs/against.md")
PRINTED = {
    "README.md": "ok 5.3",
    "docs/accuracy.md": "<apex x 5.368 +- ",
    "docs/designing.md": "<target 3, 12 L reached",
    "docs/datasets.md": "[21.8",
}
PYTHON = {
    source: page
    for page in PRINTED
    for source in blocks(text_of(page), "python")
    if "outputs/" not in source  # which only the reader's machine has
}


@pytest.mark.parametrize(("source", "page"), PYTHON.items(), ids=PYTHON.values())
def test_every_python_block_runs(source, page, capsys):
    if "ContactLaw" in source:
        assert source in LAW_PAGE
        return
    exec(compile(source, page, "exec"), {})
    assert capsys.readouterr().out.startswith(PRINTED[page])


def snippets(page: Path) -> list[str]:
    if page.suffix == ".md":
        return blocks(text_of(page), "python")
    cells = nbformat.read(page, as_version=4).cells
    code = [cell.source.splitlines() for cell in cells if cell.cell_type == "code"]
    # What begins with an exclamation mark is for a shell.
    return ["\n".join(line for line in lines if line[:1] != "!") for lines in code]


@pytest.mark.parametrize("page", WITH_SNIPPETS, ids=lambda page: page.name)
def test_imports_are_there(page):
    for snippet in snippets(page):
        for node in ast.walk(ast.parse(snippet)):
            if isinstance(node, ast.ImportFrom) and node.module.split(".")[0] == "snapjump":
                module = import_module(node.module)
                missing = [each.name for each in node.names if not hasattr(module, each.name)]
                assert not missing, f"{node.module} lacks {missing}"


def test_its_figures_stand_where_they_come_from():
    """The table against the paper: each number of ours on the page that its row links to (which
    may have more digits), and each factor the ratio of the numbers, whichever way is better."""
    table = AGAINST.partition("| | theirs |")[2].partition("\n\n")[0]
    rows = [[cell.strip() for cell in r.strip("|").split("|")] for r in table.splitlines()[2:]]
    assert len(rows) >= 7
    checked = 0
    for title, theirs, ours, factor, source in rows:
        (page,) = LINK.findall(source)
        written = re.findall(r"(?<![\w.])\d+(?:\.\d+)?", text_of(f"docs/{page}"))
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
    models, accuracy = text_of("docs/forward_models.md"), text_of("docs/accuracy.md")
    sections = ((README, "inverse"), (README, "tiers"), (AGAINST, "paper"), (models, "surrogates"),
                (accuracy, "claims"))  # fmt: skip
    for text, section in sections:
        assert text.index(f"<!-- {section}:begin -->") < text.index(f"<!-- {section}:end -->")


def test_the_tables_of_outputs_are_those_of_the_declarations(pytestconfig):
    """``pytest --write-golden`` writes it anew."""
    written = text_of("docs/outputs.md")
    text = replaced(written, "outputs", output_table())
    text = replaced(text, "statuses", status_table())
    if pytestconfig.getoption("--write-golden"):
        (ROOT / "docs" / "outputs.md").write_text(text, encoding="utf-8")
    else:
        assert written == text


def test_the_citation_is_of_this_version():
    project = tomllib.loads(text_of("pyproject.toml"))["project"]
    citation = yaml.safe_load(text_of("CITATION.cff"))
    assert citation["version"] == __version__
    assert citation["license"] == project["license"]["text"]
    assert citation["authors"] == project["authors"]
    assert f"Version {__version__}" in README
