"""More right-hand sides against dense linear algebra."""

from typing import Any

import numpy as np
import pytest
from bare_models import on_rigid_frame
from numba import njit
from plain_python import whole
from scipy.linalg import block_diag

from snapjump.engine.view import view_memory
from snapjump.engine.work import make_memory, sizes_of
from snapjump.linear_solver.right_hand_sides import solve_right_hand_sides
from snapjump.number.memory import aligned_zeros

NODES = 9
LANES = 4


@njit(cache=True, error_model="numpy")
def solve_compiled(
    memory: Any, sides: Any, frame_sides: Any, chosen: Any, count: int, rotations: bool
) -> None:
    solve_right_hand_sides(view_memory(memory), sides, frame_sides, chosen, count, rotations)


def factors(per_node: int) -> Any:
    """Random factors as an elimination leaves them: one over a pivot, L D, and the border's."""
    system = make_memory(sizes_of(on_rigid_frame(per_node), NODES, lanes=LANES))
    random = np.random.default_rng(per_node)
    for array in (system.band, system.border, system.corner_block):
        array[:] = 0.3 * random.normal(size=array.shape)
    system.band[:, 0] = 1.0 + random.random(system.band[:, 0].shape)
    system.corner_block[:] += 3.0 * np.eye(3)[:, :, None]
    size = len(system.band)
    for k in range(1, 6):
        system.band[size - k :, k] = 0.0
    if per_node == 2:
        system.band[1::2, 5] = 0.0  # the column of a node's y reaches four rows down
    return system


def eliminated(system: Any, lane: int) -> Any:
    """The matrix that was, from its factors."""
    band, border, corner = (
        array[..., lane] for array in (system.band, system.border, system.corner_block)
    )
    over = band[:, :1]
    columns = np.hstack([np.ones_like(over), band[:, 1:6] * over])
    lower = block_diag(np.tril(whole(columns)), np.eye(3))
    lower[-3:, :-3] = (border * over).T
    return lower @ block_diag(np.diag(1.0 / band[:, 0]), corner) @ lower.T


@pytest.mark.parametrize("per_node", [2, 3])
def test_solutions_of_the_chosen_lanes_alone(per_node):
    system = factors(per_node)
    size = per_node * NODES
    random = np.random.default_rng(7)
    sides = aligned_zeros((LANES, size + 10, 4))
    frame_sides = aligned_zeros((LANES, 3, 4))
    sides[:, 5:-5] = random.normal(size=(LANES, size, 4))
    frame_sides[:] = random.normal(size=frame_sides.shape)
    given = np.concatenate([sides[:, 5:-5], frame_sides], axis=1)
    chosen = np.array([2, 0, 3, 1])
    solve_compiled(system, sides, frame_sides, chosen, 3, per_node == 3)
    found = np.concatenate([sides[:, 5:-5], frame_sides], axis=1)
    for lane in (0, 2, 3):
        expected = np.linalg.solve(eliminated(system, lane), given[lane])
        assert np.allclose(found[lane], expected, rtol=1e-11, atol=1e-11)
    assert np.array_equal(found[1], given[1])
    assert not sides[:, :5].any() and not sides[:, -5:].any()
