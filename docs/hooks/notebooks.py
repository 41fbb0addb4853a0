"""Notebooks as pages: run while the site is built, with their outputs below their cells."""

import base64
import re
from pathlib import Path
from typing import Any

import nbformat
from mkdocs.config.defaults import MkDocsConfig
from mkdocs.structure.files import File, Files
from nbclient import NotebookClient

COLOURS = re.compile("\x1b\\[[0-9;]*m")  # of a terminal
TIMEOUT_S = 600  # of a cell, which may compile


def on_files(files: Files, config: MkDocsConfig) -> Files:
    """Add a page for every notebook, and the pictures that it draws."""
    for path in sorted(Path(config.docs_dir).glob("*.ipynb")):
        notebook = nbformat.read(path, as_version=4)
        NotebookClient(notebook, timeout=TIMEOUT_S, kernel_name="python3").execute()
        pictures: dict[str, bytes] = {}
        page = "\n\n".join(cell_text(cell, path.stem, pictures) for cell in notebook.cells)
        files.append(File.generated(config, f"{path.stem}.md", content=page))
        for name, picture in pictures.items():
            files.append(File.generated(config, name, content=picture))
    return files


def cell_text(cell: Any, stem: str, pictures: dict[str, bytes]) -> str:
    """Markdown of a cell; what it draws is added to ``pictures``."""
    if cell.cell_type == "markdown":
        return str(cell.source)
    parts, text = [fenced("python", cell.source)], ""
    for output in cell.outputs:
        picture = output.get("data", {}).get("image/png")
        if picture is None:
            text += printed(output)
            continue
        name = f"{stem}-{len(pictures) + 1}.png"
        pictures[name] = base64.b64decode(picture)
        parts += [fenced("text", text), f"![{stem}, figure {len(pictures)}]({name})"]
        text = ""
    return "\n\n".join([*parts, fenced("text", text)])


def printed(output: Any) -> str:
    """The text of an output; warnings and progress are none of the page."""
    if output.output_type == "stream":
        return COLOURS.sub("", output.text) if output.name == "stdout" else ""
    return str(output.get("data", {}).get("text/plain", ""))


def fenced(language: str, text: str) -> str:
    """A block of code; nothing for no text."""
    return f"```{language}\n{text.rstrip()}\n```" if text else ""
