"""A robot of which one input is off: what lies on the table stays."""

from dataclasses import replace

import numpy as np
import pytest
from refusals import refused
from robots import BASELINE

from snapjump.declare.inputs import inputs_of, value_at
from snapjump.engine.model import numbers_of
from snapjump.scenes.jump_start import jump_model
from snapjump.uncertainty.parts.as_built import EVENLY, built, nominal, with_error

BASE = built(BASELINE)


def span_m(simulation):
    return simulation.robot.length_m * (1.0 - simulation.design.epsilon)


def mass_kg(simulation):
    return simulation.environment.mass_kg(simulation.robot)


def numbers(simulation):
    return numbers_of(jump_model(simulation))


def test_the_clamps_height_is_a_number():
    assert BASELINE.robot.mount_height == "optimal" and built(BASE) is BASE
    np.testing.assert_allclose(numbers(BASE), numbers(BASELINE), rtol=1e-13, atol=0.0)


@pytest.mark.parametrize("path", [p for p in inputs_of(BASE) if p.startswith("robot.")])
def test_mass_height_and_span_stay(path):
    value = nominal(BASE, path)
    if isinstance(value, str):
        assert (path, value) == ("robot.yield_stress_Pa", "not given")
        return
    other = with_error(BASE, path, 1.02 * value)
    assert value_at(other, path) == 1.02 * value
    assert mass_kg(other) == pytest.approx(mass_kg(BASE), rel=1e-14)
    assert span_m(other) == pytest.approx(span_m(BASE), rel=1e-14)
    if path != "robot.mount_height":
        assert other.robot.mount_height == BASE.robot.mount_height
    others = {p for p in inputs_of(BASE) if value_at(other, p) != value_at(BASE, p)}
    assert others - {path} <= {"design.epsilon", "environment.mass_bar"}
    assert ("design.epsilon" in others) == (path == "robot.length_m")


def test_the_mass_itself_and_the_span_itself_may_be_off():
    heavier = with_error(BASE, "environment.mass_bar", 0.8)
    assert mass_kg(heavier) == pytest.approx(mass_kg(BASE) * 0.8 / 0.768)
    wider = with_error(BASE, "design.epsilon", 0.19)
    assert span_m(wider) == pytest.approx(0.81 * BASE.robot.length_m)
    assert wider.robot.mount_height == BASE.robot.mount_height


def test_what_is_not_given_of_a_frame_is_that_of_its_outline():
    """Given as such, the robot is the same."""
    assert value_at(BASE, EVENLY[0]) is None
    given = {path.partition(".")[2]: nominal(BASE, path) for path in EVENLY}
    # Legs of l2 and a top of the span, each with its centre.
    height, span = BASE.robot.frame_height_m, span_m(BASE)
    centre = (height * height + span * height) / (2.0 * height + span)
    assert given["mass_centre_height_m"] == pytest.approx(centre)
    same = replace(BASE, frame=BASE.frame.changed(**given))
    np.testing.assert_allclose(numbers(same), numbers(BASE), rtol=1e-12, atol=1e-14)
    heavy = replace(BASE, frame=BASE.frame.changed(clamp_mass_kg=1e-4))
    given = {path.partition(".")[2]: nominal(heavy, path) for path in EVENLY}
    same = replace(heavy, frame=heavy.frame.changed(**given))
    np.testing.assert_allclose(numbers(same), numbers(heavy), rtol=1e-12, atol=1e-14)


def test_inputs_that_the_robot_has_not():
    soft = replace(BASE, contact="penalty", frame="elastic")
    assert nominal(soft, "contact.distance_m") == "contact=penalty has none"
    assert nominal(soft, "frame.mass_centre_height_m") == "frame=elastic has none"
    assert nominal(soft, "contact.stiffness_N_m") == value_at(soft, "contact.stiffness_N_m")


def test_a_robot_out_of_range_is_refused():
    with refused("design.epsilon", "(0, 0.4]"):
        with_error(BASE, "robot.length_m", 0.5 * BASE.robot.length_m)
