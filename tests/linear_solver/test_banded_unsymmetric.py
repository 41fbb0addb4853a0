"""Unsymmetric elimination with four right-hand sides against dense linear algebra."""

from typing import Any

import numpy as np
import pytest
from bare_models import on_rigid_frame
from numba import njit

from snapjump.discretization.base import HALF_BANDWIDTH, RIGHT, SKEW
from snapjump.engine.tangent import make_tangent_state, view_tangent, with_exact_system
from snapjump.engine.view import view_work
from snapjump.engine.work import make_memory, sizes_of
from snapjump.linear_solver.banded_unsymmetric import (
    eliminate_frame,
    eliminate_unsymmetric,
    solve_sides,
)
from snapjump.linear_solver.contact_rows import rows_of
from snapjump.number.dispatch import kernel
from snapjump.number.lane import view_numbers
from snapjump.number.memory import aligned_zeros

NODES = 9


@kernel
def put(array: Any, given: Any, lanes: Any) -> None:
    """Fill a part of a memory."""
    numbers = view_numbers(given, lanes)
    for i in range(numbers.shape[0]):
        for k in range(numbers.shape[1]):
            array[i, k] = numbers[i, k]


@njit(error_model="numpy")
def solve_compiled(
    memory: Any, tangent: Any, system: Any, sides: Any, lanes: Any, four: Any, dofs: int
) -> None:
    twin = view_tangent(view_work(memory, lanes), tangent)
    work = with_exact_system(twin)
    put(work.band, system[0], lanes)
    put(work.skew, system[1], lanes)
    put(work.border, system[2], lanes)
    put(work.border_skew, system[3], lanes)
    put(work.corner_block, system[4], lanes)
    given = view_numbers(sides, four)
    size = given.shape[0] - 3
    for k in range(3):
        twin.bare_frame_residual[k] = given[k]
    for i in range(size):
        twin.bare_residual[i] = given[3 + i]
    for node in range(NODES):
        eliminate_unsymmetric(work, node, dofs, rows_of(work, dofs * node), True)
    eliminate_frame(work)
    solve_sides(work, twin.bare_padded_residual, twin.bare_frame_residual)
    for k in range(3):
        given[k] = twin.bare_frame_residual[k]
    for i in range(size):
        given[3 + i] = twin.bare_residual[i]


def dense(system: Any, lane: int) -> Any:
    """The matrix of a lane, the frame's coordinates first."""
    band, skew, border, border_skew, corner = (array[..., lane] for array in system)
    size = len(band)
    matrix = np.zeros((3 + size, 3 + size))
    matrix[:3, :3] = corner
    matrix[3:, :3] = border + border_skew[:, :3]
    matrix[:3, 3:] = (border + border_skew[:, 3:]).T
    for j in range(size):
        matrix[3 + j, 3 + j] = band[j, 0] + skew[j, 0]
        for k in range(1, min(RIGHT, size - j)):
            matrix[3 + j + k, 3 + j] = band[j, k] + skew[j, k]
            matrix[3 + j, 3 + j + k] = band[j, k] + skew[j, HALF_BANDWIDTH + k]
    return matrix


def random_system(dofs: int, lanes: int) -> Any:
    """With the pattern of a beam on a frame: columns end with the last coordinate of a node."""
    random = np.random.default_rng(dofs)
    size = dofs * NODES
    shapes = ((size, RIGHT), (size, SKEW), (size, 3), (size, 6), (3, 3))
    system = [aligned_zeros((*shape, lanes)) for shape in shapes]
    for array in system:
        array[...] = 0.3 * random.normal(size=array.shape)
    for array in system[:2]:
        for axis in range(1, dofs):
            array[axis::dofs, RIGHT - axis : RIGHT] = 0.0
    for axis in range(1, dofs):
        system[1][axis::dofs, SKEW - axis :] = 0.0
    for k in range(1, RIGHT):
        system[0][size - k :, k] = system[1][size - k :, k] = 0.0
        system[1][size - k :, HALF_BANDWIDTH + k] = 0.0
    system[0][:, 0] += 3.0
    system[4][...] += 3.0 * np.eye(3)[:, :, None]
    return tuple(system)


@pytest.mark.parametrize("dofs", [2, 3])
@pytest.mark.parametrize("width", [1, 8])
def test_solutions_are_those_of_the_dense_matrix(dofs: int, width: int) -> None:
    memory = make_memory(sizes_of(on_rigid_frame(dofs), NODES, lanes=width))
    system = random_system(dofs, width)
    size = 3 + dofs * NODES
    sides = aligned_zeros((size, 4 * width))
    sides[...] = np.random.default_rng(7).normal(size=sides.shape)
    given = sides.copy()
    lanes = (0,) * width
    solve_compiled(memory, make_tangent_state(memory), system, sides, lanes, 4 * lanes, dofs)
    for lane in range(width):
        expected = np.linalg.solve(dense(system, lane), given[:, lane::width])
        np.testing.assert_allclose(sides[:, lane::width], expected, rtol=1e-9, atol=1e-10)
