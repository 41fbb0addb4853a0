"""Gauss-Newton on a simulator: through wrinkles and roughness, at bounds, and at two tiers."""

from dataclasses import dataclass, field
from typing import Any

import numpy as np
import pytest
from made_up_maps import MadeUpModel, MadeUpSimulator, problem, straight

from snapjump.inverse.physics import CANDIDATES, PhysicsOptions, Search, fit, step

REACHED_BAR = 3.0e-4


def wrinkled(designs: Any) -> Any:
    """Slopes that are half wrong everywhere, and the last digits anybody's guess, as jumps have."""
    delta_alpha, epsilon = designs[:, 0], designs[:, 1]
    phase = 3000.0 * delta_alpha + 2000.0 * epsilon
    wrinkles = 0.003 * np.stack([np.sin(phase), np.cos(1.3 * phase)], axis=1)
    rough = [1e-3, 3e-4] * np.sin(1e9 * designs[:, :2] + 1e8 * designs[:, 1::-1])
    found: Any = straight(designs) + 0.02 + wrinkles + rough
    return found


@dataclass
class Tiers(MadeUpSimulator):
    """A simulator with a finer tier, which is a little higher."""

    finer: Any = field(default_factory=lambda: MadeUpSimulator(straight, (0.004, -0.003)))

    def at(self, tier: str) -> Any:
        assert tier == "reference"
        return self.finer


@pytest.mark.parametrize("seed", range(8))
def test_fitted_slopes_see_over_wrinkles_and_roughness(seed):
    rng = np.random.default_rng(seed)
    hidden = np.array([[0.03 + 0.14 * rng.random(), 0.12 + 0.16 * rng.random(), 1.0, 0.3]])
    simulator = MadeUpSimulator(wrinkled)
    given = problem(wrinkled(hidden)[0], MadeUpModel(), simulator)
    best = PhysicsOptions().solve(given)[0]
    reached = wrinkled(given.designs(best.controls[None]))[0]
    assert best.simulated
    assert np.hypot(*(reached - given.target)) <= REACHED_BAR
    assert best.apex == pytest.approx(reached, abs=1e-12)
    assert simulator.simulations <= 12 * CANDIDATES


def test_exact_slopes_reach_a_smooth_simulator_s_target_in_few_rounds():
    simulator = MadeUpSimulator(straight, (0.05, -0.04))
    given = problem([2.0, 12.0], MadeUpModel(), simulator)
    best = PhysicsOptions(slopes="exact").solve(given)[0]
    assert best.miss_bar(given.target) <= REACHED_BAR
    assert simulator.simulations <= 30


def test_the_last_steps_are_of_the_finer_tier():
    simulator = Tiers()
    given = problem([2.0, 12.0], MadeUpModel(), simulator)
    best = PhysicsOptions(finishing="reference").solve(given)[0]
    reached = simulator.finer.apexes(given.designs(best.controls[None]))[0]
    assert np.hypot(*(reached - given.target)) <= REACHED_BAR
    assert simulator.simulations > 0


@pytest.mark.parametrize("slopes", ["fitted", "exact"])
def test_without_a_forward_model_it_begins_with_a_grid_of_simulations(slopes):
    given = problem([2.0, 12.0], None, MadeUpSimulator())
    best = PhysicsOptions(slopes=slopes).solve(given)[0]
    assert best.miss_bar(given.target) <= REACHED_BAR


def test_an_unreachable_target_ends_at_the_bounds_within_its_budget():
    simulator = MadeUpSimulator()
    given = problem([2.0, 30.0], MadeUpModel(), simulator)
    options = PhysicsOptions(most_simulations=80)
    best = options.solve(given)[0]
    assert best.controls[1] == pytest.approx(0.3, abs=1e-3)
    assert ((best.controls >= given.low) & (best.controls <= given.high)).all()
    assert best.miss_bar(given.target) == pytest.approx(12.0, abs=0.05)
    # From one start by fits, and before it is given up from there and from the end by differences.
    assert simulator.simulations <= 3 * 80


def stays(search: Search, start: Any) -> Any:
    """Rounds of fits that lead nowhere: to a corner, far from the target."""
    search.simulate(np.zeros((1, 2)))
    yield search.best()


def test_what_fits_do_not_reach_differences_may(monkeypatch):
    target = wrinkled(np.array([[0.16, 0.27, 1.0, 0.3]]))[0]
    given = problem(target, MadeUpModel(), MadeUpSimulator(wrinkled))
    monkeypatch.setattr("snapjump.inverse.physics.fitted_rounds", stays)
    assert PhysicsOptions().solve(given)[0].miss_bar(given.target) <= 0.03


def test_jumps_that_fail_are_passed_over():
    def half(designs: Any) -> Any:
        found = straight(designs)
        found[designs[:, 0] > 0.1] = np.nan
        return found

    target = straight(np.array([[0.09, 0.2, 1.0, 0.3]]))[0]
    given = problem(target, MadeUpModel(), MadeUpSimulator(half))
    assert PhysicsOptions().solve(given)[0].miss_bar(given.target) <= REACHED_BAR


def test_where_nothing_jumps_the_answer_is_infinitely_far():
    given = problem([2.0, 12.0], MadeUpModel(), MadeUpSimulator(straight, (np.nan, np.nan)))
    best = PhysicsOptions(most_simulations=16).solve(given)[0]
    assert best.miss_bar(given.target) == np.inf


def test_a_step_stays_within_bounds_and_is_exact_inside():
    slopes = np.array([[2.0, 1.0], [-1.0, 3.0]])
    change = np.array([0.02, 0.05])
    assert slopes @ step(slopes, change, np.full(2, 0.5)) == pytest.approx(change)
    held = step(slopes, np.array([0.0, 10.0]), np.array([0.5, 0.9]))
    assert held[1] <= 0.1 + 1e-9


def test_a_fit_to_many_points_finds_the_slopes_and_to_one_keeps_the_given_ones():
    given = problem([2.0, 12.0], MadeUpModel(), MadeUpSimulator())
    search = Search(given, given.simulator)
    wrong = np.array([[1.0, 0.0], [0.0, 1.0]])
    search.simulate(np.array([[0.5, 0.5]]))
    assert fit(search, wrong)[2] == pytest.approx(wrong)
    rng = np.random.default_rng(0)
    search.simulate(0.5 + 0.05 * rng.standard_normal((20, 2)))
    design = given.designs(given.unscaled(np.array([[0.5, 0.5]])))
    true = MadeUpModel().jacobian(design)[0, :, :2] * (given.high - given.low)
    assert fit(search, wrong)[2] == pytest.approx(true, rel=0.1, abs=0.05)
