"""Integrators by the engine's own stages: steps of one loose node, and the matrix of a step."""

from typing import Any, NamedTuple

import numpy as np
from bare_models import loose_nodes
from families import FAMILIES
from plain_python import plain_work

from snapjump.contact.base import ContactLaw
from snapjump.engine.clock import LAST_STEP, STABLE_STEP, STAGE, STEP, TIME
from snapjump.engine.explicit import evaluate_forces
from snapjump.engine.newton import StageLimits, newton_iteration
from snapjump.engine.stage import (
    begin_stage,
    commit_step,
    estimate_error,
    keep_stage,
    rates_of,
    stage_motion,
)
from snapjump.engine.step import reach_end

MEMBERS = FAMILIES["integrator"]
VARIANTS = {
    **{name: cls() for name, cls in MEMBERS.items()},
    "generalized_alpha": MEMBERS["generalized_alpha"](0.5),
    "generalized_alpha 0": MEMBERS["generalized_alpha"](0.0),
    "generalized_alpha 0.8": MEMBERS["generalized_alpha"](0.8),
    "newmark damped": MEMBERS["newmark"](0.36, 0.7),
}
MASSES = np.array([0.7])


class Integration:
    """One loose node taken through steps of a scheme."""

    def __init__(self, name, model, state, velocity, acceleration):
        self.scheme = VARIANTS[name].scheme()
        self.model = model
        self.work = plain_work(model, 1, self.scheme.slots())
        self.work.start[:] = self.work.state[:] = state
        self.work.velocity[:] = velocity
        self.work.acceleration[:] = acceleration

    def step(self, size: float) -> float:
        """Take a step; returns its estimated error."""
        work, clock = self.work, self.work.clock
        clock[STEP] = size
        error = 0.0
        for stage in range(1, self.scheme.stage_count() + 1):
            clock[STAGE] = 1.0 * stage
            begin_stage(self.model, self.scheme, MASSES, work, True)
            motion = stage_motion(self.scheme, work)
            for _ in range(30):
                now = (self.model, motion, MASSES, work, True)
                if self.scheme.is_explicit():
                    outcome = evaluate_forces(*now)
                else:
                    outcome = newton_iteration(*now, StageLimits(1e-13, 0.1, 30.0, 4.0))
                if outcome.converged:
                    break
            assert outcome.converged
            error = estimate_error(self.scheme, work, motion)
            keep_stage(self.scheme, work, motion, stage, True)
        if not self.scheme.ends_in_a_stage():
            assert not reach_end(self.model, self.scheme, MASSES, work, True)
        commit_step(self.scheme, work, size, rates_of(motion), True)
        clock[TIME] += size
        clock[LAST_STEP] = size
        return error


class Anywhere(ContactLaw):
    """A law in place of the ground's that acts at every height."""

    def reach(self):
        return 1e9

    def energy(self, gap):
        return 0.0 * gap

    def bounce_rate_squared(self, stiffness, mass, speed):
        return 0.0


@Anywhere.member
class Pull(NamedTuple):
    """It makes a node's height y obey mass y'' = -pull(y) - drag y'."""

    pull: Any
    drag: Any = 0.0

    def force(self, gap, state):
        return -self.pull(gap) - self.drag * state.speed


def amplification(name, omega_h, drag=0.0):
    """Eigenvalues of one step of q'' = -omega^2 q - drag q' (h = 1), and the stable step."""
    stiffness = omega_h**2
    size = 1e-3 / (1.0 + stiffness)  # no guess may be farther off than Newton's method goes
    law = Pull(lambda y: MASSES[0] * stiffness * y, MASSES[0] * drag)
    return amplified(name, loose_nodes(contact=law), 1, size)


def amplified(name, model, axis, size):
    """Eigenvalues of one step of a coordinate of a node, the step's memory and all (h = 1).

    Each part of the memory is moved, the step is taken, and what comes out of it is a column of
    the step's matrix.
    """

    def memory(run):
        """What a step begins with: views of one number each."""
        others = [k for k in range(run.scheme.slots()) if k != 1]
        rates = [array[k] for array in (run.work.velocity, run.work.acceleration) for k in others]
        return [values[axis : axis + 1] for values in (run.work.start, *rates)]

    columns, parts = [], 1
    while len(columns) < parts:
        run = Integration(name, model, *np.zeros((3, 2)))
        run.work.clock[LAST_STEP] = 1.0
        parts = len(memory(run))
        memory(run)[len(columns)] += size
        run.step(1.0)
        columns.append(np.concatenate(memory(run)) / size)
    matrix = np.array(columns).T
    others = matrix - np.eye(parts)
    used = others.any(axis=0) | others.any(axis=1)  # the others no step reads or writes
    return np.linalg.eigvals(matrix[np.ix_(used, used)]), run.work.clock[STABLE_STEP]
