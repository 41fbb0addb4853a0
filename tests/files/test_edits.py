"""What an edited source makes anew: kernels, datasets and cells of studies; and what it leaves."""

import shutil
from pathlib import Path

import pytest
from small_datasets import small

from snapjump.files import sources
from snapjump.number.compile_cache import cache_folder
from snapjump.run.studies.fingerprint import fingerprint

STUDY = "made_up_study"
LAW = '"""A law."""\n\nSTIFFNESS = 2.0\n'
TABLEAU = "# A method.\nname: mine\nrows: [[0.0], [0.0, 1.0]]\n"
ALL = {"kernels", "dataset", "study"}


@pytest.fixture
def copied_sources(tmp_path, monkeypatch):
    """The package's sources, a study's module and plug-ins in folders of their own."""
    kept = shutil.ignore_patterns("__pycache__")
    shutil.copytree(sources.PACKAGE, tmp_path / "snapjump", ignore=kept)
    (tmp_path / f"{STUDY}.py").write_text('"""A study."""\nCELLS = 3\n')
    put_plugins(tmp_path / "plugins")
    monkeypatch.setattr(sources, "PACKAGE", tmp_path / "snapjump")
    monkeypatch.setattr(sources, "PLUGINS", [tmp_path / "plugins"])
    monkeypatch.syspath_prepend(tmp_path)
    return tmp_path


def put_plugins(place: Path) -> None:
    for name, text in (("contact/mine.py", LAW), ("integrator/mine.yaml", TABLEAU)):
        (place / name).parent.mkdir(parents=True)
        (place / name).write_text(text)


def edit(file: Path, old: str, new: str) -> None:
    """Edit a file as if a new process had found it so."""
    text = file.read_text()
    assert old in text
    file.write_text(text.replace(old, new, 1))
    sources.forget(file)


def names() -> dict[str, str]:
    return {
        "kernels": cache_folder().name,
        "dataset": small().plain["source_sha256"],
        "study": fingerprint({}, [STUDY]),
    }


EDITS = {
    "snapjump/contact/logbarrier.py": (
        ('"""Logarithmic barrier', '# Why.\n"""The logarithmic barrier', set()),
        ("def keeps_open", "# always\n\n        def keeps_open", set()),
        ("return True", "return False", ALL),
    ),
    "snapjump/statics/resting_gap.py": (("HALVINGS = 60", "HALVINGS = 61", ALL),),
    "snapjump/scenes/runner.py": (
        ('"""', '"""Yes: ', set()),
        ("MOST_ITERATIONS = ", "MOST_ITERATIONS = 1 + ", ALL - {"kernels"}),
    ),
    "snapjump/inverse/base.py": (("import", "import os\nimport", {"study"}),),
    "snapjump/show/plots/canvas.py": (("import", "import os\nimport", set()),),
    "snapjump/integrator/sdirk2.yaml": (
        ("# Second order", "# An order of two", set()),
        ("order: 2", "order: 3", ALL - {"kernels"}),
    ),
    f"{STUDY}.py": (("A study", "Cells", set()), ("3", "4", {"study"})),
    "plugins/contact/mine.py": (("A law", "Mine", set()), ("2.0", "2.5", ALL)),
    "plugins/integrator/mine.yaml": (
        ("A method", "Mine", set()),
        ("1.0", "0.5", ALL - {"kernels"}),
    ),
}


@pytest.mark.parametrize("file", EDITS)
def test_what_an_edit_changes(copied_sources, file):
    for old, new, changed in EDITS[file]:
        before = names()
        edit(copied_sources / file, old, new)
        after = names()
        assert {key for key in ALL if before[key] != after[key]} == changed, (old, new)


def test_plugins_count_as_they_are_and_wherever_they_lie(copied_sources, monkeypatch):
    place, elsewhere, with_them = copied_sources / "plugins", copied_sources / "elsewhere", names()
    put_plugins(elsewhere)
    monkeypatch.setattr(sources, "PLUGINS", [elsewhere])
    assert names() == with_them
    for plugins in ([elsewhere, place], [], [place]):
        if plugins == [place]:
            (place / "contact" / "mine.py").rename(place / "contact" / "yours.py")
        monkeypatch.setattr(sources, "PLUGINS", plugins)
        assert all(names()[key] != with_them[key] for key in ALL)


def test_a_process_stays_with_what_it_has_imported(copied_sources):
    before = names()
    law = copied_sources / "snapjump" / "contact" / "logbarrier.py"
    law.write_text(law.read_text() + "EDITED = 1\n")
    assert names() == before
    sources.forget(copied_sources / "snapjump")
    assert names() != before
