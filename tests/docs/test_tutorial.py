"""The tutorial runs from beginning to end, and is kept without outputs."""

import nbformat
import pytest
from command_line import ROOT
from nbclient import NotebookClient

TUTORIAL = ROOT / "docs" / "tutorial.ipynb"
TIMEOUT_S = 300  # of a cell, which may compile


@pytest.fixture
def tutorial() -> nbformat.NotebookNode:
    return nbformat.read(TUTORIAL, as_version=4)


def test_no_outputs_are_kept(tutorial):
    nbformat.validate(tutorial)
    code = [cell for cell in tutorial.cells if cell.cell_type == "code"]
    assert code
    assert all(not cell.outputs and cell.execution_count is None for cell in code)


@pytest.mark.compiles
def test_every_cell_runs(tutorial, tmp_path):
    resources = {"metadata": {"path": str(tmp_path)}}
    NotebookClient(
        tutorial, timeout=TIMEOUT_S, kernel_name="python3", resources=resources
    ).execute()
    assert not list(tmp_path.iterdir())
    outputs = [out for cell in tutorial.cells for out in cell.get("outputs", [])]
    assert sum("image/png" in out.get("data", {}) for out in outputs) == 5
    printed = "".join(out.text for out in outputs if out.get("name") == "stdout")
    assert "nan" not in printed.lower()
