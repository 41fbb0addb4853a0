"""Configurations and the library tell the same story; every member composes and builds, and the
same words give the same simulation from Python and from the command line."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
import yaml
from families import EVERY, OTHERS, of_all_families, of_simulations, pairs
from hydra_config import CONF, composed, hydra_config

from snapjump import Design, Environment, Robot
from snapjump.checks import ParameterError
from snapjump.composition import Simulation, with_tier
from snapjump.declare.fields import settings
from snapjump.declare.members import files_of, make_member, member_class, member_names
from snapjump.run.tasks.registry import TASKS
from snapjump.show.terminal.help_page import TABLEAUX, describe
from snapjump.simulation import build
from snapjump.stepping.adaptive import AdaptiveStep
from snapjump.tiers import TIERS

FOLDERS = (CONF, TABLEAUX)
# Members that a jump cannot have.
NEEDS = {
    ("integrator", "central_difference"): ("damping=none",),
    ("contact", "signorini"): ("integrator=implicit_euler",),
    ("drive", "table"): ("drive.rows=[[0,0,-0.1],[0.01,0.2,0.1],[0.1,1.5,1.4]]",),
}
SCENE_OF = {("frame", "fixed"): "snap", ("contact", "none"): "snap"}
SCENE_OF |= {("drive", "unload"): "snap", ("drive", "hold_release"): "snap"}


def files(group: str) -> set[str]:
    return {path.stem for folder in FOLDERS for path in (folder / group).glob("*.yaml")}


def file(group: str, name: str) -> Path:
    return next(f for folder in FOLDERS if (f := folder / group / f"{name}.yaml").exists())


def section(group: str, name: str) -> dict[str, Any]:
    content = yaml.safe_load(file(group, name).read_text())
    return content.get(group, content)


def defaults(cls: Any) -> dict[str, Any]:
    """Field names and their defaults."""
    part = cls()
    return {key: getattr(part, key) for key in settings(part)}


@pytest.mark.parametrize("family", EVERY)
def test_every_member_has_its_file_and_every_file_its_member(family):
    assert files(family) == set(EVERY[family])


def test_groups_that_are_no_family_of_the_library():
    assert files("task") == set(TASKS)
    assert files("tracking") == set(member_names("tracking"))
    assert files("accuracy") == set(TIERS)
    others = {"task", "tracking", "accuracy", "robot", "experiment", "cluster"}
    assert {path.name for path in CONF.iterdir() if path.is_dir()} == set(EVERY) | others


@of_all_families
def test_a_file_has_the_fields_and_defaults_of_its_member(family, name):
    expected = defaults(EVERY[family][name])
    values = section(family, name)
    assert values.pop("name") == name
    assert list(values) == list(expected)
    for key, value in values.items():
        if not str(value).startswith("${"):
            assert plain(value) == plain(expected[key]), key


def plain(value: Any) -> Any:
    """A value in which tuples are lists."""
    return [plain(v) for v in value] if isinstance(value, (list, tuple)) else value


@of_all_families
def test_a_file_says_what_its_member_says(family, name):
    if files_of(family)[name].suffix == ".py":
        documented = (EVERY[family][name].__doc__ or "").strip().splitlines()[0]
        assert describe(file(family, name)) == documented


@pytest.mark.parametrize("cls", [Robot, Design, Environment])
def test_parameters_have_the_library_s_defaults(cls):
    assert hydra_config()[cls.__name__.lower()] == defaults(cls)


@pytest.mark.parametrize("name", TIERS)
def test_a_tier_is_the_library_s(name):
    values, tier = section("accuracy", name), TIERS[name]
    numbers = {path.partition(".")[2]: value for path, value in tier.numbers.items()}
    assert values == {"name": name, **numbers, "known_error": tier.known_error}
    config = hydra_config(f"accuracy={name}")
    assert {family: config[family]["name"] for family in tier.members} == tier.members


@pytest.mark.parametrize(
    "path",
    sorted(p for folder in FOLDERS for p in folder.glob("*/*.yaml")),
    ids=lambda p: f"{p.parent.name}-{p.stem}",
)
def test_every_key_has_its_unit_or_range_in_a_comment(path):
    assert describe(path).endswith(".")
    for line in path.read_text().splitlines():
        key = line.strip().partition(":")[0]
        if ":" in line and not line.strip().startswith(("#", "-")) and line.strip()[-1] != ":":
            assert key in ("name", "known_error") or "#" in line, line


@of_simulations
def test_every_member_can_be_chosen(family, name):
    scene = () if family == "sim" else (f"sim={SCENE_OF.get((family, name), 'jump')}",)
    config = hydra_config(*scene, *NEEDS.get((family, name), ()), f"{family}={name}")
    assert config[family]["name"] == name
    assert build(config) is not None


@pytest.mark.parametrize(("family", "name"), pairs(OTHERS))
def test_every_member_of_another_family_can_be_chosen(family, name):
    of_datasets, composed_already = family in ("plan", "executor"), family == "uncertainty"
    choice = (f"{family}={name}",) if of_datasets or composed_already else (f"+{family}={name}",)
    choice = ("task=dataset", *choice) if of_datasets else choice
    config = hydra_config(*choice)
    assert make_member(family, config[family]) == EVERY[family][name]()


def test_a_dataset_has_lanes_unless_told_otherwise():
    assert hydra_config("task=dataset")["backend"]["name"] == "lanes"
    assert hydra_config("task=dataset", "backend=scalar")["backend"]["name"] == "scalar"
    assert hydra_config()["backend"]["name"] == "scalar"


def test_the_seed_of_a_run_is_that_of_its_plan():
    assert hydra_config("task=dataset", "plan=sobol", "seed=5")["plan"]["seed"] == 5


def test_a_slurm_sweep_composes_with_its_launcher():
    pytest.importorskip("hydra_plugins.hydra_submitit_launcher", reason="needs snapjump[cluster]")
    config = composed("task=dataset", "+cluster=slurm", return_hydra_config=True)
    launcher = config.hydra.launcher
    assert launcher._target_.endswith(".SlurmLauncher")
    given = yaml.safe_load(file("cluster", "slurm").read_text())["hydra"]["launcher"]
    assert {key: launcher[key] for key in given} == given


def test_the_command_line_wins_over_scene_and_tier():
    chosen = ("damping=mass_proportional", "friction=lagged", "integrator=sdirk2")
    config = hydra_config("sim=bounce", "accuracy=paper", *chosen, "stepping.step_s=2e-6")
    assert config["damping"]["name"] == "mass_proportional"
    assert config["friction"]["name"] == "lagged"
    assert config["integrator"]["name"] == "sdirk2"
    assert config["stepping"] == {"name": "fixed", "step_s": 2e-6}
    assert config["frame"]["name"] == "fixed"
    assert config["discretization"]["clamp"] == "two_nodes"


def test_a_key_wins_over_its_tier():
    config = hydra_config("accuracy=draft", "discretization.elements=64")
    assert config["discretization"]["elements"] == 64


def by_command_line(*words: str) -> Simulation:
    return build(hydra_config(*words))


def refused_or(compose: Callable[..., Simulation], *words: str, **members: str) -> Any:
    """The simulation, or the line that refuses it."""
    try:
        return compose(*words, **members)
    except ParameterError as error:
        return str(error)


@pytest.mark.parametrize("tier", TIERS)
@of_simulations
def test_a_member_at_a_tier(family, name, tier):
    """Python and the command line give the same; every scene can be had at every tier."""
    found = refused_or(by_command_line, f"accuracy={tier}", f"{family}={name}")
    assert found == refused_or(with_tier, tier, **{family: name})
    assert family != "sim" or isinstance(found, Simulation)


@of_simulations
def test_a_word_is_the_member_left_to_its_defaults(family, name):
    """Both have the tier's values where it has some."""
    try:
        by_word: Any = with_tier("draft", **{family: name})
    except ParameterError as error:
        with pytest.raises(ParameterError, match="^" + error.key.replace(".", r"\.")):
            with_tier("draft", **{family: member_class(family, name)()})
    else:
        assert by_word == with_tier("draft", **{family: member_class(family, name)()})


def test_what_is_given_wins_over_the_tier():
    own = AdaptiveStep(tolerance=AdaptiveStep().tolerance)
    assert with_tier("reference", stepping=own).stepping.tolerance == own.tolerance
    assert with_tier("reference", stepping=own).stepping.contact_steps == 1.0
    assert with_tier("reference", stepping=AdaptiveStep()).stepping.tolerance == 4e-8
    changed = AdaptiveStep().changed(contact_steps=0.5)
    assert with_tier("reference", stepping=changed).stepping == AdaptiveStep(4e-8, 0.5, 2.0)


def test_a_scene_chooses_what_goes_with_it():
    assert with_tier("paper", sim="snap") == by_command_line("sim=snap", "accuracy=paper")
    kept = with_tier("standard", sim="slide", damping="kelvin_voigt")
    assert (kept.friction.name, kept.damping.name) == ("implicit", "kelvin_voigt")
