"""Jumps in plain Python that begin when the beam has snapped and is about to strike the ground.

What comes before takes half of a jump's iterations and is much the same whatever the modules: it
is marched once for each kind of beam and frame, or by the compiled program.
"""

from functools import cache
from typing import Any, NamedTuple

import numpy as np
from plain_march import without_compiling
from pytest import MonkeyPatch

from snapjump.batch.derivatives import place
from snapjump.composition import Simulation
from snapjump.engine import clock as c
from snapjump.engine.gaps import smallest_gap
from snapjump.scenes import flight_check, runner
from snapjump.scenes.jump_march import jump_march
from snapjump.scenes.jump_start import jump_model
from snapjump.scenes.runner import March

STRIKING = 0.5  # L/T: a node that falls so fast is in the strike or just before it
MOST_PASSES = 2000


class Way(NamedTuple):
    """From a robot's start to the strike: displacement, and what there is at the end of it."""

    displacement: Any
    velocity: Any
    acceleration: Any
    duration: float


def begin_before_the_strike(monkeypatch: MonkeyPatch, usual: Simulation) -> None:
    """Let marches in plain Python find their own starts, and go on as the usual modules did."""
    without_compiling(monkeypatch)
    find_starts = March.find_starts

    def find_and_go_on(march: March, progress: Any = None) -> None:
        find_starts(march, progress)
        go_on(march, way(usual, find_starts))

    monkeypatch.setattr(March, "find_starts", find_and_go_on)
    # The momentum of that way is the usual friction's; a slippery ground would not have given it.
    monkeypatch.setattr(flight_check, "driven_too_far", lambda *_: False)


def go_on(march: March, way: Way) -> None:
    queue, model = march.queue, march.models[0]
    for state in queue.state:
        before = smallest_gap(model, march.masses, march.mesh, state)
        state += way.displacement
        gap = smallest_gap(model, march.masses, march.mesh, state)
        # The usual modules carry the beam at another height than those that let nothing in.
        if gap <= 0.0 < before:
            state += (before - gap) * upwards(march)
    queue.velocity[:] = way.velocity
    queue.acceleration[:] = way.acceleration
    queue.numbers[:, place(model, "clamp", "start")] += model.clamp.rate * way.duration


def upwards(march: March) -> Any:
    """What a robot's coordinates change by if it moves up (by 1 L)."""
    frame, low, high = march.models[0].frame, *np.zeros((2, march.states.shape[1]))
    frame.rest(march.mesh, low, 0.0)
    frame.rest(march.mesh, high, 1.0)
    high[frame.dofs(march.mesh) :].reshape(len(march.masses), -1)[:, 1] = 1.0
    return high - low


@cache
def way(usual: Simulation, find_starts: Any) -> Way:
    march = jump_march([usual], [jump_model(usual)])
    find_starts(march)
    return to_the_strike(march)


def to_the_strike(march: March) -> Way:
    """March a robot there that is alone in its queue, one pass after the other."""
    begun = march.queue.state[0].copy()
    arguments, memory = march.arguments(march.crew[0]), march.memory
    while falling(march) < STRIKING:
        assert not runner.march(*arguments, 1)
        assert march.passes < MOST_PASSES
    return Way(
        memory.start[:, 0] - begun,
        memory.velocity[0, :, 0].copy(),
        memory.acceleration[0, :, 0].copy(),
        float(memory.clock[c.TIME, 0]),
    )


def falling(march: March) -> float:
    """Speed (L/T) of the fastest node downwards; nodes have two or three coordinates."""
    beam = march.memory.velocity[0, march.models[0].frame.dofs(march.mesh) :, 0]
    return -float(np.min(beam.reshape(len(march.masses), -1)[:, 1]))
