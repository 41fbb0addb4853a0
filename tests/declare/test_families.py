"""Families: members are found by their files, fulfil their contract and become of options."""

import importlib
import pkgutil
from pathlib import Path

import pytest
from families import EVERY
from refusals import refused

import snapjump
from snapjump.declare.members import make_member, member_group, member_names
from snapjump.number.compile_cache import KERNEL_PACKAGES
from snapjump.number.methods import METHODS, Contract, methods_of

PACKAGE = Path(snapjump.__file__).parent


def contracts():
    """(folder, contract) of every family of kernels."""
    for base in sorted(PACKAGE.glob("**/base.py")):
        folder = ".".join(base.parent.relative_to(PACKAGE).parts)
        package = importlib.import_module(f"snapjump.{folder}")
        for info in pkgutil.iter_modules(package.__path__):
            importlib.import_module(f"snapjump.{folder}.{info.name}")
        for value in vars(importlib.import_module(f"snapjump.{folder}.base")).values():
            if isinstance(value, type) and issubclass(value, Contract) and value is not Contract:
                yield folder, value


CONTRACTS = dict(contracts())


def members_of(folder):
    """Classes of a family that follow its contract."""
    return {cls for cls, _ in METHODS if cls.__module__.startswith(f"snapjump.{folder}.")}


def test_all_families_are_found():
    assert {"discretization", "frame", "contact", "friction", "damping", "stepping"} <= set(
        CONTRACTS
    )


@pytest.mark.parametrize("folder", CONTRACTS)
def test_every_member_has_every_method(folder):
    assert members_of(folder)
    for member in members_of(folder):
        missing = [name for name in methods_of(CONTRACTS[folder]) if (member, name) not in METHODS]
        assert not missing, f"{folder}: {member.__name__} lacks {missing}"


@pytest.mark.parametrize("folder", CONTRACTS)
def test_a_file_has_one_member(folder):
    files = [member.__module__ for member in members_of(folder)]
    assert len(files) == len(set(files)), files


def test_sources_of_all_kernels_name_the_folder_of_the_compiled_ones():
    """A package whose kernels are not hashed would be served stale from the disk cache."""
    with_kernels = {
        path.relative_to(PACKAGE).parts[0]
        for path in PACKAGE.glob("*/**/*.py")
        if any(
            word in path.read_text()
            for word in ("number.dispatch import", "number.methods import", "import njit")
        )
    }
    assert with_kernels <= set(KERNEL_PACKAGES)


@pytest.mark.parametrize("family", EVERY)
def test_every_option_has_a_docstring_and_defaults(family):
    for options in EVERY[family].values():
        assert type(options()).__doc__


def test_members_are_the_modules_but_for_the_contract():
    assert "mlp" in member_names("surrogate")
    assert "base" not in member_names("surrogate")


def test_a_group_becomes_options_and_back():
    group = {"name": "mlp", "width": 8, "layers": 2}
    assert member_group(make_member("surrogate", group)) == group


@pytest.mark.parametrize(
    ("group", "key"),
    [
        ({"name": "nonesuch"}, "surrogate"),
        ({"name": "base"}, "surrogate"),
        ({"name": "mlp", "width": 8, "layers": 2, "depth": 3}, "surrogate.depth"),
        ({"name": "mlp", "width": 0, "layers": 2}, "surrogate.width"),
        ("mlp", "surrogate"),
    ],
)
def test_bad_groups_are_named(group, key):
    with refused(key):
        make_member("surrogate", group)
