"""Random configurations that make no sense, and whether each is refused in one clear line."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from snapjump.checks import ParameterError
from snapjump.declare.families import FAMILIES
from snapjump.run.studies.base import REFUSED, Row
from snapjump.simulation import PLAIN, build

from .combinations import COMBINATIONS
from .fields import NOT_FINITE, Field, all_fields, one_of, outside, wrong_type

ACCEPTED, CRASHED, UNCLEAR = "accepted", "crashed", "unclear"
LONGEST_LINE = 400
NOT_GROUPS: tuple[Any, ...] = ("nonsense", 5, 1.5, [1], True, ("name",))
NOT_NAMES: tuple[Any, ...] = (None, 3, "", "no such member", ["jump"], {"name": 1}, True)


@dataclass(frozen=True)
class Invalid:
    """A configuration, what is wrong with it, and the key that the refusal must name."""

    kind: str
    key: str
    config: Mapping[str, Any]


def invalid_configurations(count: int, seed: int) -> list[Invalid]:
    """Random invalid configurations, all kinds in turn."""
    random = np.random.default_rng(seed)
    listed = all_fields()
    kinds = (of_wrong_type, not_finite, out_of_range, unknown_key, unknown_member, not_a_group,
             combination)  # fmt: skip
    return [kinds[k % len(kinds)](listed, random) for k in range(count)]


def groups_with(field: Field, value: Any) -> dict[str, Any]:
    """Only the group of the field: whatever else is wrong with the scene comes later."""
    name = {"name": field.name} if field.name else {}
    return {field.group: {**name, field.key: value}}


def wrong_value(
    kind: str, make: Callable[[Field, np.random.Generator], Any], of_numbers: bool = True
) -> Callable[[list[Field], np.random.Generator], Invalid]:
    """What makes a field with a value that it must not have, of a number if not of any field."""

    def invalid(listed: list[Field], random: np.random.Generator) -> Invalid:
        field = one_of(random, [f for f in listed if f.is_number or not of_numbers])
        key = f"{field.group}.{field.key}"
        return Invalid(kind, key, groups_with(field, make(field, random)))

    return invalid


of_wrong_type = wrong_value("wrong type", wrong_type, of_numbers=False)
not_finite = wrong_value("not finite", lambda field, random: one_of(random, NOT_FINITE))
out_of_range = wrong_value("out of range", outside)


def unknown_key(listed: list[Field], random: np.random.Generator) -> Invalid:
    """A key that the group does not have: one with a letter missing, doubled or exchanged."""
    field = one_of(random, listed)
    place = int(random.integers(1, len(field.key)))
    key = (
        field.key[:place] + field.key[place + 1 :] + "_",
        field.key[:place] + field.key[place - 1] + field.key[place:],
        field.key.upper(),
    )[random.integers(3)]
    if key == field.key:
        key += "x"
    groups = groups_with(field, field.default)
    groups[field.group] = {k if k != field.key else key: v for k, v in groups[field.group].items()}
    return Invalid("unknown key", f"{field.group}.{key}", groups)


def unknown_member(listed: list[Field], random: np.random.Generator) -> Invalid:
    """A member that the family does not have."""
    family, name = one_of(random, FAMILIES), one_of(random, NOT_NAMES)
    return Invalid("unknown member", family, {family: {"name": name, "any": 1.0}})


def not_a_group(listed: list[Field], random: np.random.Generator) -> Invalid:
    """A value where a group belongs."""
    group = one_of(random, [*PLAIN, *FAMILIES, "accuracy"])
    return Invalid("not a group", group, {group: one_of(random, NOT_GROUPS)})


def combination(listed: list[Field], random: np.random.Generator) -> Invalid:
    """Members or numbers that are fine by themselves and not together."""
    key, make = one_of(random, COMBINATIONS)
    return Invalid("combination", key, make(random))


def configuration_row(one: Invalid) -> Row:
    """The outcome of an invalid configuration as a row."""
    outcome, message = refusal(one)
    config = str(one.config)[:200]
    return {"kind": one.kind, "key": one.key, "config": config, "outcome": outcome,
            "message": message}  # fmt: skip


def refusal(invalid: Invalid) -> tuple[str, str]:
    """The outcome (one of the four words above) and the error of an invalid configuration."""
    try:
        simulation = build(invalid.config)
        simulation.sim.check_start(simulation)
    except ParameterError as error:
        text = str(error)
        clear = "\n" not in text and len(text) <= LONGEST_LINE and error.allowed
        named = text.startswith(invalid.key) and text.split(" = ")[0] == error.key
        return REFUSED if clear and named else UNCLEAR, text
    except Exception as error:
        return CRASHED, f"{type(error).__name__}: {error}"
    return ACCEPTED, ""
