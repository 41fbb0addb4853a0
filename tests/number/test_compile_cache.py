import shutil

import pytest
from command_line import python
from numba import njit

from snapjump.files import sources
from snapjump.number import compile_cache


@pytest.fixture
def copied(tmp_path, monkeypatch):
    """The package's sources in a folder of their own."""
    package = tmp_path / "snapjump"
    shutil.copytree(sources.PACKAGE, package, ignore=shutil.ignore_patterns("__pycache__"))
    monkeypatch.setattr(sources, "PACKAGE", package)
    return package


def edit(file):
    with file.open("a") as source:
        source.write("\nEDITED = True\n")


def test_folder_is_the_same_for_the_same_sources(copied, monkeypatch):
    copy = compile_cache.source_hash()
    monkeypatch.undo()
    assert copy == compile_cache.source_hash()


@pytest.mark.parametrize("package", compile_cache.KERNEL_PACKAGES)
def test_folder_changes_with_any_kernel_source(copied, package):
    before = compile_cache.cache_folder()
    edit(copied / package / "base.py")
    sources.forget(copied)
    assert compile_cache.cache_folder() != before


def test_folder_does_not_change_with_other_sources(copied):
    before = compile_cache.cache_folder()
    (copied / "show" / "plots" / "canvas.py").write_text("")
    sources.forget(copied)
    assert compile_cache.cache_folder() == before


def test_folder_follows_the_environment(monkeypatch, tmp_path):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "xdg"))
    monkeypatch.delenv("NUMBA_CACHE_DIR", raising=False)
    assert compile_cache.cache_folder().parent == tmp_path / "xdg" / "snapjump"
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path / "own"))
    assert compile_cache.cache_folder().parent == tmp_path / "own"


# The smallest kernel that is kept, compiled by the package in the current folder.
COMPILE = """
from pathlib import Path
from snapjump.statics.resting_gap import resting_gap
from snapjump.contact.logbarrier import LogBarrier
from snapjump.number.dispatch import refresh
from snapjump.files.sources import PACKAGE, PLUGINS
assert str(PACKAGE.parent) == {root!r}, PACKAGE
PLUGINS.extend(Path(place) for place in {plugins!r})
refresh()
resting_gap(LogBarrier.Law(1.0, 1.0, 1.0), 1.0, 1.0)
print(sum(resting_gap.stats.cache_hits.values()), sum(resting_gap.stats.cache_misses.values()))
"""


def compiled_in(root, cache, *plugins):
    """How often the kernel was found and not found by the package there."""
    program = COMPILE.format(root=str(root), plugins=plugins)
    places = {"NUMBA_CACHE_DIR": str(cache), "PYTHONPATH": str(root)}
    done = python("-c", program, folder=root, **places)
    return tuple(int(count) for count in done.stdout.split())


def test_a_copy_finds_what_was_compiled_and_an_edited_one_does_not(copied, tmp_path):
    cache, elsewhere = tmp_path / "cache", tmp_path / "elsewhere"
    shutil.copytree(copied, elsewhere / "snapjump")  # with other dates
    assert compiled_in(tmp_path, cache) == (0, 1)
    assert compiled_in(elsewhere, cache) == (1, 0)
    # Words, and the kernel some lines below where it was.
    kernel = elsewhere / "snapjump" / "statics" / "resting_gap.py"
    text = kernel.read_text().replace("By bisection", "By halving intervals")
    kernel.write_text(text.replace("@compiled", "# A comment.\n\n@compiled"))
    assert compiled_in(elsewhere, cache) == (1, 0)
    # A function that the kernel calls, in a file of its own.
    edit(elsewhere / "snapjump" / "contact" / "logbarrier.py")
    assert compiled_in(elsewhere, cache) == (0, 1)


def test_programs_follow_the_plugins(tmp_path):
    plugin = tmp_path / "mine" / "contact"
    plugin.mkdir(parents=True)
    (plugin / "law.py").write_text("STIFFNESS = 1.0\n")
    root, cache = sources.PACKAGE.parent, tmp_path / "cache"
    assert compiled_in(root, cache, str(plugin.parent)) == (0, 1)
    assert compiled_in(root, cache) == (0, 1)
    assert len(list(cache.glob("kernels-*"))) == 2


def test_functions_of_others_are_left_to_numba():
    assert compile_cache.KernelLocator.from_function(compiled_in, __file__) is None
    # They share a name, and only their lines tell them apart.
    inner = (lambda: lambda: None)()
    place = str(sources.PACKAGE / "statics" / "resting_gap.py")
    assert compile_cache.KernelLocator.from_function(inner, place) is None

    @njit(cache=True)
    def other(x):
        return x + 1

    assert other(1) == 2
