"""Every field of every option is checked: its key, the value and the range in one line."""

import dataclasses
import math

import pytest

from snapjump.accuracy import TIERS
from snapjump.checks import ParameterError
from snapjump.composition import Simulation, with_tier
from snapjump.families import DATASET_FAMILIES, FAMILIES, name_of
from snapjump.options.discretization import DiscreteElasticRodOptions
from snapjump.options.runge_kutta import tableaux
from snapjump.simulation import build

EVERY = FAMILIES | DATASET_FAMILIES
# Values just outside the range of every field: (family, member, field) -> values
OUTSIDE = {
    ("sim", "jump", "start_fraction"): (-1e-9, 0.951),
    ("sim", "jump", "time_limit_s"): (0.0, -1.0),
    ("sim", "jump", "sample_interval_s"): (0.0, 1e-7),
    ("sim", "static", "steps"): (9, 100_001, 10.0),
    ("sim", "snap", "duration_s"): (0.0,),
    ("sim", "snap", "rise_time_s"): (0.0,),
    ("sim", "snap", "sample_interval_s"): (0.0, 1e-7),
    ("sim", "cantilever", "load_bar"): (-20.1, 20.1),
    ("sim", "bounce", "mass_kg"): (0.0,),
    ("sim", "bounce", "speed_m_s"): (-1e-9,),
    ("sim", "bounce", "duration_s"): (0.0,),
    ("sim", "bounce", "sample_interval_s"): (0.0,),
    ("sim", "slide", "mass_kg"): (0.0,),
    ("sim", "slide", "speed_m_s"): (-1e-9,),
    ("sim", "slide", "duration_s"): (0.0,),
    ("sim", "slide", "incline"): (-1e-9, 1.01),
    ("sim", "slide", "sample_interval_s"): (0.0,),
    ("discretization", "der", "elements"): (7, 100_001, 64.0),
    ("discretization", "der", "clamp"): ("", "three_nodes"),
    ("discretization", "corotational", "elements"): (7, 100_001, 64.0),
    ("discretization", "geometrically_exact", "elements"): (7, 100_001, 64.0),
    ("discretization", "geometrically_exact", "poisson_ratio"): (-1.0, 0.51),
    ("frame", "elastic", "bending_ratio"): (0.0, -1.0),
    ("frame", "elastic", "stretching_ratio"): (0.0, -1.0),
    ("frame", "elastic", "leg_elements"): (2, 10_001, 33.0),
    ("frame", "elastic", "top_elements"): (1, 10_001, 56.0),
    ("frame", "elastic", "mount"): ("", "node"),
    ("frame", "elastic", "inset_m"): (-1e-9,),
    ("frame", "elastic", "contact"): ("", "feet"),
    ("frame", "elastic", "beam_on_top"): (0, 1, "true"),
    ("frame", "elastic", "right_follow"): (-1e-9, 1.01),
    ("contact", "logbarrier", "stiffness_N_m"): (0.0, -1.0),
    ("contact", "logbarrier", "distance_m"): (0.0, -1.0),
    ("contact", "logbarrier", "damping_s"): (-1e-9,),
    ("contact", "logbarrier", "weighting"): ("", "per_area"),
    ("contact", "penalty", "stiffness_N_m"): (0.0, -1.0),
    ("contact", "penalty", "weighting"): ("", "per_area"),
    ("contact", "hunt_crossley", "restitution"): (0.0, 1.01),
    ("contact", "hunt_crossley", "impact_speed_m_s"): (0.0, -1.0),
    ("contact", "hunt_crossley", "stiffness_N_m"): (0.0, -1.0),
    ("contact", "hunt_crossley", "penetration_m"): (0.0, -1.0),
    ("contact", "hunt_crossley", "weighting"): ("", "per_area"),
    ("contact", "signorini", "restitution"): (-0.01, 1.01),
    ("integrator", "newmark", "beta"): (0.24, 1.01),
    ("integrator", "newmark", "gamma"): (0.49, 1.01),
    ("integrator", "generalized_alpha", "spectral_radius"): (-0.01, 1.01),
    ("friction", "implicit", "velocity_threshold_m_s"): (0.0, -1.0),
    ("friction", "lagged", "velocity_threshold_m_s"): (0.0, -1.0),
    ("damping", "kelvin_voigt", "relaxation_time_s"): (-1e-9,),
    ("damping", "mass_proportional", "rate_1_s"): (-1e-9,),
    ("stepping", "fixed", "step_s"): (0.0, -1e-5, 0.0101),
    ("stepping", "adaptive", "tolerance"): (0.0, 0.9e-12, 1.1e-2),
    ("stepping", "adaptive", "contact_steps"): (0.0, -1.0),
    ("backend", "lanes", "width"): (0, 1, 3, 32),
    ("executor", "dask", "scheduler"): ("", "localhost", "tcp://host", "http://host:80", 8786),
    ("executor", "dask", "workers"): (0, 1025, 2.0),
    ("plan", "grid", "points"): (1, 1001, 15.0),
    ("backend", "lanes", "threads"): (0, 1025, 2.0),
    ("backend", "cuda", "device"): (-1, 1024, 0.0),
    ("backend", "cuda", "memory_gib"): (0.0, -1.0, 1025.0),
    ("backend", "cuda", "threads_per_block"): (0, 16, 33, 288, 64.0),
}
# Whether the ends of a range are robots is told by the simulation: tests/plan/test_axes.py.
RANGE_OF = {
    "inputs": ({}, [0.1, 0.3]),
    "delta_alpha_rad": ([0.1, 0.1], [0.2, 0.1], [0.1, math.nan]),
    "epsilon": ([0.1, 0.2, 0.3], {"low": 0.1}),
    "mass_bar": ([1.0, math.inf], [0.5, "2"]),
    "mu": ([True, 2.0],),
}
for name in ("grid", "sobol", "latin_hypercube"):
    OUTSIDE |= {("plan", name, field): values for field, values in RANGE_OF.items()}
