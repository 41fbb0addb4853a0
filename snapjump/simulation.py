"""From a plain configuration to a result: the library's front door."""

from collections.abc import Callable, Mapping
from dataclasses import fields
from typing import Any

from snapjump.accuracy import TIERS
from snapjump.checks import ParameterError, check_choice, check_group
from snapjump.composition import Simulation, with_tier
from snapjump.families import FAMILIES
from snapjump.options.runge_kutta import dirk_member
from snapjump.parameters.design import Design
from snapjump.parameters.environment import Environment
from snapjump.parameters.robot import Robot
from snapjump.results import Result
from snapjump.scenes.card_march import check_backend
from snapjump.scenes.jump import simulate_jump_scene
from snapjump.scenes.jump_start import jump_model
from snapjump.scenes.registry import SCENES

Progress = Callable[[float, str], None]
PLAIN = {"robot": Robot, "design": Design, "environment": Environment}


def construct(group: str, cls: type, values: Mapping[str, Any]) -> Any:
    """An option object from a group's values. Raises ParameterError for an unknown key."""
    known = [f.name for f in fields(cls)]
    for key, value in values.items():
        if key not in known:
            allowed = ", ".join(known) or "no keys at all"
            raise ParameterError(f"{group}.{key}", value, f"{group} has {allowed}")
    return cls(**values)


def build(config: Mapping[str, Any]) -> Simulation:
    """A checked simulation from nested groups, as Hydra composes them.

    Each family's group has a ``name`` and that member's fields; ``robot``, ``design`` and
    ``environment`` have fields only; ``accuracy.name`` is the tier. An integrator that is not
    known but has ``rows`` is a Runge-Kutta method of that tableau. Raises ParameterError.
    """
    check_group("configuration", config)
    for group in (*PLAIN, *FAMILIES, "accuracy"):
        check_group(group, config.get(group) or {})
    parts: dict[str, Any] = {}
    for group, cls in PLAIN.items():
        parts[group] = construct(group, cls, config.get(group) or {})
    for family, members in FAMILIES.items():
        values = dict(config.get(family) or {})
        if not values:
            continue
        name = values.pop("name", None)
        if family == "integrator" and "rows" in values and is_new_name(name, members):
            members[name] = dirk_member(name, "", values)
        check_choice(family, name, tuple(members))
        parts[family] = construct(family, members[name], values)
    accuracy = config.get("accuracy") or {}
    parts["accuracy"] = accuracy.get("name", "standard")
    return Simulation(**parts)


def is_new_name(name: Any, members: Mapping[str, Any]) -> bool:
    """Whether a name could be that of another member."""
    return isinstance(name, str) and name.isidentifier() and name not in members


def check_scene(simulation: Simulation) -> None:
    """What only the machine and the robot's statics tell. Raises ParameterError if the scene cannot
    begin."""
    check_backend(simulation)
    if simulation.scene_name == "jump":
        jump_model(simulation)


def simulate(simulation: Simulation, progress: Progress | None = None) -> Result:
    """Run a simulation's scene. ``progress`` is called with a share in [0, 1] and a word."""
    return SCENES[simulation.scene_name](simulation, progress)


def simulate_jump(
    robot: Robot | None = None,
    design: Design | None = None,
    environment: Environment | None = None,
    accuracy: str = "standard",
    **parts: Any,
) -> Result:
    """Simulate one jump at an accuracy tier.

    ``parts`` replace the tier's modules (``integrator=...``, ``contact=...``, see
    :data:`snapjump.families.FAMILIES`). Raises ParameterError for values out of range.
    """
    check_choice("accuracy", accuracy, tuple(TIERS))
    simulation = with_tier(
        accuracy,
        robot=robot or Robot(),
        design=design or Design(),
        environment=environment or Environment(),
        **parts,
    )
    return simulate_jump_scene(simulation)
