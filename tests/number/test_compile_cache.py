import shutil

import pytest

from snapjump.number import compile_cache


@pytest.fixture
def copied(tmp_path, monkeypatch):
    """The package's sources in a folder of their own."""
    package = tmp_path / "snapjump"
    shutil.copytree(compile_cache.PACKAGE, package, ignore=shutil.ignore_patterns("__pycache__"))
    monkeypatch.setattr(compile_cache, "PACKAGE", package)
    return package


def test_folder_is_the_same_for_the_same_sources(copied, monkeypatch):
    copy = compile_cache.source_hash()
    monkeypatch.undo()
    assert copy == compile_cache.source_hash()


@pytest.mark.parametrize("package", compile_cache.KERNEL_PACKAGES)
def test_folder_changes_with_any_kernel_source(copied, package):
    before = compile_cache.cache_folder()
    with (copied / package / "base.py").open("a") as source:
        source.write("\nEDITED = True\n")
    assert compile_cache.cache_folder() != before


def test_folder_does_not_change_with_other_sources(copied):
    before = compile_cache.cache_folder()
    (copied / "plots" / "canvas.py").write_text("")
    assert compile_cache.cache_folder() == before


def test_folder_follows_the_environment(monkeypatch, tmp_path):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "xdg"))
    monkeypatch.delenv("NUMBA_CACHE_DIR", raising=False)
    assert compile_cache.cache_folder().parent == tmp_path / "xdg" / "snapjump"
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path / "own"))
    assert compile_cache.cache_folder().parent == tmp_path / "own"
