"""Groups that tell every key: config.yaml says all that a job was made of."""

from collections.abc import Mapping, Sequence
from dataclasses import is_dataclass
from typing import Any

from snapjump.checks import ParameterError
from snapjump.declare.fields import construct, settings
from snapjump.declare.inputs import unusual
from snapjump.files.notice import notice


def check_complete(config: Mapping[str, Any], simulation: object, **others: Any) -> None:
    """Raise ParameterError for a key that was deleted.
    ``others``: options beside the simulation's, by their groups."""
    for group, values in config.items():
        options = others.get(group, getattr(simulation, group, None))
        for key in settings(options) if is_dataclass(options) else ():
            if key not in values:
                raise ParameterError(f"{group}.{key}", None, "a value, which cannot be left out")


def warn_of_unusual(simulation: Any) -> None:
    """Say which inputs are far from what is built: another unit may be meant."""
    warn(unusual(simulation))


def warn(lines: Sequence[str]) -> None:
    """Say what to beware of, before any work."""
    for line in lines:
        notice(f"warning: {line}")


def whole(cls: Any, values: Any) -> Any:
    """A part from a group with every key of it. Raises ParameterError."""
    options = construct(cls.group, cls, values)
    check_complete({cls.group: values}, None, **{cls.group: options})
    return options
