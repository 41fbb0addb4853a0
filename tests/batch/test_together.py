"""Designs that are prepared together are, to the last bit, what each of them is alone."""

from dataclasses import fields, replace
from importlib import import_module

import numpy as np
import pytest
from robots import BASELINE as BASE

from snapjump.batch import prepare_designs, variant, variants
from snapjump.batch.together import take_arrays
from snapjump.contact.logbarrier import LogBarrier
from snapjump.declare.inputs import DEFAULT_INPUTS, inputs_of, with_inputs
from snapjump.declare.members import make_member
from snapjump.engine.model import numbers_of
from snapjump.scenes.jump_start import jump_model
from snapjump.scenes.resting import resting_guesses
from snapjump.statics.threshold_curve import ThresholdCurve

# Members that make something of inputs, and what else they need.
MEMBERS = {
    "contact": ("logbarrier", "penalty", "hunt_crossley", "signorini"),
    "friction": ("implicit", "lagged", "none"),
    "damping": ("kelvin_voigt", "mass_proportional", "none"),
    "drag": ("quadratic", "none"),
}
NEEDED = {"signorini": {"integrator": make_member("integrator", {"name": "implicit_euler"})}}
ROBOTS = 12
# delta_alpha, epsilon, mass_bar, mu: what is refused is between what is not.
ROWS = np.array([
    (0.1, 0.2, 0.768, 0.3), (0.1, 0.41, 0.768, 0.3), (0.6, 0.2, 0.768, 0.3), (-0.2, 0.2, 1.0, 0.3),
    (0.1, 0.2, 0.001, 0.3), (0.1, 0.2, 0.768, -0.1), (0.1, np.nan, 0.768, 0.3),
    (0.1, 1e-6, 0.768, 0.3), (0.1, 0.0, 0.768, 0.3), (-0.0, 0.3, 0.5, 0.0), (np.inf, 0.2, 0.8, 0.3),
    (0.1, 0.39, 0.768, 0.3), (0.5, 0.25, 0.768, 100.0), (-0.5, 0.25, 0.768, 101.0),
])  # fmt: skip


def member(family, name):
    """A simulation with another member."""
    parts = {family: make_member(family, {"name": name}), **NEEDED.get(name, {})}
    return replace(BASE, **parts)


def inputs_together(base):
    """The inputs that models are made of side by side."""
    return [path for path, one in inputs_of(base).items() if one.takes_arrays]


def spread(base, paths, robots=ROBOTS):
    """Designs (R, I) over the inputs' planned ranges."""
    ranges = np.array([inputs_of(base)[path].plan for path in paths])
    shares = np.random.default_rng(5).random((robots, len(paths)))
    return ranges[:, 0] + shares * (ranges[:, 1] - ranges[:, 0])


def check(base, designs, paths, curve=None):
    """Models, starts, units and simulations of prepared designs against those of each alone."""
    ready = prepare_designs(base, designs, curve, paths)
    assert ready.alike is not None and len(ready.chosen) == len(designs)
    guesses = resting_guesses(base, ready.models, ready.compressions)
    for k, alone in enumerate(variants(base, designs, paths)):
        one = prepare_designs(base, designs[k : k + 1], curve, paths)
        assert one.alike is None
        assert np.array_equal(ready.models.numbers[k], one.models.numbers[0])
        assert ready.models[k] == one.models[0] and ready.simulations[k] == alone
        assert all(type(number) is float for part in ready.models[k] for number in part)
        assert np.array_equal(guesses[k], resting_guesses(alone, one.models, one.compressions)[0])
        assert [getattr(ready.scales, f.name)[k] for f in fields(alone.robot.scales)] == [
            getattr(alone.robot.scales, f.name) for f in fields(alone.robot.scales)
        ]


@pytest.mark.parametrize(
    ("family", "name"), [(family, name) for family, names in MEMBERS.items() for name in names]
)
def test_all_inputs_of_a_composition_at_once(family, name):
    base = member(family, name)
    paths = inputs_together(base)
    check(base, spread(base, paths), paths)


@pytest.mark.parametrize("path", inputs_together(BASE))
def test_one_input(path):
    check(BASE, spread(BASE, [path]), [path])


@pytest.mark.parametrize("mount_height", ["optimal", "fitted"])
@pytest.mark.parametrize("start_fraction", [0.0, 0.7])
def test_with_a_curve_that_reaches_some(mount_height, start_fraction):
    base = replace(
        BASE,
        robot=replace(BASE.robot, mount_height=mount_height),
        sim=replace(BASE.sim, start_fraction=start_fraction),
    )
    curve = ThresholdCurve.through(base.robot, base.discretization, 0.15, 0.25)
    check(base, spread(base, DEFAULT_INPUTS), DEFAULT_INPUTS, curve)


