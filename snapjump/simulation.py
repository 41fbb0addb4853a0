"""From a plain configuration to a result: the library's front door."""

from collections.abc import Mapping
from typing import Any

from snapjump.checks import check_choice, check_group
from snapjump.composition import PLAIN, Simulation, with_tier
from snapjump.declare.families import FAMILIES
from snapjump.declare.former_options import with_present_options
from snapjump.declare.scenes import Progress
from snapjump.results import Result
from snapjump.robot.design import Design
from snapjump.robot.environment import Environment
from snapjump.robot.robot import Robot
from snapjump.tiers import TIERS


def build(config: Mapping[str, Any]) -> Simulation:
    """A checked simulation from nested groups, as Hydra composes them.

    Each family's group has a ``name`` and that member's fields; ``robot``, ``design`` and
    ``environment`` have fields only; ``accuracy.name`` is the tier. An integrator that is not
    known but has ``rows`` is a Runge-Kutta method of that tableau. Raises ParameterError.
    """
    check_group("configuration", config)
    config = with_present_options(config)
    for group in (*PLAIN, *FAMILIES, "accuracy"):
        check_group(group, config.get(group) or {})
    parts: Any = {group: config[group] for group in (*PLAIN, *FAMILIES) if config.get(group)}
    accuracy = (config.get("accuracy") or {}).get("name", "standard")
    check_choice("accuracy.name", accuracy, tuple(TIERS))
    return Simulation(**parts, accuracy=accuracy)


def simulate(simulation: Simulation, progress: Progress | None = None) -> Result:
    """Run a simulation's scene. ``progress`` is called with a share in [0, 1] and a word."""
    result: Result = simulation.sim.simulate(simulation, progress)
    return result


def simulate_jump(
    robot: Robot | None = None,
    design: Design | None = None,
    environment: Environment | None = None,
    accuracy: str = "standard",
    **parts: Any,
) -> Result:
    """Simulate one jump at an accuracy tier.

    ``parts`` replace the tier's modules (``integrator=...``, ``contact="penalty"``, see
    :class:`snapjump.composition.Simulation`). Raises ParameterError for values out of range.
    """
    simulation = with_tier(
        accuracy,
        robot=robot or Robot(),
        design=design or Design(),
        environment=environment or Environment(),
        **parts,
    )
    return simulate(simulation)
