"""The barrier against exact derivatives, its paper, and C1 to C3 of references/physics.json."""

import cmath
import math

import numpy as np
import pytest

from snapjump.contact.base import RESTING_SPEED, at_rest
from snapjump.contact.logbarrier import LogBarrier
from snapjump.contact.none import NoContact
from snapjump.units import Scales

LAW = LogBarrier.Law(3.0e4, 0.025, 0.0)
UNIT = LogBarrier.Law(1.0, 1.0, 0.0)


def force_at(law, gap):
    """Force and stiffness at rest."""
    return law.force(gap, at_rest(gap)), law.slope(gap, at_rest(gap))


shares = pytest.mark.parametrize("share", [1e-6, 0.01, 0.3, 0.8, 0.999, 1.0])


@shares
def test_force_and_stiffness_are_derivatives_of_the_energy(share):
    gap = share * LAW.distance
    step = 1e-30 * gap
    moved = np.complex128(complex(gap, step))
    force, stiffness = force_at(LAW, gap)
    scale = LAW.stiffness * LAW.distance
    slope = LAW.energy(moved).imag / step
    assert force == pytest.approx(-slope, rel=1e-10, abs=1e-13 * scale)
    curvature = -force_at(LAW, moved)[0].imag / step
    assert stiffness == pytest.approx(curvature, rel=1e-10, abs=1e-12 * LAW.stiffness)


def test_energy_is_the_paper_s():
    gap = 0.4 * LAW.distance
    expected = -LAW.stiffness * (gap - LAW.distance) ** 2 * cmath.log(gap / LAW.distance).real
    assert LAW.energy(gap) == pytest.approx(expected, rel=1e-14)
    # The paper prints the bracket of dE/dd; what pushes upwards is its negative.
    ratio = gap / LAW.distance
    printed = (gap - LAW.distance) * (2.0 * math.log(ratio) - LAW.distance / gap + 1.0)
    assert force_at(LAW, gap)[0] == pytest.approx(LAW.stiffness * printed, rel=1e-12)
    assert force_at(LAW, gap)[0] > 0.0


def test_continuous_to_second_order_where_contact_begins():
    assert LAW.reach() == LAW.distance
    for share in (1.0, 1.0 - 1e-9):
        gap = share * LAW.distance
        force, stiffness = force_at(LAW, gap)
        assert abs(LAW.energy(gap)) < 1e-20
        assert abs(force) < 1e-10
        assert abs(stiffness) < 1e-3


def test_force_and_stiffness_grow_without_bound_as_the_gap_closes():
    gaps = [LAW.distance * 10.0**-k for k in range(8)]
    forces, stiffnesses = zip(*(force_at(LAW, g) for g in gaps), strict=True)
    assert list(forces) == sorted(forces)
    assert list(stiffnesses) == sorted(stiffnesses)
    assert forces[-1] * gaps[-1] == pytest.approx(LAW.stiffness * LAW.distance**2, rel=1e-4)


@pytest.mark.parametrize(
    ("speed", "lowest", "force", "frequency"),
    [
        # C1_barrier_nondim: vhat, xmin, phimax, omega_max
        (0.01, 0.9633872897, 0.004122726678, 0.4775567516),
        (0.5, 0.5457071074, 0.9284977147, 2.287862784),
        (1.0, 0.3291860076, 2.857708408, 3.811307218),
        (3.0, 0.01012703437, 105.8477944, 99.77157981),
        (5.0, 3.72630602e-06, 268385.2856, 268363.2855),
    ],
)
def test_lowest_point_of_a_bounce(speed, lowest, force, frequency):
    assert UNIT.energy(lowest) == pytest.approx(0.5 * speed**2, rel=1e-7)
    pushed, stiffness = force_at(UNIT, lowest)
    assert pushed == pytest.approx(force, rel=1e-8)
    assert math.sqrt(stiffness) == pytest.approx(frequency, rel=1e-8)


def test_lowest_point_of_a_bounce_in_si_units():
    # C2_barrier_dim: m = 4 g, v = 1 m/s, and a beam node at 10 m/s
    law = LogBarrier.Law(1e4, 5e-4, 0.0)
    for mass, speed, lowest, force, frequency in (
        (0.004, 1.0, 0.0001226955281, 22.20411361, 7836.888746),
        (7.575757576e-07, 10.0, 0.0003816042592, 1.007199562, 157436.2187),
    ):
        assert law.energy(lowest) == pytest.approx(0.5 * mass * speed**2, rel=1e-7)
        pushed, stiffness = force_at(law, lowest)
        assert pushed == pytest.approx(force, rel=1e-8)
        assert math.sqrt(stiffness / mass) == pytest.approx(frequency, rel=1e-8)


@pytest.mark.parametrize(
    ("mass", "gap", "frequency"),
    [
        # C3_rest_gap: m (kg), gap (m), vertical frequency (1/s); g = 10 m/s^2
        (0.004, 0.0004746245217, 895.6616223),
        (0.002, 0.0004819647953, 1059.610783),
        (4e-05, 0.0004974224555, 2787.960803),
    ],
)
def test_gap_at_rest(mass, gap, frequency):
    force, stiffness = force_at(LogBarrier.Law(1e4, 5e-4, 0.0), gap)
    assert force == pytest.approx(10.0 * mass, rel=1e-7)
    assert math.sqrt(stiffness / mass) == pytest.approx(frequency, rel=1e-7)


def test_steps_resolve_bounces_but_not_rest():
    fast = LAW.bounce_rate_squared(8.0, 2.0, 10.0 * RESTING_SPEED)
    assert fast == 4.0
    assert LAW.bounce_rate_squared(8.0, 2.0, -10.0 * RESTING_SPEED) == fast
    assert LAW.bounce_rate_squared(8.0, 2.0, 0.1 * RESTING_SPEED) == pytest.approx(0.04)
    assert LAW.bounce_rate_squared(8.0, 2.0, 0.0) == 0.0


def test_weights_by_length_do_not_depend_on_the_mesh():
    scales = Scales(0.02, 4e-3, 5e-5)

    def weights(weighting, elements):
        options = LogBarrier(weighting=weighting)
        return options.ground(scales, elements)[:2]

    assert weights("per_node", 33) == weights("per_node", 132) == (1.0, 1.0)
    assert weights("per_length", 66) == (1.0, 1.0)  # the paper's mesh
    for elements in (33, 132):
        node, corner = weights("per_length", elements)
        assert node * elements == pytest.approx(66.0)
        assert corner == 1.0


def test_no_contact_exerts_nothing():
    assert LAW.exists()
    assert not NoContact.Law().exists()
    assert NoContact.Law().reach() == 0.0
    assert force_at(NoContact.Law(), 0.3) == (0.0, 0.0)
    assert NoContact.Law().energy(0.3) == 0.0