for name in ("sobol", "latin_hypercube"):
    OUTSIDE[("plan", name, "count")] = (0, 2**30 + 1, 64.0)
    OUTSIDE[("plan", name, "seed")] = (-1, 2**32, 0.5)
ROW_OF = {
    "order": (0, 13, 2.5),
    "damping_at_infinity": (-0.1, 1.1),
    "rows": ("rows", [[0.0]], [[0.0], [0.5, -1.0]], [[0.5], [0.0, 1.0]], [[0.0], [1.0]]),
    "weights": ([0.5], "weights"),
    "embedded": ([0.5], "embedded"),
}
for name in tableaux():
    OUTSIDE |= {("integrator", name, field): values for field, values in ROW_OF.items()}
MAY_BE_NONE = ("weights", "embedded", "threads", "scheduler", *RANGE_OF)
WRONG = (math.nan, math.inf, "much", None, [1.0])
CASES = [
    (family, member, field, value)
    for (family, member, field), values in OUTSIDE.items()
    for value in (*values, *WRONG)
    if value is not None or field not in MAY_BE_NONE
]


def test_every_field_of_every_option_is_listed_here():
    fields = {
        (family, name, field.name)
        for family, members in EVERY.items()
        for name, options in members.items()
        for field in dataclasses.fields(options)
    }
    assert fields == set(OUTSIDE)


@pytest.mark.parametrize(("family", "member", "field", "value"), CASES)
def test_values_out_of_range(family, member, field, value):
    with pytest.raises(ParameterError) as caught:
        EVERY[family][member](**{field: value})
    error = caught.value
    assert error.key == f"{family}.{field}"
    message = str(error)
    assert message.startswith(f"{error.key} = ")
    assert field == "rows" or str(value) in message
    assert error.allowed
    assert "\n" not in message


def test_numbers_are_not_truth_values():
    for family, member, field in OUTSIDE:
        if field in ("clamp", "weighting", "beam_on_top"):
            continue
        with pytest.raises(ParameterError):
            EVERY[family][member](**{field: True})


