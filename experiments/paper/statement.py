"""A statement of the paper, and what became of it when it was tested."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

from snapjump.run.studies.base import Row

CONFIRMED = "confirmed"
LIMITED = "confirmed within a limit"
NOT_CONFIRMED = "not confirmed"
VERDICTS = (CONFIRMED, LIMITED, NOT_CONFIRMED)


@dataclass(frozen=True)
class Statement:
    """``says``: what the paper says, in our words; ``verdict``: one of VERDICTS, decided from the
    numbers by the part that tests it; ``found``: the numbers, as a sentence, with the limit if
    there is one, and with what the paper's own settings give where that differs, and why;
    ``accuracy``: the tiers, and how far off they are; ``command``: what regenerates it.
    """

    says: str
    verdict: str
    found: str
    accuracy: str
    command: str = "task=paper"
    key: str = ""

    def __post_init__(self) -> None:
        assert self.verdict in VERDICTS, self.verdict


def verdict(holds: bool, within_limit: bool = False) -> str:
    """The verdict on a statement that holds throughout, or else within a limit that is told."""
    return CONFIRMED if holds else LIMITED if within_limit else NOT_CONFIRMED


def weakest(*verdicts: str) -> str:
    """Of a statement with several aspects: confirmed if all are, within a limit if none fails."""
    return max(verdicts, key=VERDICTS.index)


def stated(key: str, says: str, came: str, found: str, accuracy: str) -> Statement:
    """The statement with this key, ``<part>.<name>``, as in the table of limits."""
    return Statement(says, came, found, accuracy, f"task=paper figure={key.split('.')[0]}", key)


class Said(NamedTuple):
    """A statement's words, which may be written over several lines; as in :class:`Statement`."""

    says: str
    found: str
    accuracy: str

    def judged(self, key: str, came: str) -> Statement:
        """The statement with a key and a verdict."""
        says, found, accuracy = (prose(text) for text in self)
        return stated(key, says, came, found, accuracy)


def percent(share: float) -> str:
    """A share for reading."""
    return f"{100.0 * share:.2g} %"


def listed(values: Iterable[float], how: str = "g") -> str:
    """Numbers in a sentence."""
    return ", ".join(f"{value:{how}}" for value in values)


def statement_rows(statements: Sequence[Statement]) -> list[Row]:
    """The table of statements, numbered in their order."""
    return [
        {
            "no.": k,
            "the paper says": statement.says.rstrip("."),
            "verdict": f"**{statement.verdict}**",
            "what we find": statement.found[:1].upper() + statement.found[1:],
            "tested at": statement.accuracy,
            "command": f"`python run.py {statement.command}`",
        }
        for k, statement in enumerate(statements, 1)
    ]


def prose(text: str) -> str:
    """A paragraph that is written over several lines, as one."""
    return " ".join(text.split())


def paragraphs(text: str) -> list[str]:
    """Paragraphs, between which there are empty lines."""
    return [prose(one) for one in text.split("\n\n")]
