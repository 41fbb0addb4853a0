"""Plain text in columns: the closing block of a run and the table of a sweep."""

from collections.abc import Sequence


def heading_width(lines: Sequence[tuple[str, str]]) -> int:
    """The column at which the texts of a block begin, in its indented lines."""
    return max((len(heading) for heading, _ in lines[1:]), default=0) + 2


def block(lines: Sequence[tuple[str, str]], width: int | None = None) -> str:
    """A title, then indented lines of a heading and its text; the first pair is the title."""
    (name, title), *rest = lines
    width = heading_width(lines) if width is None else width
    return "\n".join(
        [f"{name}  {title}".rstrip()]
        + [f"  {heading.ljust(width)}{text}" for heading, text in rest if text]
    )


def table(header: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """Left-aligned columns under a header."""
    widths = [max(len(row[i]) for row in [header, *rows]) for i in range(len(header))]
    lines = [
        "  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)).rstrip()
        for row in [header, ["-" * width for width in widths], *rows]
    ]
    return "\n".join(lines)


def markdown_table(header: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """A Markdown table."""
    lines = [list(header), ["---"] * len(header), *[list(row) for row in rows]]
    return "\n".join("| " + " | ".join(c.replace("|", "\\|") for c in row) + " |" for row in lines)


def number(value: object) -> str:
    """A value for reading: four significant digits."""
    if isinstance(value, bool) or value is None:
        return "" if value is None else str(value).lower()
    if isinstance(value, float):
        return f"{value:.4g}"
    return str(value)
