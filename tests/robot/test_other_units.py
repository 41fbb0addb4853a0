"""Degrees, grams and millimetres stand for the numbers that are kept."""

import math

import pytest

from snapjump import Robot, simulate_jump
from snapjump.checks import ParameterError
from snapjump.composition import with_tier
from snapjump.robot.other_units import OTHER_UNITS, in_other_units, in_own_units

ROBOT = Robot()


def test_groups_take_them():
    found = with_tier(
        "draft", design={"delta_alpha_deg": 5.0}, environment={"mass_g": 4.0, "mu": 0.2}
    )
    assert found.design.delta_alpha == pytest.approx(math.radians(5.0), rel=1e-15)
    assert found.environment.mass_kg(found.robot) == pytest.approx(4e-3, rel=1e-12)
    assert found.environment.mass_bar == pytest.approx(0.768, rel=1e-12)  # the paper's 4 g
    heavier = with_tier("draft", environment={"mass_g": 4.0}, robot={"thickness_m": 1e-4})
    assert heavier.environment.mass_bar == pytest.approx(0.768 / 8.0, rel=1e-12)


def test_a_whole_configuration_is_converted():
    config = {"design": {"epsilon": 0.2, "delta_alpha": 0.1, "delta_alpha_deg": -2.0},
              "environment": {"mass_bar": 1.0, "mass_g": None}, "target": None,
              "target_mm": [60, 240]}  # fmt: skip
    found = in_own_units(config, ["design.delta_alpha_deg", "target_mm"], ROBOT)
    assert found == {
        "design": {"epsilon": 0.2, "delta_alpha": math.radians(-2.0)},
        "environment": {"mass_bar": 1.0},
        "target": [pytest.approx(3.0), pytest.approx(12.0)],
    }


@pytest.mark.parametrize(
    ("group", "told"),
    [
        ({"mass_g": 4.0, "mass_bar": 1.0}, r"environment\.mass_g = 4\.0 .* left out where"),
        ({"mass_g": "4 g"}, r"environment\.mass_g = '4 g' .* a number of g"),
        ({"mass_g": math.nan}, r"environment\.mass_g = nan"),
        ({"mass_g": -1.0}, r"environment\.mass_g = -1\.0 .* environment\.mass_bar as"),
    ],
)
def test_what_is_refused_is_told_by_its_key(group, told):
    with pytest.raises(ParameterError, match=told) as refused:
        simulate_jump(environment=group)
    assert "\n" not in str(refused.value)


def test_both_ways_agree_for_every_one():
    for other in OTHER_UNITS[:2]:
        text = in_other_units(other.of, 0.25, ROBOT)
        number, unit = text.split()
        assert unit == other.unit
        assert float(number) * other.size(ROBOT) == pytest.approx(0.25, rel=1e-3)
    assert in_other_units("design.epsilon", 0.25, ROBOT) == ""
