"""Jumps of the same designs with other settings, and how far a frame gives way."""

from collections.abc import Mapping
from typing import Any

from experiments.compositions import Groups, changed, composed
from experiments.designs import spread_designs
from experiments.paper.jumps import LANES, jump_rows
from experiments.paper.settings import BASELINE, groups_at
from snapjump.batch import variants as robots
from snapjump.run.studies.base import Cell, Row
from snapjump.scenes.jump_march import jump_march
from snapjump.scenes.jump_start import jump_model

PAPER, REFERENCE = "paper", "reference"
ENDS = (PAPER, REFERENCE)
SHORT_STEP_S = 1e-6
EULER, DAMPING = "implicit Euler", "no material damping"
START, FRAME = "start from flat clamps", "frame of 1000 EI"
ELASTIC = {"frame": {"name": "elastic"}}
NO_DAMPING = {"name": "kelvin_voigt", "relaxation_time_s": 0.0}
# What a program is compiled for; all else are numbers.
COMPILED = ("discretization", "frame", "contact", "friction", "damping", "integrator", "stepping")

# A choice: the groups that put the converged one into the paper's settings, and the other way.
Changes = Mapping[str, Mapping[str, Any]]


def choices(at: Mapping[str, Groups]) -> dict[str, tuple[Changes, Changes]]:
    """All choices by title; at: the groups of both ends."""
    own, converged = at[PAPER], at[REFERENCE]

    def exchanged(group: str, key: str | None = None) -> tuple[Changes, Changes]:
        def taken(other: Groups) -> Changes:
            return {group: other[group] if key is None else {key: other[group][key]}}

        return taken(converged), taken(own)

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
        DAMPING: (
            {"damping": converged["damping"]},
            {"damping": NO_DAMPING},
        ),
        "clamps of two fixed nodes": exchanged("discretization", "clamp"),
        "66 elements": exchanged("discretization", "elements"),
        "K per node": exchanged("contact", "weighting"),
        START: exchanged("sim", "start_fraction"),
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


DESIGNS, MANY, LONG = 32, 256, 64
STEPS_S = (1e-5, 3e-6, 1e-6, 3e-7)  # the paper's, and ever finer; the last is the limit
LONG_STEPS_S = (3e-5, 1e-4, 3e-4, 1e-3)
STIFFNESSES = (1e3, 1e4, 1e5)  # of the frame, over the beam's
RIGID, STARTS = "rigid frame, standard", "start in the elastic frame"


def exchange(end: str, title: str) -> str:
    """The name of the cell with one choice exchanged."""
    return f"{end}, exchanged: {title}"


def frame(ratio: float) -> str:
    """The name of the cell with a frame so many times stiffer than the beam."""
    return f"frame of {ratio:g} EI, standard"


def step(step_s: float) -> str:
    """The name of the cell with the paper's settings but the step."""
    return f"step {step_s:g} s"


def many(step_s: float) -> str:
    """The name of the cell of jumps that are looked through for failures and gaps."""
    return f"many jumps, step {step_s:g} s"


def planned(groups: Mapping[str, Any], seed: int) -> list[Cell]:
    """All cells."""
    at = {end: groups_at(groups, end) for end in ENDS}
    standard = groups_at(groups, "standard")
    elastic = changed(standard, ELASTIC)
    # In an elastic frame, whose clamps turn with its legs, the arch loses its stability earlier;
    # a start near the rigid frame's critical angle can lie beyond that.
    flat = changed(standard, {"sim": {"start_fraction": 0.0}})
    programs = {program(one) for one in at.values()}

    def cell(name: str, made: Groups, count: int = DESIGNS) -> Cell:
        lanes = LANES if program(made) in programs else 1
        return Cell(name, {"groups": made, "designs": spread_designs(count, seed), "lanes": lanes})

    def stepped(step_s: float) -> Groups:
        return changed(at[PAPER], {"stepping": {"step_s": step_s}})

    def stiff(ratio: float) -> Groups:
        stiffer = {"frame": {"bending_ratio": ratio, "stretching_ratio": ratio}}
        return changed(changed(flat, ELASTIC), stiffer)

    start = {"groups": elastic, "designs": [BASELINE], "kind": "starts"}
    return [
        *(cell(end, at[end]) for end in ENDS),
        *(cell(exchange(*key), made) for key, made in variants(at).items()),
        cell(RIGID, flat),
        *(cell(frame(ratio), stiff(ratio)) for ratio in STIFFNESSES),
        Cell(STARTS, start),
        *(cell(step(s), stepped(s)) for s in STEPS_S[1:]),
        cell(many(STEPS_S[0]), at[PAPER], MANY),
        *(cell(many(s), stepped(s), LONG) for s in LONG_STEPS_S),
    ]


def rows_of(inputs: Mapping[str, Any]) -> list[Row]:
    """A row for each design: its jump, or, where that is asked for, its start.

    Results do not depend on ``lanes``; one lane compiles faster, for a program that few jumps are
    made with."""
    base = composed(inputs["groups"])
    if inputs.get("kind") == "starts":
        return [start_row(one) for one in robots(base, inputs["designs"])]
    return jump_rows(base, inputs["designs"], inputs["lanes"])


def start_row(simulation: Any) -> Row:
    """The equilibrium that the motion starts from: the clear span between the beam's ends (L)."""
    model = jump_model(simulation)
    march = jump_march([simulation], [model])
    march.find_starts()
    nodes = march.queue.state[0, model.frame.dofs(march.mesh) :]
    x, y = nodes[:: model.discretization.node_dofs()], nodes[1 :: model.discretization.node_dofs()]
    span = float(((x[-1] - x[0]) ** 2 + (y[-1] - y[0]) ** 2) ** 0.5)
    return {"clear_span_bar": span, "epsilon_left": 1.0 - span}
