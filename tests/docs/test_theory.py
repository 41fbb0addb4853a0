"""The theory page names every member, its files and those that test them."""

import re

import pytest
from command_line import ROOT
from families import of_all_families
from pages import text_of

THEORY = ROOT / "docs" / "theory.md"
TEXT = text_of(THEORY)
POINTERS = re.findall(r"\]\(([^)#\s]+)\)", TEXT)
QUOTED = re.findall(r"`((?:tests|snapjump|experiments)/[^`]+)`", TEXT)
# What has equations: a file of theirs that the page has to point at.
EQUATIONS = (
    "contact",
    "damping",
    "discretization",
    "drag",
    "drive",
    "friction",
    "integrator",
    "stepping",
)


@of_all_families
def test_every_member_is_named(family, name):
    assert f"`{name}`" in TEXT, family


def test_pointers_exist():
    assert len(POINTERS) > 80
    missing = [place for place in POINTERS if not (THEORY.parent / place).exists()]
    missing += [place for place in QUOTED if not (ROOT / place).exists()]
    assert not missing


@pytest.mark.parametrize("family", EQUATIONS)
def test_every_file_of_equations_is_pointed_at(family):
    files = {path.resolve() for path in (ROOT / "snapjump" / family).glob("*.py")}
    pointed = {(THEORY.parent / place).resolve() for place in POINTERS}
    left_out = {path.name for path in files - pointed} - {"__init__.py", "base.py", "none.py"}
    assert not left_out


def test_equations_are_closed():
    without_code = re.sub(r"`[^`]*`", "", TEXT)
    assert without_code.count("$$") % 2 == 0
    assert without_code.replace("$$", "").count("$") % 2 == 0
