"""Derivatives of edges and angles against complex steps of the plain formulas."""

from typing import Any

import numpy as np
from duals import view_duals
from numba import njit
from plain_python import complex_step

from snapjump.discretization.parts.edge import half_angle_tangent, make_edge
from snapjump.number.dual import slopes_of, value_of
from snapjump.number.lane import view_numbers
from snapjump.number.memory import aligned_zeros

FIGURES = 9  # the eight of an edge, and the angle to the next one


@njit(error_model="numpy")
def figures_of_duals(memory: Any, values: Any, slopes: Any) -> None:
    numbers = view_duals(memory)
    rows = view_numbers(slopes, (0, 0, 0, 0))
    edge = make_edge(numbers[0], numbers[1], numbers[2], numbers[3])
    after = make_edge(numbers[4], numbers[5], numbers[6], numbers[7])
    t = half_angle_tangent(edge.cx, edge.cy, after.cx, after.cy)
    figures = (
        edge.length, edge.over, edge.cx, edge.cy, edge.slope_x, edge.slope_y, edge.turn_rate,
        edge.stretch_rate, t,
    )  # fmt: skip
    for k in range(FIGURES):
        values[k] = value_of(figures[k])
        rows[k] = slopes_of(figures[k])


def plain_figures(numbers: Any) -> Any:
    edge = make_edge(*numbers[:4])
    after = make_edge(*numbers[4:])
    return np.array([*edge, half_angle_tangent(edge.cx, edge.cy, after.cx, after.cy)])


def test_edges_and_angles_of_duals():
    random = np.random.default_rng(3)
    for _ in range(20):
        memory = aligned_zeros((8, 8))
        memory[:, 0] = random.normal(size=8)
        memory[:, 4:] = random.normal(size=(8, 4))
        values = np.zeros(FIGURES)
        slopes = aligned_zeros((FIGURES, 4))
        figures_of_duals(memory, values, slopes)
        expected = complex_step(plain_figures, memory[:, 0]) @ memory[:, 4:]
        scale = np.abs(expected).max(axis=1, keepdims=True)
        assert np.allclose(values, plain_figures(memory[:, 0]), rtol=1e-13, atol=1e-13)
        assert np.max(np.abs(slopes - expected) / scale) < 1e-12