def test_which_inputs_are_for_each_robot_alone():
    """What its units are made of, and what asks for statics or a law of its own."""
    units = ("length_m", "width_m", "thickness_m", "youngs_modulus_Pa", "density_kg_m3")
    alone = {path for path, one in inputs_of(BASE).items() if not one.takes_arrays}
    assert alone == {f"robot.{n}" for n in (*units, "mount_height")} | {"environment.slope_rad"}


@pytest.mark.parametrize("with_curve", [False, True])
def test_refused_rows_say_what_they_say_alone(with_curve):
    curve = None
    if with_curve:
        curve = ThresholdCurve.through(BASE.robot, BASE.discretization, 0.1, 0.3)
    ready = prepare_designs(BASE, ROWS, curve)
    assert ready.alike is not None
    refused = {}
    for k in range(len(ROWS)):
        one = prepare_designs(BASE, ROWS[k : k + 1], curve)
        assert ready.status[k] == one.status[0]
        if one.refusals:
            refused[k] = one.refusals[0]
        if len(one.models):
            place = ready.chosen.tolist().index(k)
            assert np.array_equal(ready.models.numbers[place], one.models.numbers[0])
    assert ready.refusals == refused and len(refused) == 9


def test_clamps_that_stop_too_early_and_robots_without_weight():
    paths = ("drive.end_rad", "robot.gravity_m_s2")
    rows = np.array([(0.2, 10.0), (1.5, 10.0), (1.5, 0.0), (1.4, 5.0), (1.5, 0.01), (1.6, 10.0)])
    ready = prepare_designs(BASE, rows, None, paths)
    assert ready.chosen.tolist() == [1, 3, 4] and ready.alike is not None
    for k, key in ((0, paths[0]), (2, paths[1]), (5, paths[0])):
        assert ready.refusals[k].startswith(f"{key} = ")


@pytest.mark.parametrize(
    ("base", "paths", "rows"),
    [
        (BASE, ("robot.thickness_m", "design.epsilon"), ((5e-5, 0.2), (6e-5, 0.2))),
        (BASE, ("robot.mount_height",), ((2e-3,), (3e-3,))),
        (BASE, ("environment.slope_rad", "environment.mu"), ((0.02, 0.3), (0.5, 0.3), (0.0, 0.3))),
        (member("frame", "elastic"), ("design.epsilon",), ((0.2,), (0.25,))),
        (with_inputs(BASE, {"robot.mount_height": 3e-3}), ("design.epsilon",), ((0.2,), (0.25,))),
        (with_inputs(BASE, {"environment.slope_rad": 0.1}), ("environment.mu",), ((0.3,), (0.05,))),
    ],
)  # fmt: skip
def test_what_takes_single_numbers_is_prepared_alone(base, paths, rows):
    assert not take_arrays(base, paths)
    ready = prepare_designs(base, np.array(rows), None, paths)
    assert ready.alike is None
    for k, row in zip(ready.chosen, ready.models.numbers, strict=True):
        assert np.array_equal(row, numbers_of(jump_model(variant(base, rows[k], paths))))


def test_a_check_that_is_about_single_numbers_is_made_of_each():
    damping = make_member("damping", {"name": "kelvin_voigt", "relaxation_time_s": 0.0})
    explicit = make_member("integrator", {"name": "central_difference"})
    base = replace(BASE, damping=damping, integrator=explicit)
    path = "damping.relaxation_time_s"
    ready = prepare_designs(base, np.array([[0.0], [1e-4], [0.0]]), None, [path])
    assert ready.chosen.tolist() == [0, 2] and ready.refusals[1].startswith("damping = ")


class Stepped(LogBarrier):
    """A law that decides by its number."""

    def law(self, scales):
        stiffer = 2.0 if self.stiffness_N_m > 1.5e4 else 1.0
        return super().law(scales)._replace(stiffness=stiffer)


def test_a_law_that_decides_by_its_number_is_made_of_each():
    base = replace(BASE, contact=Stepped())
    path = "contact.stiffness_N_m"
    ready = prepare_designs(base, np.array([[1e4], [2e4]]), None, [path])
    found = [model.contact.stiffness for model in ready.models]
    assert ready.alike is None and found == pytest.approx([1.0, 2.0], rel=1e-12)


def test_no_simulation_is_built_that_nobody_asks_for(monkeypatch):
    designs = spread(BASE, DEFAULT_INPUTS)
    built = []
    module = import_module("snapjump.batch.variants")
    monkeypatch.setattr(module, "variant", lambda *arguments: built.append(arguments))
    ready = prepare_designs(BASE, designs)
    assert len(ready.simulations) == ROBOTS and ready.scales and ready.compressions.any()
    assert not built
    assert len(ready.simulations[2:4]) == 2 and len(list(ready.simulations)) == ROBOTS == len(built)
