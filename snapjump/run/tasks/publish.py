"""Filling the documentation from a run: ``publish=docs/studies`` writes ``<task>.md`` there."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from snapjump.checks import ParameterError, check_text
from snapjump.files.atomic import write_bytes, write_text
from snapjump.files.result_folder import ResultFolder
from snapjump.run.tasks.registry import is_study

REPORT, PAGE = "report.md", "report.html"
BLOCK_SUFFIX = ".block.md"
README, GUIDES = Path("README.md"), "docs/*.md"


def check_publish(config: Mapping[str, Any]) -> None:
    """Raise ParameterError for a folder that cannot be one, or a task that has no report."""
    target, task = config["publish"], config["task"].get("name")
    if target is None:
        return
    check_text("publish", target, "null, or a folder such as docs/studies")
    if Path(target).exists() and not Path(target).is_dir():
        raise ParameterError("publish", target, "a folder, and this is a file")
    if not is_study(task):
        raise ParameterError("publish", target, f"null with task={task}, which is no study")


def publish(config: Mapping[str, Any], folder: ResultFolder) -> list[Path]:
    """Copy report and figures of a study, with the command that made them; what was written.

    Sections of README.md and of the guides that the study has text for are replaced, where they
    have its markers.
    """
    target, task = Path(config["publish"]), config["task"]["name"]
    target.mkdir(parents=True, exist_ok=True)
    origin = folder.provenance() or {}
    title, _, rest = (folder.path / REPORT).read_text(encoding="utf-8").partition("\n")
    revision = str(origin.get("git_revision"))[:10] + (" and changes" * bool(origin["git_dirty"]))
    machine = origin["machine"]["processor"]
    made = f"`{origin['command']}`\n\nRevision {revision}, {origin['finished_at'][:10]}, {machine}."
    written = []
    for picture in sorted(folder.path.glob("*.png")):
        rest = rest.replace(f"({picture.name})", f"({task}-{picture.name})")
        written.append(target / f"{task}-{picture.name}")
        write_bytes(written[-1], picture.read_bytes())
    written.append(target / f"{task}.md")
    write_text(written[-1], f"{title}\n\n{made}\n{rest}")
    for block in sorted(folder.path.glob(f"*{BLOCK_SUFFIX}")):
        name, content = block.name.removesuffix(BLOCK_SUFFIX), block.read_text(encoding="utf-8")
        for place in (README, *sorted(README.parent.glob(GUIDES))):
            before = place.read_text(encoding="utf-8") if place.exists() else ""
            after = replaced(before, name, content)
            if after is not None:
                write_text(place, after)
                written.append(place)
    return written


def replaced(text: str, name: str, content: str) -> str | None:
    """The text with other content between the markers of that name; None if it lacks them."""
    begin, end = f"<!-- {name}:begin -->", f"<!-- {name}:end -->"
    head, opened, tail = text.partition(begin)
    _, closed, foot = tail.partition(end)
    if not opened or not closed:
        return None
    return f"{head}{begin}\n{content.strip()}\n{end}{foot}"
