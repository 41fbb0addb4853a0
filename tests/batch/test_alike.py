"""Robots of other programs or meshes are refused; numbers may differ, none is dropped."""

from dataclasses import fields, replace

import numpy as np
import pytest
from robots import BASELINE

from snapjump import Environment, ParameterError
from snapjump.batch import simulate_batch, variants
from snapjump.batch.alike import check_alike
from snapjump.composition import with_tier
from snapjump.stepping.fixed import FixedStep

BASE = with_tier("draft")
OTHERS = {
    "contact": "penalty", "friction": "none", "damping": "none", "integrator": "bdf2",
    "discretization": replace(BASE.discretization, elements=58),
    "stepping": replace(BASE.stepping, tolerance=2e-6),
    "sim": replace(BASE.sim, time_limit_s=0.2),
}  # fmt: skip


@pytest.mark.parametrize("family", OTHERS)
def test_another_composition_is_refused_by_name(family):
    with pytest.raises(ParameterError, match=f"^{family} = .* is not allowed: .*first robot"):
        simulate_batch([BASE, replace(BASE, **{family: OTHERS[family]})])


def test_other_numbers_march_together():
    contact = replace(BASE.contact, stiffness_N_m=2e4)
    robot = replace(BASE.robot, mount_height=2e-3, gravity_m_s2=9.8)
    check_alike([BASE, replace(BASE, contact=contact), replace(BASE, robot=robot)])


@pytest.mark.parametrize("stepping", ["adaptive", "fixed"])
def test_robots_of_other_scales_march_together(stepping):
    """Each as if it were alone, to the last bit, up to its own time limit."""
    base = replace(BASELINE, sim=replace(BASELINE.sim, time_limit_s=0.006))
    if stepping == "fixed":
        base = replace(base, stepping=FixedStep(step_s=4e-5))
    paths = ("robot.thickness_m", "damping.relaxation_time_s", "robot.length_m")
    rows = ((5e-5, 1e-5, 0.02), (3.5e-5, 1e-7, 0.02), (7.5e-5, 1e-5, 0.03), (6e-5, 0.0, 0.01))
    simulations = variants(base, rows, paths)
    together = simulate_batch(simulations)
    alone = [simulate_batch([one]) for one in simulations]
    assert {"ok", "time_limit"} <= set(together.status)
    for name, values in vars(together).items():
        if isinstance(values, np.ndarray) and name != "kernel_seconds_each":
            expected = np.concatenate([getattr(one, name) for one in alone])
            np.testing.assert_array_equal(values, expected, err_msg=name)
    expected = np.concatenate([one.estimate.x_percent for one in alone])
    np.testing.assert_array_equal(together.estimate.x_percent, expected)


def test_a_variant_keeps_what_it_does_not_change():
    class Windy(Environment):
        """An environment with one field more."""

        wind_rad: float = 0.0

    base = replace(BASE, environment=Windy(wind_rad=0.1))
    (other,) = variants(base, [(0.05, 0.25, 1.2, 0.4)])
    assert other.environment == Windy(mu=0.4, mass_bar=1.2, wind_rad=0.1)
    names, known = ({f.name for f in fields(cls)} for cls in (other.environment, Environment))
    assert names == known | {"wind_rad"}
