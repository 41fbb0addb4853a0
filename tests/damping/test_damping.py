import pytest

from snapjump.damping.kelvin_voigt import KelvinVoigt
from snapjump.damping.mass_proportional import MassProportional
from snapjump.damping.none import NoDamping
from snapjump.robot.robot import Robot

LAWS = [NoDamping.Law(), KelvinVoigt.Law(0.03), MassProportional.Law(0.7)]


@pytest.mark.parametrize("law", LAWS)
def test_stiffening_is_the_derivative_of_the_strain(law):
    rate_factor, origin, strain = 40.0, 0.02, 0.05

    def viscous(s):
        return law.viscous_strain(s, (s - origin) * rate_factor)

    slope = viscous(complex(strain, 1e-30)).imag / 1e-30
    assert law.stiffening(rate_factor) == pytest.approx(slope, rel=1e-14)
    assert law.viscous_strain(strain, 0.0) == strain


def test_what_each_law_damps():
    assert [law.viscous_strain(0.5, 2.0) for law in LAWS] == [0.5, 0.5 + 0.03 * 2.0, 0.5]
    assert [law.drag() for law in LAWS] == [0.0, 0.0, 0.7]


def test_options_are_in_seconds():
    scales = Robot().scales
    assert KelvinVoigt(scales.time_s).law(scales).relaxation_time == pytest.approx(1.0)
    assert MassProportional(1.0 / scales.time_s).law(scales).rate == pytest.approx(1.0)
