"""Solving with rows that stand in memory or only in registers: the same to the last bit."""

import numpy as np
import pytest
from plain_python import plain_work
from robots import DESIGNS, small_march

from snapjump.engine.assemble import Motion
from snapjump.engine.linearised import ENDS, solve_in_registers, solve_linearised

MOTION = Motion(0.02, 2e3, 2e3, 0.0)


@pytest.fixture(scope="module")
def striking():
    """A robot's model, masses, and a state whose middle touches the ground."""
    march = small_march([DESIGNS[1]], 1)
    state = march.queue.state[0].copy()
    middle = 3 + 2 * (len(march.masses) // 2)
    state[middle + 1 - 4 : middle + 1 + 5 : 2] = 5e-3
    return march.models[0], march.masses, state


def solved(solve, model, masses, state):
    work = plain_work(model, len(masses), 3)
    work.state[:] = work.start[:] = state
    work.position_predictor[:] = state - 1e-4
    return solve(model, MOTION, masses, work), work


def test_registers_change_no_bit(striking):
    model, masses, _ = striking
    assert len(masses) > 2 * ENDS
    (figures, memory), (found, registers) = (
        solved(solve, *striking) for solve in (solve_linearised, solve_in_registers)
    )
    assert figures == found
    assert figures.extremes.contact_rate_squared > 0.0
    for part in ("residual", "frame_residual", "band", "border", "corner_block"):
        assert np.array_equal(getattr(memory, part), getattr(registers, part)), part
