"""The pages of the documentation, and what is written in them."""

import re
from pathlib import Path

from command_line import ROOT

FENCE = re.compile(r"^```(\w*)\n(.*?)^```$", re.DOTALL | re.MULTILINE)
LINK = re.compile(r"\]\(([^)\s]+)\)")


def text_of(page: str | Path) -> str:
    """A page's text; named relative to the root."""
    return (ROOT / page).read_text(encoding="utf-8")


def blocks(text: str, language: str) -> list[str]:
    """The contents of all blocks of a language; of none, those of the shell."""
    return [content for kind, content in FENCE.findall(text) if kind == language]


def without_blocks(page: Path) -> str:
    return FENCE.sub("", text_of(page))


README = text_of("README.md")
LAW_PAGE = text_of("docs/adding_a_contact_law.md")
