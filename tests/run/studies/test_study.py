"""A study does what is missing, survives a kill, and leaves tables, figures and a report."""

import json
import signal
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import pytest
from cells import run_study
from command_line import ROOT, python

from snapjump.checks import ParameterError
from snapjump.files.result_folder import ResultFolder
from snapjump.run.studies import study as module
from snapjump.run.studies.base import Cell, Conclusion, Done, Figure, Section, Table
from snapjump.run.studies.fingerprint import fingerprint, sources
from snapjump.run.studies.store import CellStore
from snapjump.run.studies.study import Study
from snapjump.run.tasks.execute import check_read
from snapjump.run.tasks.publish import replaced

CONFIG: dict[str, Any] = {
    "task": {"name": "squares", "cells": 3}, "effort": "quick", "figures": True, "seed": 0
}  # fmt: skip
PLACES = [str(Path(__file__).parent), str(ROOT / "tests" / "support")]
calls: list[str] = []


class Squares(Study):
    """Squares of numbers; the cell of 1 is refused if the test says so."""

    options = ("cells",)
    breaks: Exception | type[BaseException] | None = None

    def plan(self, config: Mapping[str, Any]) -> list[Cell]:
        return [Cell(f"{n} squared", {"n": n}) for n in range(config["task"]["cells"])]

    def compute(self, cell: Cell) -> list[dict[str, Any]]:
        calls.append(cell.name)
        if cell.inputs["n"] == 1 and self.breaks is not None:
            raise self.breaks
        return [{"n": cell.inputs["n"], "square": cell.inputs["n"] ** 2, "nan": float("nan")}]

    def conclude(self, done: Mapping[str, Done]) -> Conclusion:
        rows = [row for one in done.values() for row in one.rows]
        return Conclusion(
            title="Squares",
            findings=["They grow."],
            tables={
                "squares": Table("n and its square", rows, digits={"square": 2}),
                "nothing": Table("Nothing", []),
            },
            figures={"curve": Figure("A curve", lambda path: path.write_bytes(b"png"))},
            summary={"largest": max(row["square"] for row in rows), "none": float("nan")},
            metrics={"2 squared": {"error": 0.5, "unknown": float("nan")}},
            blocks={"tiers": "| squares |"},
            sections=[
                Section(
                    "Roots",
                    ["They are smaller."],
                    {"root": Figure("A root", lambda path: path.write_bytes(b"png"))},
                    {"roots": Table("Roots", [{"n": 4, "root": 2}])},
                )
            ],
        )


