"""Natural frequencies, mode shapes and damping ratios of an arch between held clamps."""

from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np
from scipy.linalg import eig_banded

from snapjump.arrays import Array
from snapjump.discretization.base import ROTARY_INERTIA
from snapjump.drive.base import ClampAngles
from snapjump.engine.load.none import NoLoad
from snapjump.frame.base import NO_MESH, STILL
from snapjump.statics.arch import StaticArch


class Modes(NamedTuple):
    """Frequencies (n,), in rad/T, and shapes (n, D) of states, each of a mass of one."""

    frequencies: Array
    shapes: Array


def modes(arch: StaticArch, count: int = 2) -> Modes:
    """The lowest modes about the equilibrium that the arch was solved for last.

    Raises ArithmeticError where that is not stable.
    """
    dofs = arch.node_dofs
    inertia = np.outer(arch.masses, [1.0, 1.0, ROTARY_INERTIA][:dofs]).ravel()[arch.free]
    band = arch.tangent_band().T.copy()
    for k in range(len(band)):
        band[k, : len(inertia) - k] /= np.sqrt(inertia[: len(inertia) - k] * inertia[k:])
    # The last bits are those of the processor's LAPACK.
    squares, vectors = eig_banded(band, lower=True, select="i", select_range=(0, count - 1))
    if not squares[0] > 0.0:
        raise ArithmeticError("no frequencies about an equilibrium that is not stable")
    shapes = np.zeros((count, arch.size))
    shapes[:, arch.free] = vectors.T / np.sqrt(inertia)
    return Modes(np.sqrt(squares), shapes)


def damping_ratios(arch: StaticArch, law: Any, state: Array, found: Modes) -> Array:
    """Shares (n,) of critical damping that a law gives modes about a state between flat clamps.

    That of a mode of mass one which moves at a rate of one: the power lost, over twice its
    frequency.
    """
    angles = ClampAngles(0.0, 0.0, 0.0, 0.0)
    tangents = arch.frame.end_tangents(NO_MESH, NoLoad(), angles, state, STILL)
    lost = [arch.rod.chain_powers(law, state, shape, tangents)[0] for shape in found.shapes]
    return (np.array(lost, dtype=float) + law.drag()) / (2.0 * found.frequencies)


@lru_cache(maxsize=64)
def flat_arch_damping(robot: Any, discretization: Any, law: Any, shortening: float) -> Array:
    """Damping ratios of the first two modes of the arch between flat clamps."""
    arch = StaticArch(robot, discretization, shortening)
    state = arch.flat()
    return damping_ratios(arch, law, state, modes(arch))
