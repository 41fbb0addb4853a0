"""Where a jump starts: the clamp that leads is at the same angle whichever it is."""

from dataclasses import replace

import pytest

from snapjump.checks import ParameterError
from snapjump.composition import with_tier
from snapjump.parameters.design import Design
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


@pytest.mark.parametrize(("epsilon", "elements"), [(1e-5, 56), (0.1, 8), (0.01, 8)])
def test_what_does_not_buckle_or_is_too_coarse_to_snap_is_refused(epsilon, elements):
    mesh = replace(BASE.discretization, elements=elements)
    with pytest.raises(ParameterError, match=r"design\.epsilon = .*buckles"):
        critical(replace(BASE, design=Design(epsilon=epsilon), discretization=mesh))