@pytest.fixture(autouse=True)
def empty_folder(tmp_path, monkeypatch) -> None:
    """Where studies put their cells, under a hash that does not change with sources."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(module, "fingerprint", lambda config, roots: "hash")
    calls.clear()


def run(name: str, breaks: Any = None) -> tuple[Any, ResultFolder]:
    squares = Squares()
    squares.breaks = breaks
    outcome, folder = run_study(squares, CONFIG, Path(name))
    return outcome, folder


def test_what_it_leaves():
    outcome, folder = run("first")
    assert outcome.status == "ok"
    assert outcome.summary["largest"] == 4 and outcome.summary["none"] is None
    assert outcome.summary["cells_ok"] == 3
    names = {file.name for file in folder.files()}
    assert {"squares.csv", "squares.md", "curve.png", "report.md", "tiers.block.md"} <= names
    assert (folder.path / "squares.csv").read_text().splitlines()[1] == "0,0,"
    assert (folder.path / "nothing.md").read_text() == "None.\n"
    assert (folder.path / "nothing.csv").read_text() == ""
    report = (folder.path / "report.md").read_text()
    assert report.startswith("# Squares\n\nThey grow.") and "![A curve](curve.png)" in report
    assert report.endswith("## Roots\n\nThey are smaller.\n\n![A root](root.png)\n\nA root\n\n"
                           "**Roots**\n\n| n | root |\n| --- | --- |\n| 4 | 2 |\n")  # fmt: skip
    assert {"roots.csv", "root.png", "report.html"} <= names
    html = (folder.path / "report.html").read_text()
    assert (
        "<h2>Roots</h2>" in html
        and '<img src="data:image/png;base64,cG5n"' in html
        and "<td>4</td>" in html
    )
    records = json.loads((folder.path / "children.json").read_text())["children"]
    assert [record["params"] for record in records] == [{"n": 0}, {"n": 1}, {"n": 2}]
    assert records[2]["metrics"] == {"n": 2.0, "square": 4.0, "error": 0.5}


def test_what_is_done_is_not_done_again():
    run("first")
    outcome, _ = run("second")
    assert len(calls) == 3
    assert outcome.summary["cells_kept"] == 3 and outcome.summary["largest"] == 4


def test_keys_that_only_choose_do_not_determine_cells(monkeypatch):
    asked: list[Any] = []
    monkeypatch.setattr(module, "fingerprint", lambda config, roots: asked.append(config) or "hash")
    monkeypatch.setattr(Squares, "choices", ("figures",))
    run("first")
    assert asked == [{key: value for key, value in CONFIG.items() if key != "figures"}]


def test_ctrl_c_keeps_finished_cells():
    with pytest.raises(KeyboardInterrupt):
        run("first", KeyboardInterrupt)
    outcome, _ = run("second")
    assert calls == ["0 squared", "1 squared", "1 squared", "2 squared"]
    assert outcome.summary["cells_kept"] == 1


def test_a_refused_cell_is_a_result():
    outcome, _ = run("first", ParameterError("frame", "fixed", "rigid"))
    assert outcome.status == "ok" and outcome.summary["cells_refused"] == 1
    run("second")
    assert calls.count("1 squared") == 1


def test_a_failed_cell_is_told_and_done_again():
    outcome, folder = run("first", ZeroDivisionError("by nought"))
    assert outcome.status == "cells_failed" and outcome.summary["cells_failed"] == 1
    assert "ZeroDivisionError: by nought" in (folder.path / "failures.txt").read_text()
    outcome, _ = run("second")
    assert outcome.status == "ok" and calls.count("1 squared") == 2


def test_a_key_that_the_study_does_not_have():
    config = {**CONFIG, "accuracy": {}, "task": {**CONFIG["task"], "foo": 1}}
    with pytest.raises(ParameterError, match=r"task.foo = 1 .* cells"):
        check_read(Squares(), config, [])


def test_only_one_process_at_a_time(tmp_path):
    with CellStore(tmp_path / "store"), pytest.raises(ParameterError, match="no other process"):
        CellStore(tmp_path / "store").__enter__()


def test_a_cell_with_other_inputs_is_another(tmp_path):
    store = CellStore(tmp_path)
    done = Done(Cell("a/b", {"n": 1}), "ok", "", [], "run", "", "")
    store.save(done)
    assert store.load(Cell("a/b", {"n": 1})) == done
    assert store.load(Cell("a/b", {"n": 2})) is None


@pytest.mark.parametrize("damage", ["{}", "[]", '{"status": "ok"}', "[" * 100_000, "\0"])
def test_a_cell_of_something_else_is_done_again(tmp_path, capsys, damage):
    store = CellStore(tmp_path)
    done = Done(Cell("a", {"n": 1}), "ok", "", [{"x": 2.0}], "run", "", "")
    store.save(done)
    store.file(done.cell).write_text(damage)
    assert store.load(done.cell) is None
    assert (
        capsys.readouterr().err == f"done again: {store.file(done.cell)} is not what was written\n"
    )


def test_an_edited_number_counts_for_nothing(tmp_path):
    store = CellStore(tmp_path)
    done = Done(Cell("a", {"n": 1}), "ok", "", [{"x": 2.0}], "run", "", "")
    store.save(done)
    file = store.file(done.cell)
    file.write_text(file.read_text().replace("2.0", "3.0"))
    assert store.load(done.cell) is None


def test_what_cells_read_is_what_a_study_reads():
    one, other = Squares().reads(CONFIG), Squares().reads(CONFIG)
    assert one == other and one.keys() == {"cells"}


def test_a_killed_study_leaves_whole_cells_and_no_lock(tmp_path):
    script = (
        f"import os, signal, sys; sys.path[:0] = {PLACES!r}\n"
        "import test_study as t; from pathlib import Path\n"
        "t.module.fingerprint = lambda config, roots: 'hash'\n"
        "class Killed(t.Squares):\n"
        "    def compute(self, cell):\n"
        "        if cell.inputs['n'] == 2: os.kill(os.getpid(), signal.SIGKILL)\n"
        "        return super().compute(cell)\n"
        "t.run_study(Killed(), t.CONFIG, Path('first'))\n"
    )
    python("-c", script, folder=tmp_path, code=-signal.SIGKILL)
    outcome, _ = run("second")
    assert calls == ["2 squared"] and outcome.summary["cells_kept"] == 2


def test_the_folder_s_name_tells_what_determines_the_cells():
    roots = ["experiments.speed"]
    name = fingerprint(CONFIG, roots)
    assert fingerprint({**CONFIG, "tracking": {"name": "off"}, "publish": "x"}, roots) == name
    assert fingerprint({**CONFIG, "seed": 1}, roots) != name
    assert fingerprint(CONFIG, ["experiments.designs"]) != name
    names = {source.name for source in sources(roots)}
    assert names >= {"experiments.speed", "experiments.designs"}


def test_only_what_is_between_the_markers_is_replaced():
    text = "a\n<!-- t:begin -->\nold\n<!-- t:end -->\nz\n"
    assert replaced(text, "t", "new\n") == "a\n<!-- t:begin -->\nnew\n<!-- t:end -->\nz\n"
    assert replaced(text, "other", "new") is None
