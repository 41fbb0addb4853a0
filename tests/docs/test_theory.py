"""The theory page names every member of every family, and points at files that exist."""

import re
from pathlib import Path

import pytest
from families import EVERY

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs" / "theory.md"
TEXT = PAGE.read_text(encoding="utf-8")
POINTERS = re.findall(r"\]\(([^)#\s]+)\)", TEXT)
QUOTED = re.findall(r"`((?:tests|snapjump|experiments)/[^`]+)`", TEXT)
MEMBERS = [(family, name) for family, members in EVERY.items() for name in members]
# What has equations: a file of theirs that the page has to point at.
EQUATIONS = ("contact", "damping", "discretization", "friction", "integrator", "stepping")


@pytest.mark.parametrize(("family", "name"), MEMBERS)
def test_every_member_is_named(family, name):
    assert re.search(rf"`{name}`", TEXT)


def test_pointers_exist():
    assert len(POINTERS) > 80
    missing = [place for place in POINTERS if not (PAGE.parent / place).exists()]
    missing += [place for place in QUOTED if not (ROOT / place).exists()]
    assert not missing


@pytest.mark.parametrize("family", EQUATIONS)
def test_every_file_of_equations_is_pointed_at(family):
    files = {path.resolve() for path in (ROOT / "snapjump" / family).glob("*.py")}
    pointed = {(PAGE.parent / place).resolve() for place in POINTERS}
    left_out = {path.name for path in files - pointed} - {"__init__.py", "base.py", "none.py"}
    assert not left_out


def test_equations_are_closed():
    without_code = re.sub(r"`[^`]*`", "", TEXT)
    assert without_code.count("$$") % 2 == 0
    assert without_code.replace("$$", "").count("$") % 2 == 0
