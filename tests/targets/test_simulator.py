"""The simulator of targets: the library's jumps, their derivatives, and a count of them."""

from dataclasses import replace

import numpy as np
import pytest
from robots import BASELINE as BASE

from snapjump.batch import simulate_designs, variant
from snapjump.checks import ParameterError
from snapjump.composition import Simulation, with_tier
from snapjump.friction.implicit import ImplicitFriction
from snapjump.simulation import simulate
from snapjump.statics.threshold_curve import ThresholdCurve
from snapjump.targets.simulator import JumpSimulator

# delta_alpha, epsilon, mass_bar, mu; the third is too heavy to jump, the last cannot be built.
DESIGNS = np.array(
    [[0.1, 0.2, 0.768, 0.3], [0.02, 0.12, 0.4, 0.1], [0.1, 0.2, 300.0, 0.3], [0.1, 0.2, 1e-6, 0.3]]
)


def test_an_apex_is_that_of_a_jump_on_its_own():
    simulator = JumpSimulator(BASE)
    alone = [simulate(variant(BASE, design)) for design in DESIGNS[:2]]
    expected = [[jump.x_bar, jump.y_bar] for jump in alone]
    # One after the other, and side by side.
    np.testing.assert_array_equal(simulator.apexes(DESIGNS[:2]), expected)
    np.testing.assert_array_equal(simulator.apexes(DESIGNS)[:2], expected)
    assert simulator.simulations == 6


def test_what_does_not_jump_has_no_apex():
    simulator = JumpSimulator(BASE)
    assert np.isnan(simulator.apexes(DESIGNS[2:3])).all()
    failed = np.isnan(simulator.apexes(DESIGNS[[0, 2, 3]])).all(axis=1)
    assert failed.tolist() == [False, True, True]


@pytest.mark.compiles
def test_what_does_not_jump_has_no_slopes():
    assert np.isnan(JumpSimulator(BASE).slopes(DESIGNS[2:3])).all()


@pytest.mark.compiles
def test_slopes_are_those_with_a_wider_stick_zone():
    """The mesh is so fine that they do not depend on the last digits of a threshold."""
    base = with_tier("standard")
    simulator = JumpSimulator(base)
    finer = base.stepping.changed(tolerance=0.1 * base.stepping.tolerance)
    friction = ImplicitFriction(velocity_threshold_m_s=0.01)
    wider = replace(base, friction=friction, stepping=finer)
    curve = ThresholdCurve.through(base.robot, base.discretization, 0.1, 0.3)
    options = {"curve": curve, "threads": 1, "lanes": 8, "sensitivities": True}
    found = simulate_designs(wider, DESIGNS[:2], **options).sensitivities
    expected = np.stack([found.dx_bar, found.dy_bar], axis=1)
    alone = np.concatenate([simulator.slopes(design[None, :]) for design in DESIGNS[:2]])
    np.testing.assert_allclose(alone, expected, rtol=1e-3)
    np.testing.assert_allclose(simulator.slopes(DESIGNS[:2]), expected, rtol=1e-3)
    assert simulator.simulations == 4


@pytest.mark.parametrize("backend", ["scalar", "lanes"])
def test_every_backend_of_the_processor(backend):
    bases = (replace(BASE, backend=backend), BASE)
    np.testing.assert_array_equal(*(JumpSimulator(base).apexes(DESIGNS[:1]) for base in bases))


def test_modules_without_derivatives_and_other_scenes_are_refused():
    elastic = replace(BASE, frame="elastic")
    with pytest.raises(ParameterError, match="frame"):
        JumpSimulator(elastic).slopes(DESIGNS[:1])
    with pytest.raises(ParameterError, match="sim = 'snap'"):
        JumpSimulator(Simulation(sim="snap"))
