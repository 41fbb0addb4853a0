"""Nothing inside has a scale of its own: a world of other lengths, times and masses is the same.

By powers of two, which round nothing: every output is then equal to the last bit.
"""

from dataclasses import replace

import numpy as np
import pytest
import yaml
from before_the_strike import begin_before_the_strike
from families import FAMILIES, MEMBERS
from golden import FOLDER, plain, spelled_out
from plain_march import without_compiling
from scaled import Factors, dimensional, scaled, scaled_row

from snapjump.batch import Batch, simulate_batch
from snapjump.batch.derivatives import model_derivatives
from snapjump.composition import with_tier
from snapjump.declare.inputs import input_at, value_at
from snapjump.engine.model import numbers_of
from snapjump.scenes.jump_start import jump_model
from snapjump.scenes.runner import MOST_ITERATIONS
from snapjump.scenes.swing import follow
from snapjump.simulation import build, simulate
from snapjump.targets.simulator import differentiable
from snapjump.tiers import TIERS

AS_IT_IS = Factors(1.0, 1.0, 1.0)
# A beam of 0.16 mm that moves four times as fast, and one of 2.6 m, sixteen times as slowly.
SMALL, LARGE = Factors(2.0**-7, 2.0**-9, 2.0**-18), Factors(2.0**7, 2.0**11, 2.0**18)
COMPOSITIONS = yaml.safe_load((FOLDER / "compositions.yaml").read_text())
SCENES = yaml.safe_load((FOLDER / "programs.yaml").read_text())["scenes"]
COARSE = {
    "sim": {"jump": {"start_fraction": 0.9}},
    "discretization": {name: {"elements": 10} for name in FAMILIES["discretization"]},
    "stepping": {
        "adaptive": {"tolerance": 1e-4, "contact_steps": 8.0, "stick_share": 1e6},
        "fixed": {"step_s": 4e-5},
    },
    "frame": {
        "elastic": {"leg_elements": 5, "top_elements": 6, "bending_ratio": 1e4, "inset_m": 3e-4},
        "rigid": {
            "mass_centre_height_m": 8e-3,
            "mass_centre_offset_m": 1e-4,
            "inertia_kg_m2": 1e-7,
            "clamp_mass_kg": 1e-4,
        },
    },
    "drive": {name: {"right_rate_rad_s": 18.0} for name in ("constant_rate", "smooth_start")},
    "contact": {
        "logbarrier": {"damping_s": 1e-7},
        "penalty": {"stiffness_N_m": 1e4},
        "hunt_crossley": {"stiffness_N_m": 1e4},
    },
    "damping": {"kelvin_voigt": {"relaxation_time_s": 1e-6}},
    "drag": {"quadratic": {"area_m2": 2e-4}},
}


def few(compositions):
    """So many of them that every member is in one."""
    found, seen = [], set()
    for choice in compositions:
        if not set(choice.items()) <= seen:
            found.append(choice)
            seen |= set(choice.items())
    return found


def rattles(choice):
    """Whether it takes tens of iterations a step, as an elastic frame does in fixed ones."""
    return {"elastic", "fixed"} <= set(choice.values())


JUMPS = [{"sim": "jump"} | choice for choice in few(sorted(COMPOSITIONS, key=rattles))]
CHOICES = JUMPS + [{"sim": name} | choice for name, choice in SCENES.items()]
# A table's times are in its rows, which no unit is declared of.
DRIVES = [name for name in FAMILIES["drive"] if name != "table"]
SNAP = {"sim": "snap"} | SCENES["snap"]
CHOICES += [SNAP | {"drive": name} for name in DRIVES if name != SNAP["drive"]]


def coarse(choice):
    """The simulation of a composition, coarsely; an arch needs less than a jump does to swing."""
    base = build(spelled_out(choice, COARSE))
    if choice["sim"] != "snap":
        return base
    return replace(base, stepping=base.stepping.changed(tolerance=1e-2))


def tried(choice):
    """The members of a composition, and their numbers that have a dimension and are not 0."""
    base = build(spelled_out(choice, COARSE))
    for family in FAMILIES:
        part = getattr(base, family)
        yield family, part.name
        yield from ((family, part.name, key) for key in dimensional(part) if getattr(part, key))


def test_every_member_is_tried_with_every_number_that_has_a_dimension():
    known = {found for choice in CHOICES for found in tried(choice)}
    for family, name in MEMBERS:
        assert (family, name) in known or family == "backend" or name == "table"
        for key in dimensional(FAMILIES[family][name]()):
            assert (family, name, key) in known


def name_of(choice):
    return "-".join(choice.values())


def outputs(simulation, factors):
    """Outputs of a simulation, scaled."""
    if simulation.sim.name == "jump":
        # An explicit scheme's ten thousands of steps are for the compiled program.
        most = 300.0 if simulation.integrator.name == "central_difference" else MOST_ITERATIONS
        batch = simulate_batch([simulation], lanes=1, most_iterations=most)
        return plain(scaled_row(Batch, batch.rows()[0], factors))
    return plain(scaled_row(simulation.sim.outputs, simulate(simulation).summary, factors))


@pytest.mark.parametrize("choice", CHOICES, ids=name_of)
def test_outputs_are_the_same_at_any_scale(choice, monkeypatch):
    base = coarse(choice)
    if choice["sim"] == "jump" and base.integrator.a_stable:
        usual = {family: choice[family] for family in ("sim", "discretization", "frame")}
        begin_before_the_strike(monkeypatch, build(spelled_out(usual, COARSE)))
    else:
        without_compiling(monkeypatch)
    assert outputs(scaled(base, SMALL), AS_IT_IS) == outputs(base, SMALL)


@pytest.mark.parametrize("factors", [SMALL, LARGE])
@pytest.mark.parametrize("tier", TIERS)
def test_every_tier_steps_alike_at_any_scale(tier, factors):
    base = with_tier(tier)
    found, expected = (
        one.stepping.control(one.robot.scales) for one in (scaled(base, factors), base)
    )
    assert found == expected


DRAFT = with_tier("draft")


@pytest.mark.parametrize("zone_m_s", [1e-4, 6e-3])
@pytest.mark.parametrize("factors", [SMALL, LARGE])
def test_stick_zones_are_widened_alike(zone_m_s, factors):
    base = replace(DRAFT, friction=DRAFT.friction.changed(velocity_threshold_m_s=zone_m_s))
    assert differentiable(scaled(base, factors)) == scaled(differentiable(base), factors)


def test_a_given_mount_height_is_a_length():
    base = replace(DRAFT, robot=DRAFT.robot.changed(mount_height=2e-3))
    found, expected = (numbers_of(jump_model(one)) for one in (scaled(base, LARGE), base))
    np.testing.assert_array_equal(found, expected)


PATHS = ("robot.thickness_m", "contact.distance_m", "damping.relaxation_time_s")


def test_derivatives_of_numbers_are_alike():
    small = scaled(DRAFT, SMALL)
    found, expected = (
        model_derivatives(one, np.array([[value_at(one, path) for path in PATHS]]), None, PATHS)
        for one in (small, DRAFT)
    )
    factors = [SMALL.of(input_at(DRAFT, path).unit) for path in PATHS]
    np.testing.assert_array_equal(found * factors, expected)


def test_a_swing_keeps_the_same_steps(monkeypatch):
    without_compiling(monkeypatch)
    base = coarse(SNAP)
    found, expected = follow(scaled(base, SMALL)), follow(base)
    np.testing.assert_array_equal(found.time_s, SMALL.time * expected.time_s)
    np.testing.assert_array_equal(found.y, expected.y)
