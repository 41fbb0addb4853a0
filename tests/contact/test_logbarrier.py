"""The barrier against exact derivatives, its paper, and C1 to C3 of references/physics.json."""

import cmath
import math

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


BOUNCES = [
    *((UNIT, 1.0, row["vhat"], row["xmin"], row["phimax"], row["omega_max"])
      for row in outputs_of("C1_barrier_nondim")),
    *((PAPER, row["m"], row["v"], row["dmin"], row["Fmax"], row["omega_contact_max"])
      for row in outputs_of("C2_barrier_dim") if row["g"] == 0.0),
]  # fmt: skip


@pytest.mark.parametrize(("law", "mass", "speed", "lowest", "force", "frequency"), BOUNCES)
def test_lowest_point_of_a_bounce(law, mass, speed, lowest, force, frequency):
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
    squares = [
        LAW.bounce_rate_squared(8.0, 2.0, share * RESTING_SPEED)
        for share in (10.0, -10.0, 0.1, 0.0)
    ]
    assert squares == [4.0, 4.0, pytest.approx(0.04), 0.0]


def test_weights_by_length_do_not_depend_on_the_mesh():
    def weights(weighting, elements):
        return LogBarrier(weighting=weighting).ground(Scales(0.02, 4e-3, 5e-5), elements)[:2]

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
