"""Modes of beams and arches, and how much of critical damping a law gives them."""

import numpy as np
import pytest
from families import FAMILIES
from physical import arch

from snapjump.damping.kelvin_voigt import KelvinVoigt
from snapjump.damping.mass_proportional import MassProportional
from snapjump.robot.robot import Robot
from snapjump.statics.modes import damping_ratios, flat_arch_damping, modes

# Of a straight beam between clamps: cos(k) cosh(k) = 1, omega = k^2.
CLAMPED = np.array([22.3733, 61.6728])
SCALES = Robot().scales


def straight(elements: int, name: str):
    """A beam without load between two clamps, and its state."""
    beam = arch(0.0, elements, 2.5e-4, name=name)
    state = np.zeros(beam.size)
    state[0 :: beam.node_dofs] = np.linspace(-0.5, 0.5, elements + 1)
    beam.residual(state, 0.0, 0.0)
    return beam, state


@pytest.mark.parametrize("name", FAMILIES["discretization"])
def test_a_straight_beam_has_its_frequencies_and_half_eta_omega_of_damping(name):
    beam, state = straight(80, name)
    found = modes(beam)
    np.testing.assert_allclose(found.frequencies, CLAMPED, rtol=5e-3)
    law = KelvinVoigt(relaxation_time_s=1e-5).law(SCALES)
    expected = 0.5 * 1e-5 / SCALES.time_s * found.frequencies
    np.testing.assert_allclose(damping_ratios(beam, law, state, found), expected, rtol=1e-6)


def test_mass_proportional_damping_is_over_twice_the_frequency():
    beam, state = straight(40, "der")
    found = modes(beam)
    law = MassProportional(rate_1_s=3.0).law(SCALES)
    expected = 3.0 * SCALES.time_s / (2.0 * found.frequencies)
    np.testing.assert_allclose(damping_ratios(beam, law, state, found), expected, rtol=1e-9)


def test_ratios_converge_with_the_mesh_and_grow_with_eta():
    law = KelvinVoigt(relaxation_time_s=1e-5).law(SCALES)
    members = FAMILIES["discretization"]
    coarse, fine = (flat_arch_damping(Robot(), members["der"](n), law, 0.2) for n in (60, 120))
    np.testing.assert_allclose(coarse, fine, rtol=0.02)
    other = flat_arch_damping(Robot(), members["der"](60), law._replace(relaxation_time=1e-3), 0.2)
    np.testing.assert_allclose(other / coarse, 1e-3 / law.relaxation_time, rtol=1e-9)
