"""The jumps that causes are found from: ends, exchanges, frames, steps, and many for their gaps."""

from collections.abc import Mapping
from typing import Any

from experiments.compositions import Groups, changed
from experiments.designs import spread_designs
from experiments.paper.baseline import BASELINE
from experiments.paper.causes.choices import ELASTIC, ENDS, PAPER, program, variants
from experiments.paper.jumps import LANES
from experiments.paper.tiers import groups_at
from snapjump.studies.base import Cell

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
