"""Every field of every option is checked: its key, the value and the range in one line."""

import math

import pytest
from families import EVERY as FAMILIES
from refusals import refused

from snapjump import Design, Environment, ParameterError, Robot
from snapjump.composition import Simulation, with_tier
from snapjump.declare.fields import Choice, Flag, Integer, Number, settings
from snapjump.declare.members import member_class
from snapjump.discretization.der import DiscreteElasticRod
from snapjump.integrator.parts.runge_kutta import RungeKutta
from snapjump.learning.training import Training
from snapjump.simulation import build
from snapjump.targets.robust import Tolerance
from snapjump.tiers import TIERS

PARTS = {cls.group: {cls.group: cls} for cls in (Robot, Design, Environment, Training)}
EVERY = FAMILIES | PARTS | {"tolerance": {"tolerance": Tolerance}}
# Values just outside of ranges that are not declared, or that depend on other fields.
FURTHER = {
    ("integrator", "newmark", "beta"): (0.24, 1.01),
    ("executor", "dask", "scheduler"): ("", "localhost", "tcp://host", "http://host:80", 8786),
    ("backend", "lanes", "width"): (0, 1, 3, 32), ("backend", "lanes", "threads"): (0, 1025, 2.0),
    ("backend", "cuda", "threads_per_block"): (0, 16, 33, 288, 64.0),
    ("plan", "grid", "points"): (1, 1001, 15.0), ("inverse", "bayesian", "first"): (0, 61, 1.5),
    ("inverse", "physics", "slopes"): ("none",), ("inverse", "physics", "finishing"): ("draft",),
    ("surrogate", "rbf", "kernel"): ("gaussian",), ("robot", "robot", "thickness_m"): (2.1e-3,),
    ("robot", "robot", "mount_height"): (0.0101, "highest"),
    ("training", "training", "batch_last"): (32, 1000, 96),
}  # fmt: skip
FURTHER["uncertainty", "model", "tolerances"] = (3, [0.1])
for field in settings(Tolerance()):
    FURTHER["tolerance", "tolerance", field] = (-0.1, 1e9)
# Whether the ends of a range are robots is told by the simulation: tests/plan/test_plans.py.
RANGE_OF = {
    "inputs": ({}, [0.1, 0.3]),
    "delta_alpha_rad": ([0.1, 0.1], [0.2, 0.1], [0.1, math.nan]),
    "epsilon": ([0.1, 0.2, 0.3], {"low": 0.1}),
    "mass_bar": ([1.0, math.inf], [0.5, "2"]),
    "mu": ([True, 2.0],),
}
for name in ("grid", "sobol", "latin_hypercube"):
    FURTHER |= {("plan", name, field): values for field, values in RANGE_OF.items()}
for name in ("sobol", "latin_hypercube"):
    FURTHER[("plan", name, "count")] = (0, 2**30 + 1, 64.0)
    FURTHER[("plan", name, "seed")] = (-1, 2**32, 0.5)
FURTHER["drive", "table", "file"] = ("", "nowhere.csv", 1.0)
FURTHER["drive", "table", "rows"] = ("rows", [[0.0, 0.1, 0.0]], [[0.0, 0.1]] * 3)
ROW_OF = {
    "order": (0, 13, 2.5),
    "damping_at_infinity": (-0.1, 1.1),
    "rows": ("rows", [[0.0]], [[0.0], [0.5, -1.0]], [[0.5], [0.0, 1.0]], [[0.0], [1.0]]),
    "weights": ([0.5], "weights"),
    "embedded": ([0.5], "embedded"),
}
for name, cls in EVERY["integrator"].items():
    if isinstance(cls(), RungeKutta):
        FURTHER |= {("integrator", name, field): values for field, values in ROW_OF.items()}
MAY_BE_NONE = {("plan", field) for field in RANGE_OF}
MAY_BE_NONE |= {("integrator", "weights"), ("integrator", "embedded")}
MAY_BE_NONE |= {("frame", "mass_centre_height_m"), ("frame", "inertia_kg_m2"), ("drag", "area_m2")}
MAY_BE_NONE |= {("drive", "right_rate_rad_s"), ("drive", "file"), ("drive", "rows")}
MAY_BE_NONE |= {
    ("robot", "yield_stress_Pa"),
    ("uncertainty", "tolerances"),
    ("backend", "threads"),
    ("executor", "scheduler"),
    ("training", "rows"),
}
WRONG = (math.nan, math.inf, "much", None, [1.0])


