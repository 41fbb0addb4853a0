"""Members of families by name: found by their files, built from a group, told as one.

Nothing is imported before it is asked for: a surrogate takes seconds to load.
"""

from collections.abc import Callable, Mapping
from functools import partial
from pathlib import Path
from typing import Any

from snapjump.checks import ParameterError, check_group
from snapjump.declare import families
from snapjump.declare.families import FAMILIES
from snapjump.declare.fields import construct, settings
from snapjump.declare.plugins import load_installed


def files_of(family: str) -> dict[str, Path]:
    """The file of every member, those of installed packages included."""
    load_installed()
    return families.files_in(family)


def member_names(family: str) -> tuple[str, ...]:
    """The members of a family."""
    return tuple(files_of(family))


def member_class(family: str, name: Any) -> Callable[..., Any]:
    """The constructor of a member's options. Raises ParameterError for another name."""
    files = files_of(family)
    if not isinstance(name, str) or name not in files:
        allowed = f"one of {', '.join(files)}, or of a plug-in that is loaded (plugins=<folder>)"
        raise ParameterError(family, name, allowed)
    if files[name].suffix == ".yaml":
        return partial(families.of_numbers, family, name, families.numbers_in(files[name]))
    return families.class_in(family, name)


def members_with(family: str, capability: str) -> tuple[str, ...]:
    """The members whose options, left to their defaults, have a capability."""
    names = member_names(family)
    return tuple(name for name in names if getattr(member_class(family, name)(), capability))


def make_member(family: str, group: Any) -> Any:
    """Checked options from a group: a ``name``, and fields. Raises ParameterError.
    An integrator that is not known but has ``rows`` is a Runge-Kutta method of that tableau."""
    check_group(family, group)
    values = dict(group)
    name = values.pop("name", None)
    if isinstance(name, str) and name.isidentifier() and name not in files_of(family):
        if values and families.numbers_alone(family):
            return families.of_numbers(family, name, values)
    cls = member_class(family, name)
    return cls(**values) if isinstance(cls, partial) else construct(family, cls, values)


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
