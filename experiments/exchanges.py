"""Choices that lead from the paper's settings to the converged ones, exchanged one at a time."""

from collections.abc import Mapping
from typing import Any

from .compositions import Groups, changed

PAPER, REFERENCE = "paper", "reference"
ENDS = (PAPER, REFERENCE)
SHORT_STEP_S = 1e-6
EULER, DAMPING, ELEMENTS = "implicit Euler", "no material damping", "66 elements"
START, FRAME = "a later start", "frame of 1000 EI"
LATER = {"sim": {"start_fraction": 0.85}}
ELASTIC = {"frame": {"name": "elastic"}}
NO_DAMPING = {"name": "kelvin_voigt", "relaxation_time_s": 0.0}
# What a program is compiled for; all else are numbers.
COMPILED = ("discretization", "frame", "contact", "friction", "damping", "integrator", "stepping")

# A choice: the groups that put the converged one into the paper's settings, and the other way.
Changes = Mapping[str, Mapping[str, Any]]


def choices(at: Mapping[str, Groups]) -> dict[str, tuple[Changes, Changes]]:
    """All choices by title; at: the groups of both ends."""
    own, converged = at[PAPER], at[REFERENCE]

    def exchanged(group: str, key: str) -> tuple[Changes, Changes]:
        return {group: {key: converged[group][key]}}, {group: {key: own[group][key]}}

    return {
        "fixed step of 1e-5 s": (
            # The adaptive steps of another integrator would be no first-order scheme's.
            {"stepping": {"step_s": SHORT_STEP_S}},
            {"stepping": own["stepping"]},
        ),
        EULER: (
            {"integrator": converged["integrator"]},
            # With the steps that it was chosen with: with tight ones it is as exact as any.
            {"integrator": own["integrator"], "stepping": own["stepping"]},
        ),
        # Without relaxation the law is none, to the last bit; so written it needs no program that
        # no other exchange has.
        "lagged friction": (
            {"friction": converged["friction"], "damping": NO_DAMPING},
            {"friction": own["friction"]},
        ),
        DAMPING: ({"damping": converged["damping"]}, {"damping": NO_DAMPING}),
        "clamps of two fixed nodes": exchanged("discretization", "clamp"),
        ELEMENTS: exchanged("discretization", "elements"),
        "K per node": exchanged("contact", "weighting"),
        # The same jump; what it moves is noise.
        START: (LATER, LATER),
        FRAME: (ELASTIC, ELASTIC),
    }


def variants(at: Mapping[str, Groups]) -> dict[tuple[str, str], Groups]:
    """Both ends with each choice exchanged, by end and title."""
    return {
        (end, title): changed(at[end], changes[k])
        for k, end in enumerate(ENDS)
        for title, changes in choices(at).items()
    }


def program(groups: Groups) -> tuple[str, ...]:
    """Names of the modules that a program is compiled for."""
    return tuple(groups[family]["name"] for family in COMPILED)
