import errno
import shutil

import numba
import pytest
from command_line import python
from numba.core.caching import FunctionCache, NullCache

from snapjump.files import sources
from snapjump.number import compile_cache
from snapjump.number.dispatch import compiled
from snapjump.statics.resting_gap import resting_gap


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
    return tuple(int(count) for count in python_of(root, cache, *plugins).stdout.split())


def python_of(root, cache, *plugins):
    """The process that does so."""
    program = COMPILE.format(root=str(root), plugins=plugins)
    places = {"NUMBA_CACHE_DIR": str(cache), "PYTHONPATH": str(root)}
    return python("-c", program, folder=root, **places)


@pytest.mark.processes
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


@pytest.mark.processes
def test_programs_follow_the_plugins(tmp_path):
    plugin = tmp_path / "mine" / "contact"
    plugin.mkdir(parents=True)
    (plugin / "law.py").write_text("STIFFNESS = 1.0\n")
    root, cache = sources.PACKAGE.parent, tmp_path / "cache"
    assert compiled_in(root, cache, str(plugin.parent)) == (0, 1)
    assert compiled_in(root, cache) == (0, 1)
    assert len(list(cache.glob("kernels-*"))) == 2


def test_kernels_of_others_are_not_kept():
    assert isinstance(compiled(compiled_in)._cache, NullCache)
    assert numba.config.CACHE_DIR == "" and numba.config.CACHE_LOCATOR_CLASSES == ""


SAY = "warning: compiled kernels are not kept in"


@pytest.mark.processes
def test_where_no_kernel_can_be_kept_each_process_compiles(copied, tmp_path):
    """numba would keep them beside the sources, and find them there after an edit elsewhere."""
    nowhere = tmp_path / "file" / "below"
    nowhere.parent.write_text("")
    for _ in range(2):
        done = python_of(tmp_path, nowhere)
        assert done.stdout.split() == ["0", "1"]
        assert done.stderr.count(SAY) == 1 and str(nowhere) in done.stderr
    assert not list(copied.rglob("*.nbi"))


def test_a_full_disk_is_a_warning(monkeypatch, capsys):
    def full(self, sig, data):
        raise OSError(errno.ENOSPC, "No space left on device")

    cache = compile_cache.kernel_cache(resting_gap.py_func)
    monkeypatch.setattr(FunctionCache, "save_overload", full)
    for _ in range(2):
        cache.save_overload(None, None)
    assert capsys.readouterr().err.count(f"{SAY} {compile_cache.folder_in_use()} (No space") == 1


@pytest.mark.processes
@pytest.mark.parametrize("suffix", [".nbi", ".nbc"])
def test_a_damaged_kernel_is_compiled_anew(copied, tmp_path, suffix):
    cache = tmp_path / "cache"
    assert compiled_in(tmp_path, cache) == (0, 1)
    (file,) = cache.rglob(f"*{suffix}")
    file.write_bytes(file.read_bytes()[:100])
    assert compiled_in(tmp_path, cache) == (0, 1)
    assert compiled_in(tmp_path, cache) == (1, 0)
