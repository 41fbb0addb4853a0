"""Axes: any inputs by their paths, with declared ranges or others; what no robot has is refused."""

from dataclasses import replace

import pytest
from refusals import refused

from snapjump import Environment, ParameterError
from snapjump.composition import with_tier
from snapjump.declare.fields import number
from snapjump.declare.inputs import (
    DEFAULT_INPUTS,
    column_names,
    inputs_of,
    slope_names,
    value_at,
    with_inputs,
)
from snapjump.plan.parts.axes import default_axes, recorded_axes
from snapjump.plan.sobol import Sobol

BASE = with_tier("draft")


def test_every_number_of_a_physical_part_is_an_input():
    found = inputs_of(BASE)
    assert {"robot.thickness_m", "robot.mount_height", "contact.stiffness_N_m"} <= set(found)
    assert {"damping.relaxation_time_s", "friction.velocity_threshold_m_s"} <= set(found)
    assert not [path for path in found if path.startswith(("discretization", "stepping", "sim"))]
    assert found["robot.length_m"].unit == "m" and found["design.epsilon"].kind == "control"
    for path, one in found.items():
        if path.startswith(("robot", "design", "environment")):
            assert one.plan and one.meaning and one.symbol
            assert one.plan[0] < one.plan[1] and one.kind in ("control", "environment", "property")


def test_values_are_set_by_path():
    other = with_inputs(BASE, {"robot.mount_height": 2e-3, "contact.stiffness_N_m": 2e4})
    assert value_at(other, "robot.mount_height") == 2e-3
    assert other.contact.stiffness_N_m == 2e4 and other.design == BASE.design
    with pytest.raises(ParameterError, match="robot.mount_height = 0.02"):
        with_inputs(BASE, {"robot.mount_height": 0.02})


def test_the_four_by_default():
    axes = Sobol(epsilon=[0.15, 0.2]).axes(BASE)  # type: ignore[arg-type]
    assert tuple(axis.path for axis in axes) == DEFAULT_INPUTS
    assert [axis.column for axis in axes] == ["delta_alpha_rad", "epsilon", "mass_bar", "mu"]
    assert axes[1].range == (0.15, 0.2) and axes[2].range == (0.3, 2.0)
    old = {"plan": {axis.column: list(axis.range) for axis in axes}}
    assert recorded_axes(old) == axes == default_axes([axis.range for axis in axes])


def test_any_inputs_in_the_order_given():
    given = {"robot.thickness_m": None, "design.epsilon": [0.1, 0.2]}
    thickness, epsilon = Sobol(inputs=given).axes(BASE)  # type: ignore[arg-type]
    assert thickness.column == "thickness_m" and thickness.range == (3.5e-5, 7.5e-5)
    assert epsilon.range == (0.1, 0.2) and epsilon.label == "pre-compression ε"


def test_two_of_one_name_are_called_by_their_paths():
    one, other = inputs_of(BASE)["robot.length_m"], inputs_of(BASE)["design.epsilon"]
    twin = replace(other, path="frame.length_m", column="length_m")
    assert column_names([one, twin, other]) == ["robot_length_m", "frame_length_m", "epsilon"]
    assert slope_names([one, twin, other]) == ["robot_length_m", "frame_length_m", "epsilon"]


@pytest.mark.parametrize(
    ("options", "key"),
    [
        ({"delta_alpha_rad": [-0.51, 0.1]}, "plan.delta_alpha_rad"),
        ({"epsilon": [0.0, 0.2]}, "plan.epsilon"),
        ({"epsilon": [0.1, 0.41]}, "plan.epsilon"),
        ({"mass_bar": [0.001, 2.0]}, "plan.mass_bar"),
        ({"mu": [-1e-9, 0.5]}, "plan.mu"),
        ({"inputs": {"robot.frame_height_m": [0.01, 0.0]}}, "plan.inputs.robot.frame_height_m"),
        ({"inputs": {"robot.mount_height": [1e-3, 0.02]}}, "plan.inputs.robot.mount_height"),
        ({"inputs": {"robot.thickness_m": [1e-5, 0.01]}}, "plan.inputs.robot.thickness_m"),
        ({"inputs": {"robot.colour": None}}, "plan.inputs"),
        ({"inputs": {"discretization.elements": [8.0, 80.0]}}, "plan.inputs"),
        ({"inputs": {"design.epsilon": None}, "epsilon": [0.1, 0.2]}, "plan.epsilon"),
    ],
)
def test_what_no_robot_has(options, key):
    with refused(key):
        Sobol(**options).axes(BASE)


def test_a_range_that_is_not_declared_has_to_be_given():
    class Windy(Environment):
        """An environment with one number more."""

        wind_rad: float = number(0.0, unit="rad")

    base = replace(BASE, environment=Windy())
    with pytest.raises(ParameterError, match=r"plan.inputs.environment.wind_rad = None .* a range"):
        Sobol(inputs={"environment.wind_rad": None}).axes(base)
    (axis,) = Sobol(inputs={"environment.wind_rad": (-0.1, 0.1)}).axes(base)
    assert axis.column == "wind_rad" and axis.short == "wind_rad (rad)"
