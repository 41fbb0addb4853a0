"""Chains of elements with their strains, written down independently and by complex-safe geometry.

Discrete elastic rods by their turning angles; elements whose nodes turn by Crisfield's rotations of
the ends against the chord, and by Simo and Reissner's strains at the middle.
"""

from typing import Any

import numpy as np

from snapjump.discretization.corotational import Corotational
from snapjump.discretization.der import DiscreteElasticRod
from snapjump.discretization.geometrically_exact import GeometricallyExact
from snapjump.robot.robot import Robot

ELEMENTS = 9
LENGTH = 1.0 / ELEMENTS


class Rod:
    """A discrete elastic rod, turned at its ends by the clamps' directions."""

    dofs, close, closest = 2, 1e-8, 1e-8

    def __init__(self, clamp: str):
        self.beam = DiscreteElasticRod(ELEMENTS, clamp).beam(Robot())

    def bent(self, seed: int) -> Any:
        """A random arch, 0.1 % stretched, with kinks."""
        nodes = ELEMENTS + 1 if self.beam.clamp_offset == 0.0 else ELEMENTS - 1
        return np.ravel(kinked(np.random.default_rng(seed), nodes, 0.2))

    def strains(self, q: Any, left: Any, right: Any, held: float = 1.0) -> Any:
        """Strains whose squares sum up to twice the energy, by complex-safe geometry."""
        rod = self.beam
        ex, ey = np.diff(q[0::2]), np.diff(q[1::2])
        lengths = np.sqrt(ex * ex + ey * ey)
        cx = np.concatenate([[np.cos(left)], ex / lengths, [np.cos(right)]])
        cy = np.concatenate([[np.sin(left)], ey / lengths, [np.sin(right)]])
        sine = cx[:-1] * cy[1:] - cy[:-1] * cx[1:]
        cosine = cx[:-1] * cx[1:] + cy[:-1] * cy[1:]
        bending = 2.0 * sine / (1.0 + cosine)
        hinges = np.full(len(bending), rod.element_length)
        hinges[[0, -1]] = rod.clamp_hinge_length
        bending = bending / np.sqrt(hinges)
        bending[-1] = held * bending[-1]
        stretch = np.sqrt(rod.stretching_stiffness / rod.element_length)
        return np.concatenate([stretch * (lengths - rod.element_length), bending])

    def moments(self, gradient: Any) -> Any:
        """The clamps' directions are where the left hinge begins and where the right one ends."""
        return [-gradient[-2], gradient[-1]]

    def tip_turn(self, q: Any) -> Any:
        return np.arctan((q[-1] - q[-3]) / (q[-2] - q[-4]))


class Turning:
    """Elements whose nodes turn: the third coordinate is the rotation times the length."""

    dofs, close, closest = 3, 1e-9, 1e-10

    def __init__(self, beam: Any):
        self.beam = beam

    def bent(self, seed: int) -> Any:
        rng = np.random.default_rng(seed)
        places = kinked(rng, ELEMENTS + 1, 0.1)
        turns = np.linspace(1.0, -1.0, ELEMENTS + 1) + rng.uniform(-0.1, 0.1, ELEMENTS + 1)
        return np.ravel(np.column_stack([places, LENGTH * turns]))

    def strains(self, q: Any, left: Any, right: Any, held: float = 1.0) -> Any:
        beam = self.beam
        ex, ey = np.diff(q[0::3]), np.diff(q[1::3])
        theta = q[2::3] / LENGTH
        stretch = np.sqrt(beam.stretching_stiffness / LENGTH)
        if isinstance(beam, Corotational.Beam):
            chord = np.arctan(ey / ex)
            ends = np.array([theta[:-1] - chord, theta[1:] - chord])
            root = np.linalg.cholesky(np.array([[4.0, 2.0], [2.0, 4.0]]) / LENGTH)
            lengths = np.sqrt(ex * ex + ey * ey)
            return np.concatenate([stretch * (lengths - LENGTH), *(root.T @ ends)])
        middle = 0.5 * (theta[:-1] + theta[1:])
        c, s = np.cos(middle), np.sin(middle)
        shearing = np.sqrt(beam.shear_stiffness / LENGTH) * (c * ey - s * ex)
        bending = np.diff(theta) / np.sqrt(LENGTH)
        return np.concatenate([stretch * (c * ex + s * ey - LENGTH), shearing, bending])

    def moments(self, gradient: Any) -> Any:
        """The left clamp's counts against its direction, as of a hinge that begins there."""
        return [-LENGTH * gradient[2], LENGTH * gradient[-3]]

    def tip_turn(self, q: Any) -> Any:
        return q[-1] / LENGTH


def kinked(rng: Any, nodes: int, kink: float) -> Any:
    """Places (nodes, 2) of an arch."""
    turns = np.linspace(0.9, -0.9, nodes - 1) + rng.uniform(-kink, kink, nodes - 1)
    lengths = LENGTH * (1.0 + rng.uniform(-1e-3, 1e-3, nodes - 1))
    steps = np.column_stack([lengths * np.cos(turns), lengths * np.sin(turns)])
    return np.concatenate([np.zeros((1, 2)), np.cumsum(steps, axis=0)])


RODS = {clamp: Rod(clamp) for clamp in ("half_element", "two_nodes")}
TURNING = {
    "corotational": Turning(Corotational.Beam(LENGTH, 2e5)),
    "geometrically_exact": Turning(GeometricallyExact.Beam(LENGTH, 2e5, 6e4)),
}
CHAINS = RODS | TURNING
