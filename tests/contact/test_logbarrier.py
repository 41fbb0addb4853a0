"""The barrier against exact derivatives, its paper, and C1 to C3 of references/physics.json."""

import cmath
import math

import numpy as np
import pytest
from references import outputs_of

from snapjump.contact.base import RESTING_SPEED, at_rest
from snapjump.contact.logbarrier import LogBarrier
from snapjump.contact.none import NoContact
from snapjump.units import Scales

LAW = LogBarrier.Law(3.0e4, 0.025, 0.0)
UNIT = LogBarrier.Law(1.0, 1.0, 0.0)
PAPER = LogBarrier.Law(1e4, 5e-4, 0.0)  # in SI units


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


@pytest.mark.parametrize("row", outputs_of("C1_barrier_nondim"))
def test_lowest_point_of_a_bounce(row):
    check_lowest_point(UNIT, 1.0, row["vhat"], row["xmin"], row["phimax"], row["omega_max"])


@pytest.mark.parametrize("row", [r for r in outputs_of("C2_barrier_dim") if r["g"] == 0.0])
def test_lowest_point_of_a_bounce_in_si_units(row):
    lowest = row["dmin"], row["Fmax"], row["omega_contact_max"]
    check_lowest_point(PAPER, row["m"], row["v"], *lowest)


def check_lowest_point(law, mass, speed, lowest, force, frequency):
    assert law.energy(lowest) == pytest.approx(0.5 * mass * speed**2, rel=1e-7)
    pushed, stiffness = force_at(law, lowest)
    assert pushed == pytest.approx(force, rel=1e-8)
    assert math.sqrt(stiffness / mass) == pytest.approx(frequency, rel=1e-8)


@pytest.mark.parametrize("row", outputs_of("C3_rest_gap"))
def test_gap_at_rest(row):
    force, stiffness = force_at(PAPER, row["gap"])
    assert force == pytest.approx(row["g"] * row["m"], rel=1e-7)
    assert math.sqrt(stiffness / row["m"]) == pytest.approx(row["omega_vert"], rel=1e-7)


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
