"""Robots of other programs, meshes or clocks are refused; numbers may differ, none is dropped."""

from dataclasses import fields, replace

import pytest

from snapjump.batch import simulate_batch, variants
from snapjump.batch.alike import check_alike
from snapjump.checks import ParameterError
from snapjump.composition import with_tier
from snapjump.declare.members import member_class
from snapjump.parameters.environment import Environment

BASE = with_tier("draft")
OTHERS = {
    "contact": member_class("contact", "penalty")(),
    "friction": member_class("friction", "none")(),
    "damping": member_class("damping", "none")(),
    "integrator": member_class("integrator", "bdf2")(),
    "discretization": member_class("discretization", "der")(elements=58),
    "stepping": member_class("stepping", "adaptive")(tolerance=2e-6),
    "sim": replace(BASE.sim, time_limit_s=0.2),
    "robot": replace(BASE.robot, thickness_m=6e-5),
}


@pytest.mark.parametrize("family", OTHERS)
def test_another_composition_is_refused_by_name(family: str) -> None:
    with pytest.raises(ParameterError, match=f"^{family} = .* is not allowed: .*first robot"):
        simulate_batch([BASE, replace(BASE, **{family: OTHERS[family]})])


def test_other_numbers_march_together() -> None:
    contact = replace(BASE.contact, stiffness_N_m=2e4)
    robot = replace(BASE.robot, mount_height=2e-3, gravity_m_s2=9.8)
    check_alike([BASE, replace(BASE, contact=contact), replace(BASE, robot=robot)])


def test_a_variant_keeps_what_it_does_not_change() -> None:
    class Sloping(Environment):
        """An environment with one field more."""

        slope_rad: float = 0.0

    base = replace(BASE, environment=Sloping(slope_rad=0.1))
    (other,) = variants(base, [(0.05, 0.25, 1.2, 0.4)])
    assert other.environment == Sloping(mu=0.4, mass_bar=1.2, slope_rad=0.1)
    assert {f.name for f in fields(other.environment)} == {"mu", "mass_bar", "slope_rad"}