def outside(allowed):
    """Values just outside what a field declares."""
    if isinstance(allowed, Number):
        yield from [math.nextafter(allowed.low, -math.inf)] * math.isfinite(allowed.low)
        yield from [allowed.low] * allowed.above
        yield from [math.nextafter(allowed.high, math.inf)] * math.isfinite(allowed.high)
    elif isinstance(allowed, Integer):
        yield from (allowed.low - 1, allowed.high + 1, allowed.low + 0.5)
    elif isinstance(allowed, Choice):
        yield from ("", "no such word")
    elif isinstance(allowed, Flag):
        yield from (0, 1, "true")


def cases():
    """(family, member, field, value) of every field of every member."""
    for family, members in EVERY.items():
        for member, cls in members.items():
            part = cls()
            for field in settings(part):
                allowed = type(part).__dataclass_fields__[field].metadata.get("allowed")
                values = (*FURTHER.get((family, member, field), ()), *outside(allowed))
                assert values, (family, member, field)
                for value in (*values, *WRONG):
                    if value is not None or (family, field) not in MAY_BE_NONE:
                        yield family, member, field, value


CASES = list(cases())
FLAGS = {case[:3] for case in CASES if case[3] == "true"}


@pytest.mark.parametrize(("family", "member", "field", "value"), CASES)
def test_values_out_of_range(family, member, field, value):
    shown = () if field == "rows" else (repr(value),)
    with refused(f"{family}.{field}", *shown) as caught:
        EVERY[family][member](**{field: value})
    assert caught.value.allowed


def test_numbers_are_not_truth_values():
    for family, member, field in {case[:3] for case in CASES} - FLAGS:
        with pytest.raises(ParameterError):
            EVERY[family][member](**{field: True})


@pytest.mark.parametrize("clamp", ["half_element", "two_nodes"])
def test_masses_of_chain_and_clamps_are_the_beam_s(clamp):
    options = DiscreteElasticRod(20, clamp)
    masses = options.masses()
    assert len(masses) == options.moving_elements + 1
    assert masses.sum() + 2.0 * options.clamped_mass_bar == pytest.approx(1.0, rel=1e-14)
    assert masses[0] == masses[-1] == 0.0
    assert (masses[1:-1] == 1.0 / 20).all()


@pytest.mark.parametrize("tier", sorted(TIERS))
def test_every_tier_composes(tier):
    simulation = with_tier(tier)
    chosen = TIERS[tier]
    assert {family: getattr(simulation, family).name for family in chosen.members} == chosen.members
    assert simulation.discretization.elements == chosen.numbers["discretization.elements"]
    replaced = with_tier(tier, discretization=DiscreteElasticRod(33))
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
    Simulation(sim=scene)
    with refused(family, f"sim={scene}"):
        Simulation(sim=scene, **{family: member})


def test_plain_configurations_become_simulations():
    config = {
        "stepping": {"name": "fixed", "step_s": 2e-6},
        "design": {"epsilon": 0.15},
        "accuracy": {"name": "draft"},
    }
    simulation = build(config)
    assert simulation.stepping == member_class("stepping", "fixed")(2e-6)
    assert simulation.design.epsilon == 0.15
    assert simulation.stepping.name == "fixed"


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
    with refused(key):
        build(config)


def test_a_new_runge_kutta_method_is_its_tableau_alone():
    """Three stages of third order (Alexander 1977), known to nobody but this configuration."""
    g = 0.4358665215084590
    b = (-1.5 * g * g + 4.0 * g - 0.25, 1.5 * g * g - 5.0 * g + 1.25)
    rows = [[0.0], [0.0, g], [0.0, 0.5 * (1.0 - g), g], [0.0, *b, g]]
    values = {"name": "alexander3", "order": 3, "damping_at_infinity": 0.0, "rows": rows}
    simulation = build({"integrator": values})
    assert simulation.integrator.name == "alexander3"
    scheme = simulation.integrator.scheme()
    assert len(scheme.comparison) == 4
    assert scheme.nodes @ scheme.weights == pytest.approx(0.5)
    assert scheme.nodes**2 @ scheme.weights == pytest.approx(1.0 / 3.0)
    with pytest.raises(ParameterError, match="integrator.rows"):
        build(
            {"integrator": {**values, "name": "other", "rows": [[0.0], [0.0, g], [0.0, 0.5, 1.0]]}}
        )