@pytest.mark.parametrize("clamp", ["half_element", "two_nodes"])
def test_masses_of_chain_and_clamps_are_the_beam_s(clamp):
    options = DiscreteElasticRodOptions(20, clamp)
    masses = options.masses()
    assert len(masses) == options.moving_elements + 1
    assert masses.sum() + 2.0 * options.clamped_mass_bar == pytest.approx(1.0, rel=1e-14)
    assert masses[0] == masses[-1] == 0.0
    assert (masses[1:-1] == 1.0 / 20).all()


@pytest.mark.parametrize("tier", sorted(TIERS))
def test_every_tier_composes(tier):
    simulation = with_tier(tier)
    chosen = TIERS[tier]
    assert simulation.name("integrator") == chosen.integrator
    assert simulation.name("friction") == chosen.friction
    assert simulation.discretization.elements == chosen.elements
    replaced = with_tier(tier, discretization=DiscreteElasticRodOptions(33))
    assert replaced.discretization.elements == 33


@pytest.mark.parametrize(
    ("scene", "family", "member"),
    [
        ("jump", "frame", "fixed"),
        ("jump", "contact", "none"),
        ("snap", "contact", "logbarrier"),
        ("static", "frame", "rigid"),
        ("bounce", "contact", "none"),
    ],
)
def test_parts_that_do_not_fit_a_scene(scene, family, member):
    parts = {
        "sim": FAMILIES["sim"][scene](),
        "frame": FAMILIES["frame"]["rigid" if scene == "jump" else "fixed"](),
        "contact": FAMILIES["contact"]["logbarrier" if scene in ("jump", "bounce") else "none"](),
        "friction": FAMILIES["friction"]["implicit" if scene == "jump" else "none"](),
    }
    Simulation(**parts)
    with pytest.raises(ParameterError) as caught:
        Simulation(**(parts | {family: FAMILIES[family][member]()}))
    assert caught.value.key == family
    assert f"sim={scene}" in str(caught.value)


def test_plain_configurations_become_simulations():
    config = {
        "stepping": {"name": "fixed", "step_s": 2e-6},
        "design": {"epsilon": 0.15},
        "accuracy": {"name": "draft"},
    }
    simulation = build(config)
    assert simulation.stepping == FAMILIES["stepping"]["fixed"](2e-6)
    assert simulation.design.epsilon == 0.15
    assert name_of("stepping", simulation.stepping) == "fixed"


@pytest.mark.parametrize(
    ("config", "key"),
    [
        ({"stepping": {"name": "fixed", "step": 1.0}}, "stepping.step"),
        ({"robot": {"size": 1.0}}, "robot.size"),
        ({"stepping": {"name": "random"}}, "stepping"),
        ({"accuracy": {"name": "perfect"}}, "accuracy.name"),
    ],
)
def test_unknown_keys_and_members(config, key):
    with pytest.raises(ParameterError) as caught:
        build(config)
    assert caught.value.key == key


def test_a_new_runge_kutta_method_is_its_tableau_alone(monkeypatch):
    """Three stages of third order (Alexander 1977), known to nobody but this configuration."""
    g = 0.4358665215084590
    b = (-1.5 * g * g + 4.0 * g - 0.25, 1.5 * g * g - 5.0 * g + 1.25)
    rows = [[0.0], [0.0, g], [0.0, 0.5 * (1.0 - g), g], [0.0, *b, g]]
    monkeypatch.setitem(FAMILIES, "integrator", dict(FAMILIES["integrator"]))
    values = {"name": "alexander3", "order": 3, "damping_at_infinity": 0.0, "rows": rows}
    simulation = build({"integrator": values})
    assert simulation.name("integrator") == "alexander3"
    scheme = simulation.integrator.scheme()
    assert len(scheme.error) == 4
    assert scheme.nodes @ scheme.weights == pytest.approx(0.5)
    assert scheme.nodes**2 @ scheme.weights == pytest.approx(1.0 / 3.0)
    with pytest.raises(ParameterError, match="integrator.rows"):
        build(
            {"integrator": {**values, "name": "other", "rows": [[0.0], [0.0, g], [0.0, 0.5, 1.0]]}}
        )
