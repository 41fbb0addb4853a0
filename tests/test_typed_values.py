"""Values as people type them: of numpy, integers, typos, and other units."""

import dataclasses

import numpy as np
import pytest

from snapjump import Design, Environment, Robot
from snapjump.batch import simulate_designs
from snapjump.checks import ParameterError
from snapjump.composition import Simulation, with_tier
from snapjump.declare.fields import Number
from snapjump.declare.inputs import unusual
from snapjump.discretization.der import DiscreteElasticRod
from snapjump.sim.base import check_samples
from snapjump.simulation import build


def test_numbers_of_numpy_and_integers_are_numbers():
    given = Design(epsilon=np.float32(0.25), delta_alpha=0)
    assert (given.epsilon, given.delta_alpha) == (0.25, 0.0)
    assert type(given.epsilon) is type(given.delta_alpha) is float
    mesh = DiscreteElasticRod(elements=np.int64(24))
    assert type(mesh.elements) is int
    for bad in (True, np.bool_(True), "0.2", 0.2 + 0j, None, np.float32("nan"), [0.2]):
        with pytest.raises(ParameterError, match="design.epsilon"):
            Design(epsilon=bad)


def test_integers_compile_nothing_anew():
    """Every number of a part is a float, whatever was typed."""
    typed = build(
        {
            "design": {"epsilon": 0.2, "delta_alpha": 0},
            "environment": {"mu": 1, "mass_bar": 2},
            "robot": {"gravity_m_s2": 10},
            "drive": {"end_rad": 1},
            "contact": {"name": "penalty", "stiffness_N_m": 100000},
        }
    )
    for part in (typed.robot, typed.design, typed.environment, *typed.parts):
        for field in dataclasses.fields(part):
            if isinstance(field.metadata.get("allowed"), Number):
                value = getattr(part, field.name)
                left_out = value is None and field.default is None
                assert left_out or isinstance(value, (float, str)), field.name


@pytest.mark.parametrize(
    ("config", "key", "told"),
    [
        ({"desing": {"epsilon": 0.1}}, "desing", "did you mean design?"),
        ({"accuracy": {"nmae": "draft"}}, "accuracy.nmae", "name"),
        ({"accuracy": {}}, "accuracy", "the name of a tier"),
        ({"accuracy": {"name": "draft", "promise_percent": 1e9}}, "accuracy.promise_percent", ""),
        ({"robot": False}, "robot", "a mapping of its fields"),
        ({"robot": []}, "robot", "a mapping of its fields"),
        ({"contact": 0}, "contact", "a member of contact"),
        ({"environment": {"mu": 1e308}}, "environment.mu", "[0, 100]"),
        (
            {"friction": {"velocity_threshold_m_s": 1e300}},
            "friction.velocity_threshold_m_s",
            "1000",
        ),
    ],
)
def test_typos_and_values_beyond_physics_in_dictionaries(config, key, told):
    with pytest.raises(ParameterError) as caught:
        build(config)
    assert caught.value.key == key and told in str(caught.value)


def test_a_whole_configuration_of_a_run_may_be_given():
    given = {
        "task": {"name": "simulate"},
        "seed": 0,
        "design": {"epsilon": 0.3},
        "contact": "penalty",
    }
    assert build(given).design.epsilon == 0.3 and build(given).contact.name == "penalty"


@pytest.mark.parametrize(
    "rows", [[["0.1", "0.2", "1", "0.3"]], [[0.1, 0.2j, 1.0, 0.3]], [[True, False, True, True]]]
)
def test_designs_are_numbers(rows):
    with pytest.raises(ParameterError, match="designs"):
        simulate_designs(with_tier("draft"), rows)


@pytest.mark.parametrize(
    ("change", "told"),
    [
        ({"length_m": 20.0, "thickness_m": 0.05}, "robot.length_m = 20 m is unusual"),
        ({"youngs_modulus_Pa": 200.0}, "robot.youngs_modulus_Pa = 200 Pa is unusual"),
        ({"thickness_m": 1e-8}, "robot.thickness_m"),
    ],
)
def test_other_units_are_warned_of(change, told):
    lines = unusual(Simulation(robot=Robot(**change), environment=Environment(mass_bar=1e12)))
    assert lines and lines[0].startswith(told)
    assert not unusual(Simulation())


def test_the_least_interval_of_samples_is_accepted():
    with pytest.raises(ParameterError, match="at least 5e-07 s"):
        check_samples(0.1, 4.9e-7)
    check_samples(0.1 * (1.0 + 1e-9), 5e-7)
    for duration in np.random.default_rng(0).uniform(1e-3, 10.0, 100):
        with pytest.raises(ParameterError) as caught:
            check_samples(duration, 1e-9)
        check_samples(duration, float(caught.value.allowed.split()[2]))
