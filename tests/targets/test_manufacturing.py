"""What errors cost: of every input by simulation, and along curves."""

from dataclasses import replace

import numpy as np
import pytest
from robots import BASELINE

from snapjump import Environment
from snapjump.batch import simulate_batch
from snapjump.declare.inputs import inputs_of
from snapjump.targets.manufacturing import ErrorCurves, alone_off, one_percent_costs
from snapjump.uncertainty.parts.as_built import built, nominal, with_error
from snapjump.uncertainty.parts.tolerances import Tolerance

# Of the default robot: what is 0 or not given has no percent.
WITHOUT = {"slope_rad", "mass_centre_offset_m", "clamp_mass_kg", "damping_s", "yield_stress_Pa"}
WITHOUT |= {"right_rate_rad_s"}


@pytest.fixture(scope="module")
def told():
    return one_percent_costs(BASELINE)


def test_each_is_half_the_way_between_jumps_at_one_percent_more_and_less(told):
    base = built(BASELINE)
    for path in ("robot.thickness_m", "design.epsilon", "frame.mass_centre_height_m"):
        ends = Tolerance("relative", 0.01).ends(nominal(base, path))
        apexes = [simulate_batch([with_error(base, path, end)]).apexes[0] for end in ends]
        half = 0.5 * np.hypot(*(apexes[1] - apexes[0]))
        assert told.costs[path.rpartition(".")[2]] == pytest.approx(half, rel=1e-9)


def test_every_number_of_the_composition_is_among_them_thickness_first(told):
    names = {path.rpartition(".")[2] for path in inputs_of(BASELINE)}
    assert set(told.costs) == names - WITHOUT and told.because == ""
    first, *others = told.costs
    assert first == "thickness_m"
    sizes = [told.costs[name] for name in others]
    assert sizes == sorted(sizes, reverse=True) and sizes[0] > 0.0
    assert told.costs["thickness_m"] > told.costs["youngs_modulus_Pa"]


def test_what_does_not_jump_has_no_cost():
    heavy = replace(BASELINE, environment=Environment(mass_bar=400.0))
    assert np.isnan([*one_percent_costs(heavy).costs.values()]).all()


def test_a_robot_whose_clamps_have_no_place_in_its_frame_is_told():
    """Its optimal mount height is above its top."""
    low = replace(BASELINE, robot=replace(BASELINE.robot, frame_height_m=1e-3))
    found = one_percent_costs(low)
    assert not found.costs and found.because.startswith("robot.mount_height = 0.0014")


def test_each_number_alone_is_off():
    design = np.array([0.1, 0.2, 0.768, 0.3])
    made = alone_off(design, (0.8, 1.2)).reshape(4, 2, 4)
    expected = np.stack([np.ones((4, 4)) + share * np.eye(4) for share in (-0.2, 0.2)], axis=1)
    assert made / design == pytest.approx(expected)


def test_curves_of_an_apex_that_goes_as_a_square():
    factors = np.linspace(0.8, 1.2, 41)
    apexes = np.array([5.0, 14.0]) * np.broadcast_to(factors[None, :, None] ** 2, (4, 41, 2))
    square = ErrorCurves.of(apexes, factors)
    twos = np.full((4, 2), 2.0)
    assert square.secants(0.02) == pytest.approx(twos)
    assert square.trends == pytest.approx(twos)
    # (1 + e)^2 is off its tangent by e^2.
    for error in (0.01, 0.05, 0.2):
        assert square.deviations(twos, error) == pytest.approx(error**2)
    assert square.largest.max() == pytest.approx(0.44)
    assert square.roughness == pytest.approx(2e-4)
