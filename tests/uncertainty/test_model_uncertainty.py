"""What an apex is off by where inputs are: each side a jump of its own, and all together."""

import csv
import io
import json
import math
from dataclasses import replace

import numpy as np
import pytest
from refusals import refused
from robots import BASELINE

from snapjump import Environment, model_uncertainty
from snapjump.batch import simulate_batch
from snapjump.composition import with_tier
from snapjump.declare.members import make_member
from snapjump.uncertainty.parts.as_built import built, with_error
from snapjump.uncertainty.parts.spread import LESS, MORE, Influence, ModelUncertainty, Side
from snapjump.uncertainty.parts.tolerances import DEFAULTS, LAWS

NUMBERS = [name for name in DEFAULTS if name not in LAWS]
# Without families, whose other members are other programs; one that is refused at its upper end,
# and one that is 0.
FURTHER = {
    **{name: None for name in DEFAULTS if name in LAWS},
    "drive.end_rad": {"relative": 0.1},
    "contact.damping_s": {"factor": 2.0},
}


@pytest.fixture(scope="module")
def found():
    return model_uncertainty(BASELINE, FURTHER)


def apex(simulation):
    return simulate_batch([simulation]).apexes[0]


def test_each_side_is_a_jump_of_its_own(found):
    base = built(BASELINE)
    assert [one.name for one in found.influences] == [*NUMBERS, "drive.end_rad"]
    np.testing.assert_array_equal(found.apex, apex(base))
    for one in found.influences:
        assert [side.side for side in one.sides] == [LESS, MORE]
        if one.name in ("robot.thickness_m", "frame.mass_centre_height_m"):
            for side in one.sides:
                moved = apex(with_error(base, one.name, side.value))
                np.testing.assert_array_equal(side.change, moved - found.apex)


def test_thickness_moves_the_apex_more_than_stiffness_which_goes_with_its_cube(found):
    by_name = {one.name: one for one in found.influences}
    thicker, stiffer = (
        by_name[name].sides[1].change[1]
        for name in ("robot.thickness_m", "robot.youngs_modulus_Pa")
    )
    assert 0.0 < stiffer < thicker


def test_the_spread_is_the_root_of_squares_of_the_larger_sides(found):
    known = [one for one in found.influences if one.name != "drive.end_rad"]
    for axis in (0, 1):
        squares = [max(abs(side.change[axis]) for side in one.sides) ** 2 for one in known]
        squares.append(abs(found.influences[-1].sides[0].change[axis]) ** 2)
        assert found.spread[axis] == pytest.approx(math.sqrt(sum(squares)))
    sizes = [float(np.hypot(*one.largest)) for one in found.by_size]
    assert sizes == sorted(sizes, reverse=True)
    assert (found.numerical > 0.0).all() or np.isnan(found.numerical).all()


def test_what_is_left_out_is_told(found):
    assert found.left_out == {"contact.damping_s": "it is 0"}
    (side,) = found.without_apex
    assert side == "drive.end_rad more"
    assert "drive.end_rad = 1.65 is not allowed" in found.without_apex[side]
    told = found.summary()["model_left_out"]
    assert told.startswith("contact.damping_s: it is 0; drive.end_rad more: ")


def test_the_summary_is_flat_and_plain(found):
    summary = json.loads(json.dumps(found.summary(), allow_nan=False))
    assert summary["model_spread_largest"] == found.by_size[0].name
    assert summary["model_spread_x_m"] == pytest.approx(0.02 * summary["model_spread_x_bar"])
    thick = found.influences[0].sides[1].change
    assert summary["model_robot_thickness_m_more_y_bar"] == thick[1]
    assert summary["model_drive_end_rad_more_x_bar"] is None
    assert summary["model_spread_most"].count("; ") == 2


def test_the_table_has_a_row_for_each_side(found):
    rows = list(csv.DictReader(io.StringIO(found.csv())))
    assert len(rows) == 2 * len(found.influences)
    assert rows[0]["input"] == "robot.thickness_m" and rows[0]["tolerance"] == "2 %"
    changes = [float(rows[0][f"change_x_{unit}"]) for unit in ("m", "bar")]
    assert changes[0] == pytest.approx(0.02 * changes[1])
    assert rows[-1]["change_x_bar"] == "" and "not allowed" in rows[-1]["why_not"]
    assert rows[0]["why_not"] == ""


def test_a_robot_that_does_not_jump_has_no_spread():
    heavy = replace(BASELINE, environment=Environment(mass_bar=400.0))
    found = model_uncertainty(heavy, {name: None for name in [*DEFAULTS][1:]})
    assert np.isnan(found.spread).all() and np.isnan(found.apex).all()
    assert found.summary()["model_spread_x_bar"] is None
    assert set(found.without_apex.values()) == {"no_jump"}


@pytest.mark.slow
def test_another_member_is_a_side_of_its_own():
    rows = {**dict.fromkeys(DEFAULTS), "damping": {"members": ["none", "kelvin_voigt"]}}
    found = model_uncertainty(BASELINE, rows)
    (one,) = found.influences
    assert (one.nominal, [side.side for side in one.sides]) == ("kelvin_voigt", ["none"])
    undamped = replace(built(BASELINE), damping=make_member("damping", {"name": "none"}))
    np.testing.assert_array_equal(one.sides[0].change, apex(undamped) - found.apex)
    assert "model_damping_none_x_bar" in found.summary()


def test_a_member_that_does_not_fit_is_told():
    rows = {**dict.fromkeys(DEFAULTS), "contact": {"members": ["none"]}}
    found = model_uncertainty(BASELINE, rows)
    assert "contact none" in found.without_apex and np.isnan(found.spread).all()


def test_in_one_line():
    sides = (Side(LESS, 1.0, np.array([-0.3, 0.1])), Side(MORE, 2.0, np.array([0.2, -0.4])))
    one = Influence("environment.mu", 1.5, "2 %", sides)
    found = ModelUncertainty(np.array([5.0, 14.0]), np.zeros(2), (one,), {}, 0.02)
    assert one.largest.tolist() == [0.3, 0.4]
    told = "<apex x 5 +- 0.3 L, y 14 +- 0.4 L by the model, environment.mu most>"
    assert repr(found) == told


@pytest.mark.parametrize("scene", ["snap", "bounce", "static"])
def test_scenes_without_an_apex_are_refused(scene):
    with refused("uncertainty", f"sim={scene}"):
        model_uncertainty(with_tier("draft", sim=scene))
