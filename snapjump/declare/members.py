"""Members of families, found by their files: a new one is a file and a YAML, and no list.

A family is a folder of the package: ``base.py`` has its contract, every other file one class of
options, a :class:`~snapjump.declare.fields.Part` of that group, and ``parts`` what they are made
of. Where the package says ``NUMBERS_ALONE`` a file of numbers, ``<name>.yaml``, is a member, which
the contract's ``of_numbers`` makes.
Nothing is imported before it is asked for: a surrogate takes seconds to load.
"""

from collections.abc import Callable, Mapping
from functools import partial
from importlib import import_module
from pathlib import Path
from typing import Any

import yaml

from snapjump.checks import ParameterError, check_group
from snapjump.declare.fields import Part, construct, settings
from snapjump.declare.plugins import load_installed

BASE = "base"
# Of a simulation, in the order in which they are told.
FAMILIES = (
    "sim",
    "discretization",
    "frame",
    "contact",
    "friction",
    "damping",
    "integrator",
    "stepping",
    "backend",
)


def files_of(family: str) -> dict[str, Path]:
    """The file of every member: its module, or its numbers."""
    load_installed()
    package = import_module(f"snapjump.{family}")
    patterns = ("*.yaml", "*.py") if hasattr(package, "NUMBERS_ALONE") else ("*.py",)
    found = {
        path.stem: path
        for folder in package.__path__
        for pattern in patterns
        for path in sorted(Path(folder).glob(pattern))
    }
    return {name: found[name] for name in sorted(found) if name not in (BASE, "__init__")}


def member_names(family: str) -> tuple[str, ...]:
    """The members of a family."""
    return tuple(files_of(family))


def member_class(family: str, name: Any) -> Callable[..., Any]:
    """What makes a member's options from its fields. Raises ParameterError for another name."""
    files = files_of(family)
    if not isinstance(name, str) or name not in files:
        allowed = f"one of {', '.join(files)}, or of a plug-in that is loaded (plugins=<folder>)"
        raise ParameterError(family, name, allowed)
    if files[name].suffix == ".yaml":
        values = yaml.safe_load(files[name].read_text(encoding="utf-8"))
        del values["name"]
        return partial(of_numbers, family, name, values)
    return class_in(family, name)


def members_with(family: str, capability: str) -> tuple[str, ...]:
    """The members whose options, left to their defaults, have a capability."""
    names = member_names(family)
    return tuple(name for name in names if getattr(member_class(family, name)(), capability))


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


def of_numbers(family: str, method: str, values: Mapping[str, Any], **changes: Any) -> Part:
    """A member that is numbers alone. Raises ParameterError."""
    base = import_module(f"snapjump.{family}.{BASE}")
    member: Part = base.of_numbers(method, {**values, **changes})
    return member


def make_member(family: str, group: Any) -> Any:
    """Checked options from a group: a ``name``, and fields. Raises ParameterError.

    An integrator that is not known but has ``rows`` is a Runge-Kutta method of that tableau.
    """
    check_group(family, group)
    values = dict(group)
    name = values.pop("name", None)
    if isinstance(name, str) and name.isidentifier() and name not in files_of(family):
        if hasattr(import_module(f"snapjump.{family}"), "NUMBERS_ALONE") and values:
            return of_numbers(family, name, values)
    cls = member_class(family, name)
    if isinstance(cls, partial):
        return cls(**values)
    return construct(family, cls, values)


def check_known(configuration: Mapping[str, Any]) -> None:
    """Require the members of stored groups to be known. Raises ParameterError for the first that is
    not, as where its plug-in is not loaded."""
    for family in FAMILIES:
        group = configuration.get(family) or {}
        if "name" in group and "rows" not in group:
            member_class(family, group["name"])


def member_group(options: Any) -> dict[str, Any]:
    """The group that options came from, plain."""
    return {"name": options.name, **{key: getattr(options, key) for key in settings(options)}}
