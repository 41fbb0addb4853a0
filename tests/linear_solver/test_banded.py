"""Bordered banded elimination against dense linear algebra, in Python, scalar and in lanes."""

from typing import Any

import numpy as np
import pytest
from bare_models import on_rigid_frame
from numba import njit
from plain_python import dense, plain_work

from snapjump.engine.view import view_work
from snapjump.engine.work import make_memory, sizes_of
from snapjump.frame.parts.no_frame import NoFrame
from snapjump.linear_solver.banded import (
    begin_elimination,
    eliminate_node,
    solve_frame,
    substitute_back,
)
from snapjump.linear_solver.banded_rotations import (
    eliminate_rotating_node,
    substitute_back_rotating,
)
from snapjump.number.dispatch import routine

NODES = 12
WIDTH = 4

dofs_of_nodes = pytest.mark.parametrize("per_node", [2, 3])


@routine
def solve(work: Any, bordered: Any, rotations: Any) -> Any:
    """Number of pivots that are not positive; the solution replaces the residual."""
    zero = 0.0 * work.corner_block[0, 0]
    done = begin_elimination(zero)
    for node in range(NODES):
        if rotations:
            done = eliminate_rotating_node(work, node, bordered, done)
        else:
            done = eliminate_node(work, node, bordered, done)
    negative = done.negative
    if bordered:
        negative = negative + solve_frame(work, done)
    if rotations:
        substitute_back_rotating(work, bordered, zero)
    else:
        substitute_back(work, bordered, zero)
    return negative


@njit(error_model="numpy")
def solve_compiled(memory: Any, lanes: Any, bordered: bool, rotations: bool) -> None:
    work = view_work(memory, lanes)
    work.clock[0] = solve(work, bordered, rotations)


def fill(work: Any, seed: int, shift: float, unsymmetric: bool = False) -> tuple[Any, Any]:
    """A random system with the beam's pattern: a node is coupled to the next two, or, where it
    has three coordinates, to the next one.

    Returns the dense matrix and right-hand side. Eigenvalues rise with ``shift``.
    """
    rng = np.random.default_rng(seed)
    work.band[...] = rng.normal(size=work.band.shape)
    size = len(work.residual)
    dofs = size // NODES
    work.band[1::dofs, 5] = 0.0
    if dofs == 3:
        work.band[2::dofs, 4:] = 0.0
    for k in range(1, 6):
        work.band[size - k :, k] = 0.0
    work.band[:, 0] += shift
    work.border[:6], work.border[-6:] = rng.normal(size=(2, 6, 3))
    square = rng.normal(size=(3, 3))
    work.corner_block[...] = square + square.T + 4.0 * shift * np.eye(3)
    if unsymmetric:
        work.corner_block[0, 1:] += [2.0, -1.0]
    work.residual[...] = rng.normal(size=size)
    work.frame_residual[...] = rng.normal(size=3)
    return dense(work, 3), np.concatenate([work.frame_residual, work.residual])


@dofs_of_nodes
@pytest.mark.parametrize("seed", range(5))
@pytest.mark.parametrize("unsymmetric", [False, True])
def test_bordered_solution(seed, unsymmetric, per_node):
    work = plain_work(on_rigid_frame(per_node), NODES)
    matrix, right = fill(work, seed, 8.0, unsymmetric)
    expected = np.linalg.solve(matrix, right)
    negative = solve(work, True, per_node == 3)
    actual = np.concatenate([work.frame_residual, work.residual])
    np.testing.assert_allclose(actual, expected, rtol=0.0, atol=1e-13 * np.abs(expected).max())
    assert negative == 0.0


@dofs_of_nodes
@pytest.mark.parametrize("seed", range(5))
def test_solution_without_a_frame(seed, per_node):
    work = plain_work(on_rigid_frame(per_node)._replace(frame=NoFrame()), NODES)
    matrix, right = fill(work, seed, 8.0)
    expected = np.linalg.solve(matrix[3:, 3:], right[3:])
    assert solve(work, False, per_node == 3) == 0.0
    np.testing.assert_allclose(work.residual, expected, rtol=1e-10, atol=1e-13)


@dofs_of_nodes
@pytest.mark.parametrize("bordered", [False, True])
def test_pivots_count_negative_eigenvalues(bordered, per_node):
    counts = set()
    for seed in range(30):
        work = plain_work(on_rigid_frame(per_node), NODES)
        matrix, _ = fill(work, seed, 3.0)
        matrix = matrix if bordered else matrix[3:, 3:]
        negative = int((np.linalg.eigvalsh(matrix) < 0.0).sum())
        assert solve(work, bordered, per_node == 3) == negative
        counts.add(negative)
    assert len(counts) >= 3  # definite and indefinite ones


@dofs_of_nodes
@pytest.mark.parametrize("bordered", [False, True])
def test_lanes_and_scalars_solve_alike(bordered, per_node):
    rotations, model = per_node == 3, on_rigid_frame(per_node)
    plain = [plain_work(model, NODES) for _ in range(WIDTH)]
    lanes = make_memory(sizes_of(model, NODES, lanes=WIDTH))
    singles = [make_memory(sizes_of(model, NODES)) for _ in range(WIDTH)]
    for lane, (work, single) in enumerate(zip(plain, singles, strict=True)):
        fill(work, lane, 4.0, True)
        for name in ("residual", "band", "border", "frame_residual", "corner_block"):
            getattr(lanes, name)[..., lane] = getattr(work, name)
            getattr(single, name)[..., 0] = getattr(work, name)
    solve_compiled(lanes, (0,) * WIDTH, bordered, rotations)
    for lane, (work, single) in enumerate(zip(plain, singles, strict=True)):
        negative = solve(work, bordered, rotations)
        solve_compiled(single, (0,), bordered, rotations)
        assert lanes.clock[0, lane] == single.clock[0, 0] == negative
        for name in ("residual", "frame_residual"):
            scalar, expected = getattr(single, name)[..., 0], getattr(work, name)
            assert np.array_equal(getattr(lanes, name)[..., lane], scalar)
            near = 1e-10 * np.abs(expected).max()
            np.testing.assert_allclose(scalar, expected, rtol=0.0, atol=near)
