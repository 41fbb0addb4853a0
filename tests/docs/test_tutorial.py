"""The notebooks run from beginning to end, and are kept without outputs."""

import re
from typing import Any

import nbformat
import pytest
from command_line import ROOT
from nbclient import NotebookClient

PICTURES = {"tutorial": 5, "walk": 3}
TIMEOUT_S = 300  # of a cell, which may compile


def notebook(name: str) -> Any:
    return nbformat.read(ROOT / "docs" / f"{name}.ipynb", as_version=4)


def test_all_are_tested():
    assert {path.stem for path in (ROOT / "docs").glob("*.ipynb")} == {*PICTURES}


@pytest.mark.parametrize("name", PICTURES)
def test_no_outputs_are_kept(name):
    found = notebook(name)
    nbformat.validate(found)
    code = [cell for cell in found.cells if cell.cell_type == "code"]
    assert code
    assert all(not cell.outputs and cell.execution_count is None for cell in code)


# .ci/run walks the same way by experiments.stranger.
RUN = ["tutorial", pytest.param("walk", marks=pytest.mark.slow)]


@pytest.mark.compiles
@pytest.mark.parametrize("name", RUN)
def test_every_cell_runs(name, tmp_path):
    found = notebook(name)
    resources = {"metadata": {"path": str(tmp_path)}}
    NotebookClient(found, timeout=TIMEOUT_S, kernel_name="python3", resources=resources).execute()
    assert not list(tmp_path.iterdir())
    outputs = [out for cell in found.cells for out in cell.get("outputs", [])]
    assert sum("image/png" in out.get("data", {}) for out in outputs) == PICTURES[name]
    printed = "".join(out.text for out in outputs if out.get("name") == "stdout")
    assert not re.search(r"\bnan\b|Traceback", printed, re.IGNORECASE)
    assert "is not allowed" not in printed
