"""Elements with rotations in lanes: a Newton iteration of each robot as if it were alone."""

from typing import Any

import numpy as np
import pytest
from families import FAMILIES
from numba import njit

from snapjump.contact.base import Ground
from snapjump.contact.logbarrier import LogBarrier
from snapjump.damping.kelvin_voigt import KelvinVoigt
from snapjump.drive.constant_rate import ConstantRate
from snapjump.engine.assemble import Motion
from snapjump.engine.linearised import solve_linearised
from snapjump.engine.load.gravity import Gravity
from snapjump.engine.model import Model, numbers_of, with_numbers
from snapjump.engine.view import view_work
from snapjump.engine.work import make_memory, sizes_of
from snapjump.frame.rigid import RigidFrame
from snapjump.friction.implicit import ImplicitFriction
from snapjump.robot.robot import Robot

MEMBERS = FAMILIES["discretization"]
ELEMENTS = 16
WIDTH = 8


@njit(error_model="numpy")
def solve(template: Any, masses: Any, memory: Any, lanes: Any) -> None:
    work = view_work(memory, lanes)
    model = with_numbers(template, work.numbers)
    zero = 0.0 * work.state[0]
    motion = Motion(zero + 0.2, zero + 50.0, zero + 50.0, zero)
    solution = solve_linearised(model, motion, masses, work)
    work.clock[0] = solution.residual
    work.clock[1] = solution.correction
    work.clock[2] = solution.negative_pivots


@pytest.mark.compiles
@pytest.mark.parametrize("name", sorted(MEMBERS.keys() - {"der"}))
def test_lanes_and_scalars_agree_to_the_last_bit(name):
    options = MEMBERS[name](ELEMENTS)
    model = Model(
        options.beam(Robot()),
        RigidFrame.Body(0.4, -0.15, -0.25, 0.25, 15.0, 1.3, 0.06, 0.01),
        ConstantRate.Law(0.35, 1.5, 0.6, 0.1),
        LogBarrier.Law(4e3, 0.025, 0.0),
        ImplicitFriction.Law(0.4, 0.25),
        KelvinVoigt.Law(1e-3),
        load=Gravity(20.0),
        ground=Ground(7.0, 1.5, 0.025),
    )
    numbers = numbers_of(model)
    rng = np.random.default_rng(0)
    # Kinks up to a radian and more, turned by up to a few whole turns.
    states = rng.normal(0.0, 0.02, (WIDTH, 3 + 3 * (ELEMENTS + 1)))
    # Feet and nodes lie in the barrier and above it.
    states[:, 1] = rng.uniform(0.26, 0.27, WIDTH)
    states[:, 2] = rng.uniform(-0.01, 0.01, WIDTH)
    states[:, 3::3] += np.linspace(-0.5, 0.5, ELEMENTS + 1)
    states[:, 4::3] = rng.uniform(0.01, 0.05, (WIDTH, ELEMENTS + 1))
    states[:, 5::3] += 2.0 * np.pi / ELEMENTS * np.arange(WIDTH)[:, None]

    def solved(chosen: Any) -> Any:
        memory = make_memory(sizes_of(model, ELEMENTS + 1, lanes=len(chosen)))
        memory.numbers[...] = numbers[:, None]
        memory.state[...] = chosen.T
        memory.position_predictor[...] = 0.999 * chosen.T
        solve(model, options.masses(), memory, (0,) * len(chosen))
        parts = (memory.residual, memory.frame_residual, memory.clock[:3])
        return np.concatenate(parts).T

    together = solved(states)
    assert np.isfinite(together).all()
    for lane in range(WIDTH):
        assert np.array_equal(together[lane], solved(states[lane : lane + 1])[0])
