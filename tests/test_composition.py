"""Every pair of members of different families runs through a tiny jump, or is refused by name."""

from dataclasses import replace
from functools import cache
from itertools import combinations, product

import numpy as np
import pytest
import yaml
from before_the_strike import begin_before_the_strike
from families import FAMILIES
from golden import FOLDER, Golden, outcome, plain, spelled_out
from plain_march import without_compiling

from snapjump.batch import Batch, simulate_batch
from snapjump.checks import ParameterError
from snapjump.composition import Simulation
from snapjump.simulation import build

SWEPT = (
    *("integrator", "contact", "friction", "discretization", "damping", "frame", "stepping"),
    "drag",
)
Choice = dict[str, str]
Pair = frozenset[tuple[str, str]]

# What makes the tiny jump tinier, or what a jump of this kind needs.
TINY = {
    "sim": {"jump": {"start_fraction": 0.9}},
    "discretization": {name: {"elements": 10} for name in FAMILIES["discretization"]},
    "stepping": {
        "adaptive": {"tolerance": 1e-4, "contact_steps": 8.0, "stick_share": 1e6},
        "fixed": {"step_s": 4e-5},
    },
    "frame": {"elastic": {"leg_elements": 5, "top_elements": 6, "bending_ratio": 1e4}},
    # Springs of the ground so soft that steps as long as these resolve them.
    "contact": {"penalty": {"stiffness_N_m": 1e4}, "hunt_crossley": {"stiffness_N_m": 1e4}},
    # An explicit scheme cannot bear more at this mesh.
    "damping": {"kelvin_voigt": {"relaxation_time_s": 1e-6}},
}
USUAL = {"sim": "jump"} | yaml.safe_load((FOLDER / "programs.yaml").read_text())["jumps"]["default"]
HEIGHT, APART = 15.0, 6.0  # of so coarse jumps, in L: the converged one's is 14.3
UNRESOLVED = ("energy_gained", "step_underflow")
DEFAULT = {"integrator": "implicit_euler"}


def name_of(choice: Choice) -> str:
    return "-".join(choice[family] for family in SWEPT)


def composed(choice: Choice) -> Simulation:
    """The tiny jump with these members; raises ParameterError."""
    simulation = build(spelled_out(USUAL | choice, TINY))
    if {"elastic", "fixed"} <= set(choice.values()):
        # It rattles: Newton's method takes 40 iterations for a longer step, and schemes that do
        # not damp do not resolve it.
        return replace(simulation, stepping=replace(simulation.stepping, step_s=1e-5))
    return simulation


@cache
def refused(pair: Pair) -> str:
    """Why the default composition with this pair is refused; nothing if it is not."""
    for choice in (dict(pair), {**DEFAULT, **dict(pair)}):
        try:
            composed(choice)
            return ""
        except ParameterError as error:
            reason = str(error)
    return reason


def all_pairs() -> list[Pair]:
    return [
        frozenset({(first, a), (second, b)})
        for first, second in combinations(SWEPT, 2)
        for a, b in product(FAMILIES[first], FAMILIES[second])
    ]


def gain(family: str, name: str, choice: Choice, missing: set[Pair]) -> int:
    """Missing pairs that a member would add to a choice; -1 where it is refused."""
    pairs = {frozenset({(family, name), item}) for item in choice.items()}
    return -1 if any(refused(pair) for pair in pairs) else len(pairs & missing)


def covering(given: list[Choice]) -> list[Choice]:
    """The given compositions, and few others for the pairs that they lack (greedily)."""
    held = {frozenset(pair) for choice in given for pair in combinations(choice.items(), 2)}
    missing = {pair for pair in all_pairs() if pair not in held and not refused(pair)}
    found = list(given)
    while missing:
        choice = dict(min(missing, key=sorted))
        for family in sorted(SWEPT, key=lambda f: -len(FAMILIES[f])):
            if family not in choice:
                choice[family] = max(
                    FAMILIES[family], key=lambda n, f=family, c=choice, m=missing: gain(f, n, c, m)
                )
        found.append(choice)
        missing -= {frozenset(pair) for pair in combinations(choice.items(), 2)}
    return found


# Outcomes of ours are written down; members from elsewhere add to them.
OURS: list[Choice] = yaml.safe_load((FOLDER / "compositions.yaml").read_text())
CHOICES = covering(OURS)


def test_what_cannot_be_combined_is_refused_with_a_reason() -> None:
    reasons = {pair: refused(pair) for pair in all_pairs() if refused(pair)}
    for pair, reason in reasons.items():
        named = [name for _, name in pair] + [family for family, _ in pair]
        assert any(word in reason for word in named), (pair, reason)
        assert "\n" not in reason
    single = {name for pair in reasons for family, name in pair}
    # A jump needs a ground and a frame that moves.
    assert {"none", "fixed", "signorini"} <= single
    assert refused(frozenset({("contact", "signorini"), ("friction", "lagged")}))
    assert refused(frozenset({("contact", "signorini"), ("integrator", "bdf2")}))
    assert not refused(frozenset({("contact", "penalty"), ("friction", "lagged")}))
    # Nearly everything goes with everything.
    free = [
        p
        for p in all_pairs()
        if not {"fixed", "none"} & {n for f, n in p if f not in ("damping", "drag")}
    ]
    assert sum(bool(refused(p)) for p in free) < 0.15 * len(free)


@pytest.mark.parametrize("choice", CHOICES, ids=name_of)
def test_every_pair_of_members_jumps(
    choice: Choice, monkeypatch: pytest.MonkeyPatch, golden: Golden
) -> None:
    simulation = composed(choice)
    if choice["integrator"] == "central_difference":
        without_compiling(monkeypatch)
        # Ten thousands of steps are for the compiled program: here its first few hundred.
        batch = simulate_batch([simulation], lanes=1, most_iterations=300.0)
        assert batch.status == ["iteration_limit"]
        assert batch.steps[0] > 100
    else:
        usual = {family: choice[family] for family in ("discretization", "frame")}
        begin_before_the_strike(monkeypatch, composed(usual))
        batch = simulate_batch([simulation], lanes=1)
        check(choice, batch)
    if choice in OURS:
        golden.check(name_of(choice), outcome(batch))


@pytest.mark.slow
@pytest.mark.parametrize("choice", CHOICES, ids=name_of)
def test_every_pair_of_members_jumps_compiled(choice: Choice) -> None:
    simulation = composed(choice)
    other = replace(simulation, design=replace(simulation.design, delta_alpha=0.05))
    batch = simulate_batch([simulation], lanes=8)
    check(choice, batch)
    # What becomes of a robot does not depend on its neighbours.
    both = simulate_batch([simulation, other], lanes=8)
    assert {k: v[:1] for k, v in plain(outcome(both)).items()} == plain(outcome(batch))


def check(choice: Choice, batch: Batch) -> None:
    """A jump like that of the converged model (5.4 by 14.3), as far as so coarse ones are."""
    undamped = composed(choice).integrator.damping_at_infinity == 1.0
    if undamped and choice["stepping"] == "fixed":
        # What these schemes make of contact that the step does not resolve is said by name, or by
        # an estimate of the error.
        percent = batch.y_error_estimate_percent[0]
        if batch.status[0] in UNRESOLVED or percent > 100.0 * APART / HEIGHT:
            return
    assert set(batch.status) == {"ok"}, batch.status
    assert np.all(np.abs(batch.y_bar - HEIGHT) < APART), batch.y_bar
    assert np.all(np.abs(batch.x_bar) < 12.0), batch.x_bar
