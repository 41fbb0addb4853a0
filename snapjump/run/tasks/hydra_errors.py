"""Hydra's and OmegaConf's complaints as one line: the key, the value, what is allowed."""

from collections.abc import Iterable, Sequence
from difflib import get_close_matches
from typing import Any

from hydra.errors import MissingConfigException, OverrideParseException
from omegaconf import DictConfig, OmegaConf
from omegaconf.errors import ConfigAttributeError, ConfigKeyError, OmegaConfBaseException

from snapjump.checks import ParameterError


def one_line(error: Exception, arguments: Sequence[str]) -> ParameterError:
    """An error of Hydra's as a ParameterError."""
    if isinstance(error, MissingConfigException) and error.options:
        group, _, member = str(error.missing_cfg_file).rpartition("/")
        return ParameterError(group, member, "one of " + ", ".join(sorted(error.options)))
    if isinstance(error, OverrideParseException):
        return ParameterError(
            "command line", error.override, "key=value; quote values with spaces or commas"
        )
    text = " ".join(str(error).split())
    if text.startswith("Ambiguous value for argument") or "requires --multirun" in text:
        sweeping = next(
            (argument for argument in arguments if f"'{argument}'" in text), "command line"
        )
        key, _, value = sweeping.partition("=")
        allowed = f"one value, or a list [{value}]; to sweep over several add --multirun"
        return ParameterError(key, value, allowed)
    for cause in _causes(error):
        if isinstance(cause, (ConfigAttributeError, ConfigKeyError)):
            return _unknown_key(cause, arguments)
        if isinstance(cause, OmegaConfBaseException):
            key = str(cause.full_key or cause.key or "configuration")
            if "Cannot merge" in str(cause):
                allowed = f"a group: {key}.<key>=... sets one of its keys"
                return ParameterError(key, _given(key, arguments), allowed)
            reason = (str(cause).strip().splitlines() or [type(cause).__name__])[0]
            return ParameterError(key, _given(key, arguments), reason)
    key = text.partition("Could not override '")[2].partition("'")[0]
    if key:
        return ParameterError(key, _given(key, arguments), "no such group or key")
    return ParameterError("command line", " ".join(arguments), text or type(error).__name__)


def _unknown_key(error: OmegaConfBaseException, arguments: Sequence[str]) -> ParameterError:
    key = str(error.full_key or error.key)
    parent = error.parent_node
    known = [str(k) for k in parent if k != "hydra"] if isinstance(parent, DictConfig) else []
    place, _, name = key.rpartition(".")
    near = get_close_matches(name, known, n=1)
    elsewhere = _paths_like(name, parent._get_root()) if isinstance(parent, DictConfig) else []
    meant = ", ".join(elsewhere or near)
    hint = f"did you mean {meant}? " if meant else ""
    allowed = f"{hint}{place or 'the configuration'} has {', '.join(known) or 'no keys'}"
    return ParameterError(key, _given(key, arguments), allowed)


def _paths_like(name: str, root: Any) -> list[str]:
    """Keys anywhere in a configuration whose last word is a name, or one with its unit."""
    found = []
    whole: Any = OmegaConf.to_container(root, resolve=False)
    for group, values in whole.items():
        if group != "hydra" and isinstance(values, dict):
            keys = [str(key) for key in values]
            found += [f"{group}.{key}" for key in keys if key == name or key.startswith(f"{name}_")]
    return found


def _given(key: str, arguments: Sequence[str]) -> str:
    """The value of a key on the command line, or nothing."""
    for argument in arguments:
        name, separator, value = argument.partition("=")
        if separator and f"{name.lstrip('+~')}.".startswith(f"{key}."):
            return value
    return ""


def _causes(error: BaseException | None) -> Iterable[BaseException]:
    while error is not None:
        yield error
        error = error.__cause__ or error.__context__
