"""Random nonsense is refused in one line that names the key; designs stay in their ranges."""

import numpy as np
import pytest
from families import FAMILIES
from hydra_config import hydra_config

from experiments.compositions import groups_of
from experiments.robustness import invalid
from experiments.robustness.fields import all_fields, outside
from experiments.robustness.study import HIGH, LOW, on_slopes, random_designs
from experiments.stability.jumps import by_status, jump_rows
from snapjump.run.studies.base import REFUSED
from snapjump.simulation import build


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_no_invalid_configuration_is_accepted_or_crashes(seed):
    for one in invalid.invalid_configurations(300, seed):
        outcome, message = invalid.refusal(one)
        assert outcome == REFUSED, (one, message)
        assert message.startswith(one.key) and "\n" not in message


def test_what_is_valid_is_not_counted_as_refused():
    for key, epsilon, outcome in (
        ("design.epsilon", 0.2, invalid.ACCEPTED), ("robot.width_m", -1.0, invalid.UNCLEAR),
    ):  # fmt: skip
        one = invalid.Invalid("none", key, {"design": {"epsilon": epsilon}})
        assert invalid.refusal(one)[0] == outcome


def test_every_number_of_every_member_has_a_range_that_it_is_taken_out_of():
    random = np.random.default_rng(0)
    numbers = [field for field in all_fields() if field.is_number]
    assert {field.group for field in numbers} >= {"robot", "contact", "stepping", "sim"}
    for field in numbers:
        for _ in range(20):
            value = outside(field, random)
            assert not field.low < value < field.high, field


def test_every_default_can_be_built():
    for family, members in FAMILIES.items():
        for name in members:
            if family in ("damping", "friction", "discretization", "stepping", "backend"):
                assert getattr(build({family: {"name": name}}), family).name == name


def test_designs_are_seeded_and_inside_their_ranges():
    designs = np.array(random_designs(200, (3, 0)))
    np.testing.assert_array_equal(designs, random_designs(200, (3, 0)))
    assert not np.array_equal(designs, random_designs(200, (3, 200)))
    assert np.all(designs >= LOW) and np.all(designs <= HIGH)
    sloping = np.array(on_slopes(designs.tolist(), 0.9, 3))
    np.testing.assert_array_equal(sloping[:, :4], designs)
    shares = sloping[:, 4] / np.arctan(designs[:, 3])
    assert np.abs(shares).max() <= 0.9 and shares.min() < -0.8 and shares.max() > 0.8
    found = by_status([{"status": status} for status in ("ok", "no_jump", "ok")])
    assert found == {"ok": 2, "no_jump": 1}


def test_a_design_may_have_a_slope():
    """Beyond what friction holds it is refused."""
    point = {"across": "", "up": "", "groups": groups_of(hydra_config("accuracy=draft"))}
    designs = [(0.1, 0.2, 0.768, 0.3), (0.1, 0.2, 0.768, 0.3, 0.2), (0.1, 0.2, 0.768, 0.3, 0.4)]
    level, sloping, steep = jump_rows([point], designs, 1e5)
    assert level["status"] == sloping["status"] == "ok"
    assert sloping["x_bar"] < level["x_bar"]
    assert steep["status"] == REFUSED and steep["message"].startswith("environment.slope_rad")
