"""The same words give the same simulation from Python and from the command line."""

from pathlib import Path
from typing import Any

import pytest
from families import FAMILIES
from hydra import compose, initialize_config_dir
from omegaconf import OmegaConf

from snapjump.checks import ParameterError
from snapjump.composition import Simulation, with_tier
from snapjump.declare.members import member_class
from snapjump.run.tasks.names import register_resolvers
from snapjump.simulation import build
from snapjump.stepping.adaptive import AdaptiveStep
from snapjump.tiers import TIERS

CONF = Path(__file__).resolve().parents[1] / "conf"
MEMBERS = [(family, name) for family, members in FAMILIES.items() for name in members]


def by_command_line(*words: str) -> Simulation:
    register_resolvers()
    with initialize_config_dir(str(CONF), version_base="1.3"):
        config: Any = OmegaConf.to_container(compose("config", list(words)), resolve=True)
    return build(config)


@pytest.mark.parametrize("tier", TIERS)
@pytest.mark.parametrize(("family", "name"), MEMBERS)
def test_a_member_at_a_tier(family: str, name: str, tier: str) -> None:
    try:
        expected: Any = with_tier(tier, **{family: name})
    except ParameterError as error:
        expected = str(error)
    try:
        found: Any = by_command_line(f"accuracy={tier}", f"{family}={name}")
    except ParameterError as error:
        found = str(error)
    assert found == expected


@pytest.mark.parametrize(("family", "name"), MEMBERS)
def test_a_word_is_the_member_left_to_its_defaults(family: str, name: str) -> None:
    """At the tier's values where it has some, as the object without a value is, too."""
    try:
        by_word: Any = with_tier("draft", **{family: name})
    except ParameterError as error:
        with pytest.raises(ParameterError, match="^" + error.key.replace(".", r"\.")):
            with_tier("draft", **{family: member_class(family, name)()})
    else:
        assert by_word == with_tier("draft", **{family: member_class(family, name)()})


def test_what_is_given_wins_over_the_tier() -> None:
    own = AdaptiveStep(tolerance=AdaptiveStep().tolerance)
    assert with_tier("reference", stepping=own).stepping.tolerance == own.tolerance
    assert with_tier("reference", stepping=own).stepping.contact_steps == 1.0
    assert with_tier("reference", stepping=AdaptiveStep()).stepping.tolerance == 2e-9
    changed = AdaptiveStep().changed(contact_steps=0.5)
    assert with_tier("reference", stepping=changed).stepping == AdaptiveStep(2e-9, 0.5)


def test_a_scene_chooses_what_goes_with_it() -> None:
    assert with_tier("paper", sim="snap") == by_command_line("sim=snap", "accuracy=paper")
    kept = with_tier("standard", sim="slide", damping="kelvin_voigt")
    assert (kept.friction.name, kept.damping.name) == ("implicit", "kelvin_voigt")
