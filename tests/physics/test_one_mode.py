"""D3, D4: what the integrators do to one mode of a straight clamped beam, through the real march.

The beam is thick and the amplitude tiny, so that it is linear. D5, a pendulum, has no scene: its
error table belongs to the tests of the integrators.
"""

from types import SimpleNamespace

import numpy as np
import pytest
from bands import whole
from bare_models import bare_model
from physical import arch, beam
from references import outputs_of as reference
from scipy.linalg import eigh

from snapjump.engine.clamp.smooth_start import SmoothStart
from snapjump.engine.recorder.trajectory import make_recorder
from snapjump.engine.termination.timed import TimedEnding
from snapjump.frame.fixed import FixedFrame
from snapjump.scenes.runner import March
from snapjump.stepping.fixed import FixedStep

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
    still = SmoothStart(0.0, 1.0, 0.0, 0.0, 1.0)
    march = March(
        models=[bare_model(straight.beam.rod, FixedFrame.Body(0.5, 0.0), clamp=still)],
        masses=straight.beam.masses,
        states=state[None, :],
        simulation=beam(1e-5, integrator=integrator),
        ending=TimedEnding(step * steps),
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
