"""What every contact law promises: consistent derivatives, and no pull."""

import itertools

import numpy as np
import pytest
from families import FAMILIES
from numba import njit

from snapjump.contact.base import ContactState, at_rest, derived_slope, force_if_active
from snapjump.contact.hunt_crossley import damping_number
from snapjump.contact.signorini import SKIN
from snapjump.number.dispatch import PROGRAM
from snapjump.robot.robot import Robot

OPTIONS = {name: cls for name, cls in FAMILIES["contact"].items() if name != "none"}
SCALES = Robot().scales
VARIANTS = {
    **{name: cls() for name, cls in OPTIONS.items()},
    "logbarrier damped": OPTIONS["logbarrier"](damping_s=1e-6),
    "hunt_crossley elastic": OPTIONS["hunt_crossley"](restitution=1.0),
}
laws = pytest.mark.parametrize("name", sorted(VARIANTS))
STEP = 1e-30
program = njit(**{**PROGRAM, "cache": False})


def push(law, gap, state):
    """Force and slope."""
    return law.force(gap, state), law.slope(gap, state)


def law_and_gaps(name):
    law = VARIANTS[name].law(SCALES)
    if law.keeps_open():
        return law, law.reach() * np.array([1e-6, 0.01, 0.3, 0.7, 0.8, 0.95, 0.999, 1.0])
    return law, law.reach() - np.array([1e-6, 1e-4, 2e-3])


@program
def derived_and_own(law, gap, state):
    return derived_slope(law, gap, state), law.slope(gap, state)


@laws
def test_stiffness_is_the_force_s_total_derivative(name):
    """By complex steps: the gap moves, and the speed with it at the stage's rate. It is the derived
    one, compiled, by dual numbers, and in plain Python, by a complex step."""
    law, gaps = law_and_gaps(name)
    rate = 400.0
    for gap, speed in itertools.product(gaps, (0.0, -0.7, 0.4)):
        state = ContactState(speed, rate, gap - speed / rate, speed, 0.3)
        moved = np.complex128(complex(gap, STEP))
        now = state._replace(speed=speed + rate * (moved - gap))
        slope = -np.imag(law.force(moved, now)) / STEP
        derived, own = derived_and_own(law, gap, state)
        for stiffness in (own, np.real(law.slope(np.complex128(gap), state))):
            assert stiffness == pytest.approx(slope, rel=1e-10, abs=1e-9)
        assert derived == pytest.approx(own, rel=1e-12, abs=1e-12)
        assert derived_slope(law, gap, state) == pytest.approx(own, rel=1e-9, abs=1e-9)


@laws
def test_force_at_rest_is_the_gradient_of_the_energy(name):
    law, gaps = law_and_gaps(name)
    if name == "signorini":
        assert law.energy(gaps[0]) == 0.0
        return
    for gap in gaps:
        slope = -np.imag(law.energy(np.complex128(complex(gap, STEP)))) / STEP
        assert law.force(gap, at_rest(gap)) == pytest.approx(slope, rel=1e-10)


@laws
def test_no_law_pulls_and_none_gives_energy(name):
    law, gaps = law_and_gaps(name)
    for gap, speed in itertools.product(gaps, (-2000.0, -3.0, 0.0, 3.0, 2000.0)):
        state = ContactState(speed, 400.0, gap + 1e-9, speed, 0.3)
        active, force, stiffness = force_if_active(law, gap, state)
        assert force >= 0.0
        assert np.isfinite([force, stiffness]).all()
        # An impact law takes energy at the end of a step, by the change of the speed in it.
        if active and name != "signorini":
            assert law.loss(gap, state) >= -1e-12 * force * abs(speed)


@laws
def test_nothing_acts_out_of_reach(name):
    law, _ = law_and_gaps(name)
    gap = law.reach() + 1e-9
    active, force, stiffness = force_if_active(law, gap, at_rest(gap))
    assert not active and force == stiffness == 0.0
    assert VARIANTS[name].ground(SCALES, None).clearance >= law.reach()
    assert not law.active(0.1, ContactState(-1.0, 400.0, 0.1025, -1.0, 0.0))


def test_energy_taken_by_damping_is_force_times_speed():
    law = VARIANTS["logbarrier damped"].law(SCALES)
    gap = 0.5 * law.reach()
    elastic, stiffness = push(law, gap, at_rest(gap))
    speed = -0.2
    lost = law.loss(gap, ContactState(speed, 0.0, gap, speed, 0.0))
    assert lost == pytest.approx(law.relaxation_time * stiffness * speed**2, rel=1e-9)


def test_damping_number_of_hunt_and_crossley():
    """The relation that the impact of one mass integrates to, and its limit for little damping."""
    for restitution in (0.05, 0.3, 0.5, 0.8, 0.99):
        u = damping_number(restitution)
        assert 0.0 < u < 1.0 / restitution
        left = (1.0 + restitution) * u
        assert left == pytest.approx(np.log((1.0 + u) / (1.0 - restitution * u)), rel=1e-9)
    assert damping_number(0.999) == pytest.approx(1.5 * 0.001, rel=5e-3)
    assert damping_number(1.0) == 0.0


def test_signorini_s_target():
    """Newton's impact law where the gap would close, the ground elsewhere."""
    law = OPTIONS["signorini"](restitution=0.5).law(SCALES)
    rate = 1e4

    def target(begun, speed):
        """The gap at which the force vanishes, of a mass of one."""
        force, stiffness = push(law, -0.1, ContactState(speed, rate, begun, speed, 1.0))
        return force / stiffness - 0.1

    assert target(0.3, -1.0) == pytest.approx(SKIN)  # far away
    assert target(1e-5, -1.0) == pytest.approx(1e-5 + 0.5 * 1.0 / rate)  # strikes, rebounds
    assert target(1e-5, 1.0) == pytest.approx(SKIN)  # leaves
    assert target(SKIN, 0.0) == pytest.approx(SKIN)  # rests
