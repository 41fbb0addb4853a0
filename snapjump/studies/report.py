"""What a study leaves in its folder: each table as CSV and Markdown, figures, and report.md."""

import csv
import io
import math
from pathlib import Path
from typing import Any

from snapjump.files.atomic import write_text
from snapjump.files.json_file import finite
from snapjump.files.result_folder import ResultFolder
from snapjump.studies.base import Conclusion, Table
from snapjump.tasks.publish import BLOCK_SUFFIX, REPORT
from snapjump.terminal.block import markdown_table, number


def write_report(folder: ResultFolder, conclusion: Conclusion, draw: bool) -> None:
    """Write all of it; ``draw``: the figures as well."""
    for name, table in conclusion.tables.items():
        write_text(folder.path / f"{name}.csv", csv_text(table))
        write_text(folder.path / f"{name}.md", markdown(table) + "\n")
    for name, text in conclusion.blocks.items():
        write_text(folder.path / f"{name}{BLOCK_SUFFIX}", text.strip() + "\n")
    drawn = conclusion.figures if draw else {}

    def draw_all(path: Path) -> None:
        for name, figure in drawn.items():
            figure.draw(path / f"{name}.png")

    folder.write_figures(draw_all)
    parts = [f"# {conclusion.title}", *conclusion.findings]
    parts += [f"![{figure.caption}]({name}.png)\n\n{figure.caption}"
              for name, figure in drawn.items()]  # fmt: skip
    parts += [f"**{table.caption}**\n\n{markdown(table)}" for table in conclusion.tables.values()]
    write_text(folder.path / REPORT, "\n\n".join(parts) + "\n")


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
    rows, _ = finite(list(table.rows))
    file = io.StringIO()
    writer = csv.DictWriter(file, table.header, restval="", lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows)
    return file.getvalue()
