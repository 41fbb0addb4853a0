"""The revision that is recorded is the code's own, or none."""

import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from snapjump.files import provenance
from snapjump.files.sources import PACKAGE


def commit(folder: Path) -> None:
    """A repository of somebody else's, with one commit of all that is there."""
    author = ("-c", "user.name=other", "-c", "user.email=other@example.org")
    for words in (("init", "-q"), ("add", "-f", "."), (*author, "commit", "-qm", "other")):
        subprocess.run(["git", "-C", str(folder), *words], check=True)


@pytest.fixture
def other(tmp_path: Path) -> Path:
    (tmp_path / "README").write_text("another project")
    commit(tmp_path)
    return tmp_path


def test_variables_that_name_another_repository_mean_nothing(other, monkeypatch):
    provenance.git_state.cache_clear()
    ours = provenance.git_state()
    monkeypatch.setenv("GIT_DIR", str(other / ".git"))
    monkeypatch.setenv("GIT_WORK_TREE", str(other))
    provenance.git_state.cache_clear()
    assert provenance.git_state() == ours


@pytest.mark.parametrize("tracked", [False, True])
def test_installed_within_another_repository_there_is_no_revision(other, tracked):
    site = other / "site-packages"
    left_out = shutil.ignore_patterns("__pycache__", "*.safetensors")
    shutil.copytree(PACKAGE, site / "snapjump", ignore=left_out)
    if tracked:
        commit(other)
    code = "from snapjump.files.provenance import git_state; print(git_state())"
    done = subprocess.run([sys.executable, "-c", code], cwd=site, capture_output=True, text=True)
    assert done.stdout == "{'git_revision': None, 'git_dirty': None}\n", done.stderr
