"""Words: texts under headings in ``words.md``, filled with values; what is missing is told."""

import re
from pathlib import Path
from types import SimpleNamespace

import pytest

from experiments.paper import words as module
from experiments.paper.base import CONFIRMED
from experiments.paper.words import Words

TEXT = """# height: says

It jumps {much[0][y_bar]:.2g} L
# height: found
{own.name}
   flies
# accuracy
`standard`
# height.oblique: says
Aside
# height.oblique: found
Less
# height.oblique: accuracy
`paper`
# text
One
text.

Another, of {count}.
# caption heights
Rows
# caption heights.png
Curves of {count}
"""


@pytest.fixture
def words(tmp_path) -> Words:
    (tmp_path / "jumps").mkdir()
    (tmp_path / "jumps" / "words.md").write_text(TEXT)
    return Words(str(tmp_path / "jumps" / "part.py"))


def test_a_statement_has_three_texts(words):
    values = {"much": [{"y_bar": 15.0}], "own": SimpleNamespace(name="one")}
    told = words.statement("height", CONFIRMED, **values)
    assert told == ("jumps.height", "It jumps 15 L", CONFIRMED, "one flies", "`standard`")
    assert words.statement("height.oblique", CONFIRMED).accuracy == "`paper`"


def test_a_section_has_paragraphs_and_captions(words):
    made = words.section("Heights", {"heights": print}, {"heights": []}, count=3)
    assert made.paragraphs == ["One text.", "Another, of 3."]
    assert made.figures["heights"].caption == "Curves of 3"
    assert made.tables["heights"].caption == "Rows"


def test_a_text_again_and_again(words):
    assert words.each("caption heights.png", [{"count": 1}, {"count": 2}], " and ") == (
        "Curves of 1 and Curves of 2"
    )


@pytest.mark.parametrize(
    ("values", "told"),
    [
        ({}, "KeyError.'much'"),
        ({"much": []}, "IndexError"),
        ({"much": [{"y_bar": None}]}, "TypeError"),
    ],
)
def test_a_missing_value_is_told_with_file_and_heading(words, values, told):
    with pytest.raises(ValueError, match=rf"jumps/words.md, '# height: says': {told}"):
        words("height: says", **values)


def test_a_missing_heading_is_told_with_the_file(words):
    with pytest.raises(KeyError, match="jumps/words.md has no heading '# depth: found'"):
        words("depth: found")


@pytest.mark.parametrize(
    "file",
    sorted(Path(module.__file__).parent.rglob("words.md")),
    ids=lambda file: file.parent.name,
)
def test_no_heading_of_a_part_hides_another(file):
    headings = re.findall(r"^# (.+)$", file.read_text(), flags=re.MULTILINE)
    assert len(headings) == len(set(headings))
