"""Compositions as plain groups, changed by plain groups: what the cells of studies are made of."""

from collections.abc import Mapping
from dataclasses import asdict
from typing import Any

from snapjump.composition import Simulation, with_tier
from snapjump.declare.families import FAMILIES
from snapjump.declare.members import make_member, member_group
from snapjump.simulation import PLAIN, build
from snapjump.targets.simulator import at_tier

Groups = dict[str, dict[str, Any]]
composed = build  # the simulation of groups; raises ParameterError for what cannot be composed


def groups_of(config: Mapping[str, Any]) -> Groups:
    """The groups of a configuration that a simulation is built from."""
    groups = {key: dict(config[key]) for key in (*PLAIN, *FAMILIES)}
    return {**groups, "accuracy": {"name": config["accuracy"]["name"]}}


def changed(groups: Mapping[str, Mapping[str, Any]], changes: Mapping[str, Any]) -> Groups:
    """Other values in some groups; another member's name drops the values of the old one."""
    result = {key: dict(values) for key, values in groups.items()}
    for group, values in changes.items():
        before = result.get(group, {})
        same = "name" not in values or values["name"] == before.get("name")
        result[group] = {**before, **values} if same else dict(values)
    return result


def has_field(groups: Mapping[str, Mapping[str, Any]], group: str, key: str) -> bool:
    """Whether the chosen member of a family has a field."""
    return key in member_group(make_member(group, {"name": groups[group]["name"]}))


def described(simulation: Simulation) -> Groups:
    """The groups that a simulation would be built from."""
    groups: Groups = {key: asdict(getattr(simulation, key)) for key in PLAIN}
    groups |= {part.group: member_group(part) for part in simulation.parts}
    return {**groups, "accuracy": {"name": simulation.accuracy}}


def groups_at(groups: Mapping[str, Any], tier: str) -> Groups:
    """The same physical model at ``standard``, ``draft`` or ``reference``; all of the paper's own
    settings at ``paper``, whose friction, damping and contact weighting are part of the tier."""
    return described(simulation_at(groups, tier))


def simulation_at(groups: Mapping[str, Any], tier: str) -> Simulation:
    """The simulation of :func:`groups_at`."""
    base = composed(groups)
    if tier == base.accuracy:
        return base
    if tier == "paper":
        kept = {part: getattr(base, part) for part in ("robot", "design", "environment")}
        return with_tier("paper", **kept)
    return at_tier(base, tier)
