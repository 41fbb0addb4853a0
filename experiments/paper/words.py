"""The words of a part, in ``words.md`` beside it: a text under each heading, filled with values."""

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from pathlib import Path
from types import MappingProxyType
from typing import Any

from snapjump.run.studies.base import Figure, Row, Section, Table

from .base import Statement, paragraphs, prose


class Words:
    """Texts by heading; ``str.format`` fills them, so that ``{row[mae_bar]:.2g}`` is an item and
    ``{law.slope:.2g}`` an attribute of a value.

    A statement has three: ``# <name>: says``, ``# <name>: found`` and ``# <name>: accuracy``, the
    last from ``# accuracy`` if it has none of its own. A section has ``# text``, and a caption for
    each figure and table, ``# caption <name>.png`` and ``# caption <name>``.
    """

    def __init__(self, module: str):
        """The texts beside a module, given by its ``__file__``."""
        self.file = Path(module).with_name("words.md")
        text = self.file.read_text(encoding="utf-8")
        _, *found = re.split(r"^# (.+)\n", text, flags=re.MULTILINE)
        self.texts = dict(zip(found[::2], found[1::2], strict=True))

    def filled(self, heading: str, values: Mapping[str, Any]) -> str:
        """A text with its values; an error that names file and heading if one is missing."""
        if heading not in self.texts:
            raise KeyError(f"{self.file} has no heading '# {heading}'")
        try:
            return self.texts[heading].strip().format(**values)
        except (LookupError, AttributeError, TypeError, ValueError) as error:
            raise ValueError(f"{self.file}, '# {heading}': {error!r}") from error

    def __call__(self, heading: str, /, **values: Any) -> str:
        """A text as one paragraph."""
        return prose(self.filled(heading, values))

    def paragraphs(self, heading: str, /, **values: Any) -> list[str]:
        """A text of several paragraphs; one that is but an empty value is none."""
        return paragraphs(self.filled(heading, values))

    def each(self, heading: str, values: Iterable[Mapping[str, Any]], between: str = "; ") -> str:
        """A text filled again and again, in a sentence."""
        return between.join(self(heading, **one) for one in values)

    def statement(self, name: str, came: str, /, **values: Any) -> Statement:
        """A statement of this part with its verdict."""
        own = f"{name}: accuracy"
        headings = f"{name}: says", f"{name}: found", own if own in self.texts else "accuracy"
        says, found, accuracy = (self(heading, **values) for heading in headings)
        return Statement(f"{self.file.parent.name}.{name}", says, came, found, accuracy)

    def section(
        self,
        title: str,
        figures: Mapping[str, Callable[[Path], Any]],
        tables: Mapping[str, Sequence[Row]],
        digits: Mapping[str, Mapping[str, int]] = MappingProxyType({}),
        /,
        **values: Any,
    ) -> Section:
        """A part's section; digits: of tables, for reading; values: of its text and captions."""

        def caption(name: str) -> str:
            return self(f"caption {name}", **values)

        return Section(
            title,
            self.paragraphs("text", **values),
            {name: Figure(caption(f"{name}.png"), draw) for name, draw in figures.items()},
            {name: Table(caption(name), rows, digits.get(name, {}))
             for name, rows in tables.items()},
        )  # fmt: skip
