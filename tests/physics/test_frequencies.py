"""D1, D2: frequencies from the tangent and the lumped masses, about flat and buckled beams."""

import numpy as np
import pytest
from scipy.linalg import eigh

from snapjump.clamp.constant_rate import ConstantRate
from snapjump.contact.none import NoContact
from snapjump.damping.none import NoDamping
from snapjump.discretization.der import DiscreteElasticRod
from snapjump.engine.clock import ROWS
from snapjump.engine.equilibrate import equilibrate
from snapjump.engine.model import Model, numbers_of
from snapjump.engine.work import make_work
from snapjump.frame.cantilever import CantileverFrame
from snapjump.friction.none import NoFriction
from snapjump.load.tip import TipLoad

ELEMENTS = 80
PAPER_RATIO = 2.5e-3


def full(band: np.ndarray) -> np.ndarray:
    """The matrix of a lower band (6, size)."""
    size = band.shape[1]
    matrix = sum(np.diag(band[k, : size - k], -k) for k in range(6))
    return matrix + np.tril(matrix, -1).T


def frequencies(tangent: np.ndarray, masses: np.ndarray, count: int) -> np.ndarray:
    """The lowest omega T."""
    squares = eigh(tangent, np.diag(masses), eigvals_only=True, subset_by_index=[0, count - 1])
    return np.sqrt(np.maximum(squares, 0.0))


def straight_tangent(arch, elements: int = ELEMENTS, ratio: float = PAPER_RATIO):
    """Tangent and masses of the straight unloaded beam between two clamps."""
    beam = arch(0.0, elements, ratio)
    state = np.zeros(beam.size)
    state[0::2] = np.linspace(-0.5, 0.5, elements + 1)
    assert np.abs(beam.residual(state, 0.0, 0.0)).max() < 1e-6
    return full(beam.tangent_band()), beam.masses[1:-1]


def cantilever_tangent(elements: int) -> tuple[np.ndarray, np.ndarray]:
    length = 1.0 / elements
    model = Model(
        DiscreteElasticRod(length, 12.0 / PAPER_RATIO**2, 0.5 * length, 0.0),
        CantileverFrame(),
        ConstantRate(0.0, 1.0, 1.0, 0.0),
        NoContact(),
        NoFriction(),
        NoDamping(),
        TipLoad(0.0, 0.0, 0.0),
    )
    memory = make_work(elements + 1, 0, 2, ROWS, len(numbers_of(model)), 1)
    memory.state[0::2, 0] = np.linspace(0.0, 1.0, elements + 1)
    equilibrate(model, numbers_of(model), np.zeros(elements + 1), memory, False)
    masses = np.full(elements, length)
    masses[-1] *= 0.5
    return full(np.ascontiguousarray(memory.system.band[2:, :, 0].T)), masses


def test_clamped_beam(arch, reference):
    exact = reference("D1_frequencies")
    tangent, masses = straight_tangent(arch)
    bending = frequencies(tangent[1::2, 1::2], masses, 4)
    assert np.allclose(bending[:2], exact["omegaT_cc"][:2], rtol=5e-3)
    stretching = frequencies(tangent[0::2, 0::2], masses, 1)[0]
    hertz = stretching / (2.0 * np.pi * exact["T_elastic"])
    assert hertz == pytest.approx(exact["f_axial1_Hz"], rel=5e-3)
    tangent, masses = straight_tangent(arch, 2 * ELEMENTS)
    fine = frequencies(tangent[1::2, 1::2], masses, 4)
    errors = np.abs([bending[0] - exact["omegaT_cc"][0], fine[0] - exact["omegaT_cc"][0]])
    assert np.log2(errors[0] / errors[1]) == pytest.approx(2.0, abs=0.15)


def test_cantilever(reference):
    exact = np.array(reference("D1_frequencies")["omegaT_cf"])
    errors = []
    for elements in (ELEMENTS, 2 * ELEMENTS):
        tangent, masses = cantilever_tangent(elements)
        found = frequencies(tangent[1::2, 1::2], masses, 4)
        assert np.allclose(found[:2], exact[:2], rtol=5e-3)
        errors.append(abs(found[1] - exact[1]))
    assert np.log2(errors[0] / errors[1]) == pytest.approx(2.0, abs=0.15)


def test_arches(arch, snap, reference):
    """Modes about the arch buckled up and down; at the pitchfork the first one vanishes.

    There the second one falls steeply too, so that it is compared at the mesh's own critical
    angle (0.15 % off).
    """
    ratio = 3e-4
    for row in reference("D2_modes_about_equilibria"):
        exact = np.array(row["omegaT"])
        vanishing = exact < 0.1
        alpha = row["alpha"]
        if vanishing.any():
            alpha = snap(row["eps"], ELEMENTS, ratio=ratio).alpha_rad
        beam = arch(row["eps"], ELEMENTS, ratio)
        state = beam.settle(beam.guess(row.get("state", "up") == "up"), 0.0, 0.0)
        for share in np.linspace(0.1, 1.0, 10):
            state = beam.settle(state, share * alpha, share * alpha)
        beam.residual(state, alpha, alpha)
        found = frequencies(full(beam.tangent_band()), np.repeat(beam.masses[1:-1], 2), 4)
        assert np.allclose(found[~vanishing], exact[~vanishing], rtol=0.01), row
        assert (found[vanishing] < 0.1).all()
