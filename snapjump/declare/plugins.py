"""Plug-ins: members of any family from a folder outside, or from an installed package.

A folder is laid out as the package is, ``<group>/<name>.py`` and ``<name>.yaml`` (what the command
line reads), and becomes a part of it: a member ``contact/cone.py`` is ``snapjump.contact.cone``,
found by its file as ours are. Its files are sources: they are in every hash of these.
"""

import copyreg
import importlib
import os
import sys
from collections.abc import Sequence
from importlib import metadata
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import yaml

from snapjump.checks import ParameterError
from snapjump.declare import families
from snapjump.declare.fields import Part, settings
from snapjump.files import sources
from snapjump.tiers import TIERS

ENTRY_POINTS = "snapjump.plugins"
VARIABLE = "SNAPJUMP_PLUGINS"  # for processes that this one starts
_loaded: dict[Path, str] = {}
_looked: list[bool] = []


def load_plugins(folder: str | Path) -> None:
    """Add the members in a folder to their families, for this process and those that it starts.

    Raises ParameterError for what is no folder of plug-ins, a name that is taken, a member that is
    not complete, a YAML that is not its member's, and a folder whose files have changed since this
    process loaded it.
    """
    place = Path(folder).expanduser().resolve()
    if not place.is_dir():
        raise ParameterError("plugins", str(folder), "a folder of plug-ins: <group>/<member>.py")
    load_installed()
    if place in _loaded:
        if _hash(place) != _loaded[place]:
            changed = "files have changed since, which a new process sees"
            allowed = f"a folder as it was loaded; {changed}"
            raise ParameterError("plugins", str(place), allowed)
        return
    groups = [group for group in sorted(place.iterdir()) if members_in(group)]
    for group in groups:
        _check_group(group)
    sources.PLUGINS.append(place)
    paths: Any = [importlib.import_module(f"snapjump.{one.name}").__path__ for one in groups]
    for path, group in zip(paths, groups, strict=True):
        path.append(str(group))
    importlib.invalidate_caches()
    try:
        _refresh_kernels()
        for group in groups:
            for file in members_in(group):
                _check_member(file)
    except ParameterError:
        sources.PLUGINS.remove(place)
        for path, group in zip(paths, groups, strict=True):
            path.remove(str(group))
            for file in members_in(group):
                sys.modules.pop(f"snapjump.{group.name}.{file.stem}", None)
        _refresh_kernels()
        raise
    _loaded[place] = _hash(place)
    os.environ[VARIABLE] = os.pathsep.join(map(str, sources.PLUGINS))


def load_all(folders: str | Sequence[str] | None) -> None:
    """Load the plug-ins of a value of the key ``plugins``. Raises ParameterError."""
    for folder in [folders] if isinstance(folders, str) else folders or ():
        load_plugins(folder)


def load_installed() -> None:
    """Load, once, what installed packages offer and what the process that started this one had."""
    if _looked:
        return
    _looked.append(True)
    for point in metadata.entry_points(group=ENTRY_POINTS):
        spec = find_spec(point.value)
        for folder in (spec and spec.submodule_search_locations) or []:
            load_plugins(folder)
    for folder in filter(None, os.environ.get(VARIABLE, "").split(os.pathsep)):
        load_plugins(folder)


def members_in(group: Path) -> list[Path]:
    """The files of members in a folder: Python, and tableaux of Runge-Kutta methods."""
    files_there = sorted(set(group.glob("*.py")) - {group / "__init__.py"})
    if _is_family(group) and families.numbers_alone(group.name):
        known = {file.stem for file in files_there}
        files_there += [file for file in sorted(group.glob("*.yaml")) if file.stem not in known]
    return files_there


def _is_family(group: Path) -> bool:
    return (sources.PACKAGE / group.name / "base.py").exists()


def _hash(place: Path) -> str:
    sources.forget(place)
    own = (source for source in sources.plugin_files() if place in source.path.parents)
    return sources.combined_hash(own)


def _refresh_kernels() -> None:
    """Have kernels kept where these sources belong, if there are any yet."""
    dispatch = sys.modules.get("snapjump.number.dispatch")
    if dispatch is not None:
        dispatch.refresh()


def _check_group(group: Path) -> None:
    """Require a family, and names that no member has."""
    if not _is_family(group):
        raise ParameterError("plugins", str(group), "a folder named like a group of conf/")
    taken = (*families.files_in(group.name), families.BASE, "parts")
    for file in members_in(group):
        if file.stem in taken or not file.stem.isidentifier():
            raise ParameterError("plugins", str(file), f"a name that no {group.name} has yet")


def _check_member(file: Path) -> None:
    """Require a class of options that is complete, and a YAML with its fields and defaults."""
    family, name = file.parent.name, file.stem
    try:
        if file.suffix == ".yaml":
            families.of_numbers(family, name, families.numbers_in(file))
            return
        cls = families.class_in(family, name)
    except ParameterError as error:
        raise ParameterError("plugins", str(file), error.allowed) from error
    except Exception as error:
        reason = " ".join(f"{type(error).__name__}: {error}".split())
        allowed = f"a file that Python imports ({reason})"
        raise ParameterError("plugins", str(file), allowed) from error
    copyreg.pickle(cls, _reduced)
    settings_file = file.with_suffix(".yaml")
    if settings_file.exists():
        part = cls()
        expected = {"name": name, **{key: getattr(part, key) for key in settings(part)}}
        _check_yaml(settings_file, expected, family)


def _reduced(part: Part) -> Any:
    """How a part is pickled: another process may not know its member yet, and loads it first."""
    return _revived, (list(sources.PLUGINS), type(part).__module__, type(part).__qualname__,
                      part.__dict__)  # fmt: skip


def _revived(plugins: list[Path], module: str, name: str, state: dict[str, Any]) -> Any:
    """A part from its pickle. Raises ParameterError where a plug-in's folder is not there."""
    for folder in plugins:
        load_plugins(folder)
    cls = getattr(importlib.import_module(module), name)
    part = cls.__new__(cls)
    part.__dict__.update(state)
    return part


def _check_yaml(file: Path, expected: dict[str, Any], group: str) -> None:
    """Require the fields of a member, and their defaults or what an accuracy tier has for them."""
    values = yaml.safe_load(file.read_text(encoding="utf-8"))
    if isinstance(values, dict) and group in values and "defaults" in values:
        values = values[group]  # of a scene, which chooses other members too
    keys = list(values) if isinstance(values, dict) else values
    if keys != list(expected):
        raise ParameterError("plugins", str(file), f"the keys {', '.join(expected)}, in this order")
    for key, default in expected.items():
        chosen = any(f"{group}.{key}" in tier.numbers for tier in TIERS.values())
        right = f"${{accuracy.{key}}}" if chosen else default
        if values[key] != right:
            allowed = f"{key}: {right}, as {file.stem}.py and the accuracy tiers have it"
            raise ParameterError("plugins", str(file), allowed)
