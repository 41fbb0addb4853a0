"""Where things lie in a clone and in a wheel, and that a clone's folder is no package."""

import os
import subprocess
import sys
from pathlib import Path

from command_line import ROOT

from snapjump.files import layout
from snapjump.files.sources import package_files


def test_a_clone_has_both_beside_the_package():
    assert not layout.INSTALLED and layout.CONF == ROOT / "conf"
    assert layout.EXPERIMENTS == ROOT / "experiments" and layout.PROGRAM == "python run.py"
    assert layout.importable("experiments.scenes.study") == "experiments.scenes.study"
    assert layout.in_a_clone("snapjump.experiments.scenes.study") == "experiments.scenes.study"
    assert layout.in_a_clone("snapjump.engine") == "snapjump.engine"


def test_a_wheel_has_them_within(monkeypatch):
    monkeypatch.setattr(layout, "INSTALLED", True)
    assert layout.importable("experiments.released.study") == "snapjump.experiments.released.study"
    assert layout.importable("snapjump.engine") == "snapjump.engine"


def test_what_a_wheel_has_within_is_no_source_of_results(monkeypatch):
    parts = {source.part for source in package_files()}
    assert "engine" in parts and not parts & {"conf", "experiments"}


def test_studies_import_each_other_relatively():
    for file in (ROOT / "experiments").rglob("*.py"):
        text = file.read_text(encoding="utf-8")
        assert "\nfrom experiments" not in text and "\nimport experiments" not in text, file


def test_beside_a_clone_the_package_is_found(tmp_path: Path):
    """A folder of that name, without an ``__init__.py``, would be taken for it."""
    (tmp_path / "snapjump").symlink_to(ROOT)
    code = "import snapjump; print(snapjump.Design().epsilon)"
    command = [sys.executable, "-c", code]
    bare = {key: value for key, value in os.environ.items() if key != "PYTHONPATH"}
    run = subprocess.run(command, capture_output=True, text=True, cwd=tmp_path, env=bare)
    assert run.stdout.split() == ["0.2"], run.stderr
