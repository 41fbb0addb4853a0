"""Families: a folder of the package each, whose files are its members.

``base.py`` has the contract, every other file one class of options, a
:class:`~snapjump.declare.fields.Part` of that group, and ``parts`` what they are made of. Where the
package names a module as ``NUMBERS_ALONE`` a file of numbers, ``<name>.yaml``, is a member, which
that module's ``of_numbers`` makes.
"""

from collections.abc import Mapping
from functools import lru_cache
from importlib import import_module
from pathlib import Path
from typing import Any

import yaml

from snapjump.checks import ParameterError
from snapjump.declare.fields import Part

BASE = "base"
# Of a simulation, in the order in which they are told.
FAMILIES = (
    *("sim", "discretization", "frame", "drive", "contact", "friction", "damping"),
    "drag",
    *("integrator", "stepping", "backend"),
)


def numbers_alone(family: str) -> bool:
    """Whether a file of numbers is a member."""
    return hasattr(import_module(f"snapjump.{family}"), "NUMBERS_ALONE")


def files_in(family: str) -> dict[str, Path]:
    """The file of every member that is loaded: its module, or its numbers."""
    return dict(_listed(family, tuple(import_module(f"snapjump.{family}").__path__)))


@lru_cache
def _listed(family: str, folders: tuple[str, ...]) -> dict[str, Path]:
    patterns = ("*.yaml", "*.py") if numbers_alone(family) else ("*.py",)
    found = {
        path.stem: path
        for folder in folders
        for pattern in patterns
        for path in sorted(Path(folder).glob(pattern))
    }
    return {name: found[name] for name in sorted(found) if name not in (BASE, "__init__")}


def class_in(family: str, name: str) -> type[Part]:
    """The class of options in a member's module. Raises ParameterError where it is not complete."""
    module = import_module(f"snapjump.{family}.{name}")
    own = [v for v in vars(module).values() if getattr(v, "__module__", "") == module.__name__]
    found = [v for v in own if isinstance(v, type) and issubclass(v, Part) and v.group == family]
    if len(found) != 1:
        allowed = f"a file with one class of options of {family} (it has {len(found)})"
        raise ParameterError(family, name, allowed)
    missing = [n for n in dir(found[0]) if getattr(getattr(found[0], n), "is_required", False)]
    if missing:
        allowed = f"a member with the methods {', '.join(missing)}, which {found[0].__name__} lacks"
        raise ParameterError(family, name, allowed)
    return found[0]


def of_numbers(family: str, name: str, values: Mapping[str, Any], **changes: Any) -> Part:
    """A member that is numbers alone. Raises ParameterError."""
    package = import_module(f"snapjump.{family}")
    module = import_module(f"snapjump.{family}.{package.NUMBERS_ALONE}")
    member: Part = module.of_numbers(name, {**values, **changes})
    return member


def numbers_in(file: Path) -> dict[str, Any]:
    """The numbers of such a member's file, but for its name."""
    values: dict[str, Any] = yaml.safe_load(file.read_text(encoding="utf-8"))
    del values["name"]
    return values
