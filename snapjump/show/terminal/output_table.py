"""The tables of docs/outputs.md: outputs, from their declarations, and statuses."""

from collections.abc import Mapping

from snapjump.batch.loads import LoadedBatch
from snapjump.declare.members import member_class, member_names
from snapjump.declare.outputs import Outputs
from snapjump.engine.status import NAMES, REASONS
from snapjump.show.terminal.block import markdown_table

HEADER = ("name", "unit", "what it is", "of", "only if")


def output_table() -> str:
    """Markdown: a row for each output, and the scenes (and batches) that have it."""
    owners: Mapping[str, type[Outputs]] = {
        **{name: member_class("sim", name)().outputs for name in member_names("sim")},
        "batch": LoadedBatch,
    }
    found: dict[tuple[str, ...], list[str]] = {}
    for scene, kind in owners.items():
        for each in kind.declared():
            known = " or ".join(f"`{status}`" for status in each.of)
            row = (f"`{each.name}`", each.unit, each.meaning, known)
            asked = scene == "batch" and each.reads
            found.setdefault(row, []).append(f"{scene} if asked" if asked else scene)
    rows = [
        (name, unit, meaning, "all" if len(scenes) == len(owners) else ", ".join(scenes), known)
        for (name, unit, meaning, known), scenes in found.items()
    ]
    return markdown_table(HEADER, rows) + "\n"


def status_table() -> str:
    """Markdown: a row for each status and what it means."""
    rows = [(f"`{name}`", REASONS[code] or "it ended as it should") for code, name in NAMES.items()]
    return markdown_table(("status", "what it means"), rows) + "\n"
