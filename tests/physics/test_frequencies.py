"""D1, D2: frequencies from the tangent and the lumped masses, about flat and buckled beams."""

import numpy as np
import pytest
from bands import whole
from bare_models import cantilever
from physical import DISCRETIZATIONS, arch, discretized, slender, snap
from references import outputs_of as reference
from scipy.linalg import eigh

from snapjump.discretization.base import TURN_INERTIA
from snapjump.engine.clock import ROWS
from snapjump.engine.equilibrate import equilibrate
from snapjump.engine.model import numbers_of
from snapjump.engine.work import make_work

ELEMENTS = 80
PAPER_RATIO = 2.5e-3
SLENDER = 2.5e-4  # shear, where an element has it, then bends nothing
discretizations = pytest.mark.parametrize("name", DISCRETIZATIONS)


def frequencies(tangent: np.ndarray, masses: np.ndarray, count: int) -> np.ndarray:
    """The lowest omega T."""
    squares = eigh(tangent, np.diag(masses), eigvals_only=True, subset_by_index=[0, count - 1])
    return np.sqrt(np.maximum(squares, 0.0))


def inertias(masses: np.ndarray, dofs: int) -> np.ndarray:
    """The lumped inertia of every coordinate, shape (nodes, dofs)."""
    return np.outer(masses, [1.0, 1.0, TURN_INERTIA][:dofs])


def split(tangent: np.ndarray, masses: np.ndarray, count: int) -> tuple[np.ndarray, float]:
    """The lowest frequencies of bending, and the lowest of stretching, of a straight beam."""
    dofs = len(tangent) // len(masses)
    along = np.arange(len(tangent)) % dofs == 0
    inertia = inertias(masses, dofs).ravel()
    assert not tangent[np.ix_(along, ~along)].any()
    bending = frequencies(tangent[np.ix_(~along, ~along)], inertia[~along], count)
    return bending, frequencies(tangent[np.ix_(along, along)], inertia[along], 1)[0]


def straight_tangent(elements: int, name: str, ratio: float = PAPER_RATIO):
    """Tangent and masses of the straight unloaded beam between two clamps."""
    beam = arch(0.0, elements, ratio, name=name)
    state = np.zeros(beam.size)
    state[0 :: beam.node_dofs] = np.linspace(-0.5, 0.5, elements + 1)
    assert np.abs(beam.residual(state, 0.0, 0.0)).max() <= beam.rounding
    return whole(beam.tangent_band()), beam.masses[1:-1]


def cantilever_tangent(elements: int, name: str, ratio: float) -> tuple[np.ndarray, np.ndarray]:
    length = 1.0 / elements
    rod = discretized(name, elements).beam(slender(ratio))
    dofs = rod.node_dofs()
    model = cantilever(rod)
    memory = make_work(elements + 1, 0, 2, ROWS, len(numbers_of(model)), 1, dofs)
    memory.state[0::dofs, 0] = np.linspace(0.0, 1.0, elements + 1)
    equilibrate(model, numbers_of(model), np.zeros(elements + 1), memory, False)
    masses = np.full(elements, length)
    masses[-1] *= 0.5
    return whole(memory.system.band[dofs:, :, 0]), masses


@discretizations
def test_clamped_beam(name):
    exact = reference("D1_frequencies")
    bending, stretching = split(*straight_tangent(ELEMENTS, name), 4)
    assert np.allclose(bending[:2], exact["omegaT_cc"][:2], rtol=5e-3)
    hertz = stretching / (2.0 * np.pi * exact["T_elastic"])
    assert hertz == pytest.approx(exact["f_axial1_Hz"], rel=5e-3)
    errors = [
        abs(split(*straight_tangent(n, name, SLENDER), 1)[0][0] - exact["omegaT_cc"][0])
        for n in (ELEMENTS, 2 * ELEMENTS)
    ]
    assert np.log2(errors[0] / errors[1]) == pytest.approx(2.0, abs=0.15)


@discretizations
def test_cantilever(name):
    exact = np.array(reference("D1_frequencies")["omegaT_cf"])
    errors = []
    for elements in (ELEMENTS, 2 * ELEMENTS):
        found, _ = split(*cantilever_tangent(elements, name, SLENDER), 4)
        assert np.allclose(found[:2], exact[:2], rtol=5e-3)
        errors.append(abs(found[1] - exact[1]))
    assert np.log2(errors[0] / errors[1]) == pytest.approx(2.0, abs=0.15)


@discretizations
def test_arches(name):
    """Modes about the arch buckled up and down; at the pitchfork the first one vanishes.

    There the second one falls steeply too, so that it is compared at the mesh's own critical
    angle (0.15 % off).
    """
    ratio = 3e-4
    # Newton's method needs smaller steps where shear is as stiff as here.
    steps = 41 if name == "geometrically_exact" else 11
    for row in reference("D2_modes_about_equilibria"):
        exact = np.array(row["omegaT"])
        vanishing = exact < 0.1
        alpha = row["alpha"]
        if vanishing.any():
            alpha = snap(row["eps"], ELEMENTS, ratio=ratio, name=name).alpha_rad
        beam = arch(row["eps"], ELEMENTS, ratio, name=name)
        state = beam.settle(beam.guess(row.get("state", "up") == "up"), 0.0, 0.0)
        for share in np.linspace(0.0, 1.0, steps)[1:]:
            state = beam.settle(state, share * alpha, share * alpha)
        beam.residual(state, alpha, alpha)
        inertia = inertias(beam.masses[1:-1], beam.node_dofs).ravel()
        found = frequencies(whole(beam.tangent_band()), inertia, 4)
        assert np.allclose(found[~vanishing], exact[~vanishing], rtol=0.01), row
        assert (found[vanishing] < 0.1).all()
