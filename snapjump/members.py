"""Families whose members are found by their files: a new one is a file and a YAML, and no list.

A member's module has a frozen dataclass of its options, which checks every value, and names it
``MEMBER``. It may import what takes seconds to load: nothing is imported before it is asked for.
"""

import pkgutil
from collections.abc import Mapping
from dataclasses import fields
from importlib import import_module
from typing import Any

from snapjump.checks import ParameterError, check_choice, check_group

BASE = "base"


def member_names(family: str) -> tuple[str, ...]:
    """The modules of ``snapjump.<family>``, but for its contract."""
    package = import_module(f"snapjump.{family}")
    found = (info.name for info in pkgutil.iter_modules(package.__path__))
    return tuple(sorted(name for name in found if name != BASE))


def member_class(family: str, name: str) -> type:
    """The options of a member by its name. Raises ParameterError."""
    check_choice(family, name, member_names(family))
    cls: type = import_module(f"snapjump.{family}.{name}").MEMBER
    return cls


def make_member(family: str, group: Any) -> Any:
    """Checked options from a group with a ``name`` and all fields. Raises ParameterError."""
    check_group(family, group)
    values = dict(group)
    return make_options(family, member_class(family, values.pop("name", None)), values)


def make_options(key: str, cls: type, group: Any) -> Any:
    """Options of a class from a group that has exactly its fields. Raises ParameterError."""
    check_group(key, group)
    known = [field.name for field in fields(cls)]
    for name, value in group.items():
        if name not in known:
            allowed = ", ".join(known) or "no keys at all"
            raise ParameterError(f"{key}.{name}", value, f"this {key} has {allowed}")
    for name in known:
        if name not in group:
            raise ParameterError(f"{key}.{name}", None, "a value, which cannot be left out")
    return cls(**group)


def member_group(family: str, options: Any) -> Mapping[str, Any]:
    """The group that options came from, plain."""
    name = type(options).__module__.rsplit(".", 1)[1]
    return {"name": name, **{f.name: getattr(options, f.name) for f in fields(options)}}
