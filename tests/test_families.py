"""Families of kernels: every member fulfils its contract, and every option becomes a member."""

import importlib
import pkgutil
from pathlib import Path

import pytest

import snapjump
from snapjump.families import DATASET_FAMILIES, FAMILIES
from snapjump.number.compile_cache import KERNEL_PACKAGES

PACKAGE = Path(snapjump.__file__).parent


def is_declaration(value):
    return callable(value) and hasattr(value, "versions")


def contracts():
    """(folder, its modules, the functions its base declares) of every family of kernels."""
    for base in sorted(PACKAGE.glob("*/base.py")):
        folder = base.parent.name
        package = importlib.import_module(f"snapjump.{folder}")
        modules = {
            info.name: importlib.import_module(f"snapjump.{folder}.{info.name}")
            for info in pkgutil.iter_modules(package.__path__)
        }
        declared = {
            name: value
            for name, value in vars(modules["base"]).items()
            if is_declaration(value) and value.__module__ == modules["base"].__name__
        }
        if declared:
            yield folder, modules, declared


def members_of(declared):
    """Classes that fulfil a contract, those that other tests made up left out."""
    found = set().union(*(function.versions for function in declared.values()))
    return {member for member in found if member.__module__.startswith("snapjump.")}


CONTRACTS = list(contracts())
FOLDERS = [folder for folder, _, _ in CONTRACTS]


def test_all_families_are_found():
    assert {"discretization", "frame", "contact", "friction", "damping", "stepping"} <= set(FOLDERS)


@pytest.mark.parametrize(("folder", "modules", "declared"), CONTRACTS, ids=FOLDERS)
def test_every_member_has_every_function(folder, modules, declared):
    members = members_of(declared)
    assert members
    for member in members:
        missing = [n for n, function in declared.items() if member not in function.versions]
        assert not missing, f"{folder}: {member.__name__} lacks {missing}"
        assert member.__module__.startswith(f"snapjump.{folder}.")


@pytest.mark.parametrize(("folder", "modules", "declared"), CONTRACTS, ids=FOLDERS)
def test_every_named_tuple_of_a_member_s_file_is_registered_once(folder, modules, declared):
    members = members_of(declared)
    by_file = {}
    for member in members:
        by_file.setdefault(member.__module__, []).append(member)
    assert all(len(found) == 1 for found in by_file.values()), by_file


def test_sources_of_all_kernels_name_the_folder_of_the_compiled_ones():
    """A package whose kernels are not hashed would be served stale from the disk cache."""
    with_kernels = {
        path.parent.name
        for path in PACKAGE.glob("*/*.py")
        if any(word in path.read_text() for word in ("number.dispatch import", "import njit"))
    }
    assert with_kernels <= set(KERNEL_PACKAGES)


@pytest.mark.parametrize("family", sorted(FAMILIES | DATASET_FAMILIES))
def test_every_option_has_a_docstring_and_defaults(family):
    for options in (FAMILIES | DATASET_FAMILIES)[family].values():
        assert options.__doc__
        options()
