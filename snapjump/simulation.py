"""From a plain configuration to a result: the library's front door."""

import warnings
from collections.abc import Mapping
from difflib import get_close_matches
from typing import Any

from snapjump.checks import ParameterError, check_choice, check_group
from snapjump.composition import PLAIN, Simulation, with_tier
from snapjump.declare.families import FAMILIES
from snapjump.declare.former_options import with_present_options
from snapjump.declare.inputs import unusual
from snapjump.declare.scenes import Progress
from snapjump.results import JumpResult, Result
from snapjump.robot.design import Design
from snapjump.robot.environment import Environment
from snapjump.robot.robot import Robot
from snapjump.tiers import TIERS, check_tier_keys

GROUPS = (*PLAIN, *FAMILIES, "accuracy")
# Of a whole configuration, what is about the run.
OF_SOME_TASKS = (
    *("dataset", "plan", "executor", "surrogate", "training", "checkpoint"),
    *("inverse", "target", "tolerance", "figure", "uncertainty"),
)
OF_RUNS = (
    *("task", "tracking", "figures", "seed", "effort", "publish", "plugins", "objective"),
    *OF_SOME_TASKS,
)


def build(config: Mapping[str, Any]) -> Simulation:
    """A checked simulation from nested groups, as Hydra composes them.

    Each family's group has a ``name`` and that member's fields, or is the name alone; ``robot``,
    ``design`` and ``environment`` have fields only; ``accuracy.name`` is the tier. An integrator
    that is not known but has ``rows`` is a Runge-Kutta method of that tableau. Keys of a whole
    configuration that are about its run are passed over. Raises ParameterError.
    """
    check_group("configuration", config)
    config = with_present_options(config)
    for key, value in config.items():
        if key not in (*GROUPS, *OF_RUNS):
            near = get_close_matches(str(key), GROUPS, n=1)
            hint = f"did you mean {near[0]}? " if near else ""
            raise ParameterError(str(key), value, f"{hint}one of {', '.join(GROUPS)}")
    parts: Any = {key: config[key] for key in GROUPS if config.get(key) is not None}
    accuracy = parts.pop("accuracy", {"name": "standard"})
    check_tier_keys(accuracy)
    if "name" not in accuracy:
        raise ParameterError("accuracy", dict(accuracy), "a group with the name of a tier")
    check_choice("accuracy.name", accuracy["name"], tuple(TIERS))
    return Simulation(**parts, accuracy=accuracy["name"])


def simulate(simulation: Simulation, progress: Progress | None = None) -> Result:
    """Run a simulation's scene. ``progress`` is called with a share in [0, 1] and a word."""
    result: Result = simulation.sim.simulate(simulation, progress)
    return result


def simulate_jump(
    robot: Robot | Mapping[str, Any] | None = None,
    design: Design | Mapping[str, Any] | None = None,
    environment: Environment | Mapping[str, Any] | None = None,
    accuracy: str = "standard",
    **parts: Any,
) -> JumpResult:
    """Simulate one jump at an accuracy tier.

    ``parts`` replace the tier's modules (``integrator=...``, ``contact="penalty"``, see
    :class:`snapjump.composition.Simulation`). Groups of numbers do as well, in their own units or
    those of the workbench: ``design={"delta_alpha_deg": 5}``, ``environment={"mass_g": 4}``.
    Raises ParameterError for values out of range.
    """
    simulation = with_tier(
        accuracy,
        robot=robot or Robot(),
        design=design or Design(),
        environment=environment or Environment(),
        **parts,
    )
    for line in unusual(simulation):
        warnings.warn(line, stacklevel=2)
    result = simulate(simulation)
    if not isinstance(result, JumpResult):
        raise ParameterError("sim", simulation.sim.name, "jump; simulate() has the other scenes")
    return result
