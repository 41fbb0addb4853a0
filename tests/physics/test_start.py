"""Where a jump starts: the clamp that leads is at the same angle whichever it is."""

from dataclasses import replace

import pytest

from snapjump import Design, ParameterError
from snapjump.composition import with_tier
from snapjump.scenes.jump_start import critical, start_angle_rad

BASE = with_tier("draft")


@pytest.mark.parametrize("lag", [0.0, 0.05, 0.3])
def test_mirrored_designs_start_mirrored(lag):
    leads, lags = (
        replace(BASE, design=Design(epsilon=0.1, delta_alpha=sign * lag)) for sign in (1.0, -1.0)
    )
    left = start_angle_rad(leads)
    right = start_angle_rad(lags) + lag
    assert right == pytest.approx(left, rel=1e-14)


def critical_of(epsilon, elements):
    mesh = replace(BASE.discretization, elements=elements)
    return critical(replace(BASE, design=Design(epsilon=epsilon), discretization=mesh))


@pytest.mark.parametrize(("epsilon", "elements"), [(1e-5, 56), (1e-5, 8), (1.5e-5, 104)])
def test_what_does_not_buckle_is_refused(epsilon, elements):
    with pytest.raises(ParameterError, match=r"design\.epsilon = .*buckles"):
        critical_of(epsilon, elements)


@pytest.mark.parametrize("epsilon", [0.01, 0.07, 0.1, 0.4])
def test_eight_elements_snap_where_a_mesh_so_coarse_does(epsilon):
    """Too early, by an error of second order: the coarsest mesh has its own threshold."""
    eight, twelve, many = (critical_of(epsilon, n).alpha_rad for n in (8, 12, 104))
    assert 0.80 * many < eight < twelve < many
    assert (many - eight) / (many - twelve) == pytest.approx((12 / 8) ** 2, rel=0.3)
