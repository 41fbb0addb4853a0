"""The report of a study: each table as CSV and Markdown, figures, report.md and report.html."""

import math
from pathlib import Path
from typing import Any

from snapjump.files.atomic import write_text
from snapjump.files.json_file import finite
from snapjump.files.page import page
from snapjump.files.result_folder import ResultFolder
from snapjump.run.studies.base import Conclusion, Section, Table
from snapjump.run.tasks.publish import BLOCK_SUFFIX, PAGE, REPORT
from snapjump.show.terminal.block import markdown_table, number


def write_report(folder: ResultFolder, conclusion: Conclusion, draw: bool) -> None:
    """Write all of it; ``draw``: the figures as well."""
    top = Section(conclusion.title, conclusion.findings, conclusion.figures, conclusion.tables)
    sections = [top, *conclusion.sections]
    for section in sections:
        for name, table in section.tables.items():
            write_text(folder.path / f"{name}.csv", csv_text(table))
            write_text(folder.path / f"{name}.md", markdown(table) + "\n")
    for name, text in conclusion.blocks.items():
        write_text(folder.path / f"{name}{BLOCK_SUFFIX}", text.strip() + "\n")

    def draw_all(path: Path) -> None:
        for section in sections:
            for name, figure in section.figures.items():
                figure.draw(path / f"{name}.png")

    draw = draw and folder.write_figures(draw_all)
    parts = [part for k, section in enumerate(sections) for part in _told(section, k > 0, draw)]
    text = "\n\n".join(parts) + "\n"
    write_text(folder.path / REPORT, text)
    write_text(folder.path / PAGE, page(conclusion.title, text, folder.path))


def _told(section: Section, below: bool, draw: bool) -> list[str]:
    """The section's pieces of Markdown."""
    told = [f"#{'#' * below} {section.title}", *section.paragraphs]
    if draw:
        told += [
            f"![{figure.caption}]({name}.png)\n\n{figure.caption}"
            for name, figure in section.figures.items()
        ]
    return told + [f"**{table.caption}**\n\n{markdown(table)}" for table in section.tables.values()]


def markdown(table: Table) -> str:
    """The table for reading: four significant digits, and nothing where there is no number."""

    def text(key: str, value: Any) -> str:
        if isinstance(value, float):
            return "" if not math.isfinite(value) else f"{value:.{table.digits.get(key, 4)}g}"
        return number(value)

    if not table.rows:
        return "None."
    header = table.header
    rows = [[text(key, row.get(key)) for key in header] for row in table.rows]
    return markdown_table(header, rows)


def csv_text(table: Table) -> str:
    """The table with all digits, and nothing where there is no finite number."""
    if not table.rows:
        return ""
    import pandas as pd

    rows, _ = finite(list(table.rows))
    return str(pd.DataFrame(rows, columns=table.header, dtype=object).to_csv(index=False))
