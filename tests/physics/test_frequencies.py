"""D1 to D4: frequencies about flat and buckled beams, and what integrators do to one mode."""

from types import SimpleNamespace

import numpy as np
import pytest
from bare_models import bare_model, cantilever
from physical import DISCRETIZATIONS, arch, beam, discretized, slender, snap
from plain_python import whole
from references import outputs_of as reference
from scipy.linalg import eigh

from snapjump.discretization.base import ROTARY_INERTIA
from snapjump.drive.smooth_start import SmoothStart
from snapjump.engine.equilibrate import equilibrate
from snapjump.engine.model import numbers_of
from snapjump.engine.recorder.trajectory import make_recorder
from snapjump.engine.termination.timed import TimedTermination
from snapjump.engine.work import make_memory, sizes_of
from snapjump.frame.fixed import FixedFrame
from snapjump.scenes.runner import March
from snapjump.stepping.fixed import FixedStep

ELEMENTS = 80
PAPER_RATIO = 2.5e-3
SLENDER = 2.5e-4  # shear, where an element has it, then bends nothing
discretizations = pytest.mark.parametrize("name", DISCRETIZATIONS)


def frequencies(tangent: np.ndarray, masses: np.ndarray, count: int) -> np.ndarray:
    """The lowest frequencies (omega T)."""
    squares = eigh(tangent, np.diag(masses), eigvals_only=True, subset_by_index=[0, count - 1])
    return np.sqrt(np.maximum(squares, 0.0))


def inertias(masses: np.ndarray, dofs: int) -> np.ndarray:
    """The lumped inertia of every coordinate, shape (nodes, dofs)."""
    return np.outer(masses, [1.0, 1.0, ROTARY_INERTIA][:dofs])


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
    memory = make_memory(sizes_of(model, elements + 1))
    memory.state[0::dofs, 0] = np.linspace(0.0, 1.0, elements + 1)
    equilibrate(model, numbers_of(model), np.zeros(elements + 1), memory, False)
    masses = np.full(elements, length)
    masses[-1] *= 0.5
    return whole(memory.band[dofs:, :, 0]), masses


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
        state = beam.solve_equilibrium(beam.guess(row.get("state", "up") == "up"), 0.0, 0.0)
        for share in np.linspace(0.0, 1.0, steps)[1:]:
            state = beam.solve_equilibrium(state, share * alpha, share * alpha)
        beam.residual(state, alpha, alpha)
        inertia = inertias(beam.masses[1:-1], beam.node_dofs).ravel()
        found = frequencies(whole(beam.tangent_band()), inertia, 4)
        assert np.allclose(found[~vanishing], exact[~vanishing], rtol=0.01), row
        assert (found[vanishing] < 0.1).all()


# D3, D4: a beam so thick and an amplitude so tiny that it is linear, through the real march.
RATIO = 0.05
AMPLITUDE = 1e-8
NAMES = {"implicit_euler": "IE", "tr_bdf2": "TRBDF2", "sdirk2": "SDIRK2"}


@pytest.fixture(scope="module")
def straight():
    """The straight beam of 80 elements with the modes and frequencies of its tangent."""
    beam = arch(0.0, 80, RATIO)
    state = np.zeros(beam.size)
    state[0::2] = np.linspace(-0.5, 0.5, 81)
    beam.residual(state, 0.0, 0.0)
    transverse = whole(beam.tangent_band()[1::2, ::2])
    squares, modes = eigh(transverse, np.diag(beam.masses[1:-1]))
    return SimpleNamespace(beam=beam, state=state, omega=np.sqrt(squares), modes=modes)


def marched(straight, integrator, mode, place, speed, step, steps) -> tuple[float, float]:
    """Amplitude and velocity (over omega) of a mode after a number of steps."""
    shape, omega = straight.modes[:, mode], straight.omega[mode]
    state, velocity = straight.state.copy(), np.zeros_like(straight.state)
    state[3:-2:2] = AMPLITUDE * place * shape
    velocity[3:-2:2] = AMPLITUDE * speed * omega * shape
    still = SmoothStart.Law(0.0, 1.0, 0.0, 0.0, 1.0, 1.0)
    march = March(
        models=[bare_model(straight.beam.rod, FixedFrame.Body(0.5, 0.0), clamp=still)],
        masses=straight.beam.masses,
        states=state[None, :],
        simulation=beam(1e-5, integrator=integrator),
        termination=TimedTermination(step * steps),
        recorder=make_recorder(len(state), step * steps, step * steps),
        velocities=velocity[None, :],
    )
    march.stepping = FixedStep.Control(step, 1e-6 * AMPLITUDE)
    # The march derives accelerations itself, except for the first one.
    march.queue.acceleration[0, 3:-2:2] = -(omega**2) * AMPLITUDE * place * shape
    march.run()
    weights = shape * straight.beam.masses[1:-1] / AMPLITUDE
    last, speeds = march.memory.start[:, 0], march.memory.velocity[0, :, 0]
    return float(last[3:-2:2] @ weights), float(speeds[3:-2:2] @ weights / omega)


@pytest.mark.parametrize("integrator", NAMES)
def test_amplification(integrator, straight):
    """Spectral radius and phase error of one step."""
    name = NAMES[integrator]
    for row in reference("D3_linear_amplification"):
        step = row["omega_h"] / straight.omega[0]
        columns = [
            marched(straight, integrator, 0, place, speed, step, 1)
            for place, speed in ((1.0, 0.0), (0.0, 1.0))
        ]
        values = np.linalg.eigvals(np.array(columns).T)
        assert np.abs(values).max() == pytest.approx(row[name], rel=1e-9)
        if row[name + "_phase"] is not None:
            phase = np.abs(np.angle(values)).max() / row["omega_h"] - 1.0
            assert phase == pytest.approx(row[name + "_phase"], abs=1e-9)


@pytest.mark.parametrize("step_s", [1e-5, 1e-6, pytest.param(1e-7, marks=pytest.mark.slow)])
def test_implicit_euler_damps_a_beam(step_s, straight):
    """Energy left of a mode after a period."""
    expected = reference("D4_IE_beam_damping")[f"{step_s:.0e}"]
    step = step_s / reference("D1_frequencies")["T_elastic"]
    for mode, share in enumerate(expected):
        period = 2.0 * np.pi / straight.omega[mode]
        steps = max(1, round(period / step))
        place, speed = marched(straight, "implicit_euler", mode, 1.0, 0.0, step, steps)
        # Whole steps do not make a period: compare the loss of energy per period.
        left = (place**2 + speed**2) ** (period / (steps * step))
        assert left == pytest.approx(share, rel=0.02)
