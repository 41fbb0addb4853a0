"""Filling the documentation from the folder of a run."""

from pathlib import Path
from typing import Any

import pytest

from snapjump.checks import ParameterError
from snapjump.files.result_folder import ResultFolder
from snapjump.run.tasks.publish import check_publish, publish

CONFIG: dict[str, Any] = {"task": {"name": "tradeoff"}, "publish": "docs/studies"}
README = "before\n<!-- tiers:begin -->\nold\n<!-- tiers:end -->\nafter\n"


@pytest.fixture
def finished_run(tmp_path, monkeypatch) -> ResultFolder:
    """The folder of a study that is done, below an empty folder where commands run."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "run").mkdir()
    folder = ResultFolder(tmp_path / "run")
    (folder.path / "report.md").write_text("# Title\n\nText.\n\n![what](front.png)\n")
    (folder.path / "front.png").write_bytes(b"png")
    (folder.path / "tiers.block.md").write_text("| new |\n")
    folder.write_provenance(
        {
            "command": "python run.py task=tradeoff",
            "git_revision": "0123456789abcdef",
            "git_dirty": True,
            "finished_at": "2026-01-02T03:04:05+00:00",
            "machine": {"processor": "A processor"},
        }
    )
    return folder


def test_report_figures_and_section_of_the_readme(finished_run):
    Path("README.md").write_text(README)
    publish(CONFIG, finished_run)
    page = Path("docs/studies/tradeoff.md").read_text()
    assert page.startswith("# Title\n\n`python run.py task=tradeoff`\n\nRevision 0123456789 and")
    assert "2026-01-02, A processor." in page and "![what](tradeoff-front.png)" in page
    assert Path("docs/studies/tradeoff-front.png").read_bytes() == b"png"
    assert not list(Path("docs").rglob("*.html")), "the site makes its own pages of it"
    assert Path("README.md").read_text() == README.replace("old", "| new |")


def test_sections_of_guides(finished_run):
    Path("docs").mkdir()
    Path("docs/guide.md").write_text(README)
    assert Path("docs/guide.md") in publish(CONFIG, finished_run)
    assert Path("docs/guide.md").read_text() == README.replace("old", "| new |")


def test_a_readme_without_markers_stays_as_it_is(finished_run):
    Path("README.md").write_text("nothing\n")
    assert Path("README.md") not in publish(CONFIG, finished_run)
    assert Path("README.md").read_text() == "nothing\n"


@pytest.mark.parametrize("target", [3, "", "run/report.md"])
def test_what_cannot_be_a_folder(finished_run, target):
    with pytest.raises(ParameterError, match="publish = "):
        check_publish({**CONFIG, "publish": target})


def test_one_simulation_has_no_report():
    with pytest.raises(ParameterError, match="task=simulate, which is no study"):
        check_publish({"task": {"name": "simulate"}, "publish": "docs"})
