"""What Hydra composes of the configurations in ``conf``, as a task is given it."""

from typing import Any

from command_line import ROOT
from hydra import compose, initialize_config_dir
from omegaconf import OmegaConf

from snapjump.declare.fields import construct
from snapjump.robot.other_units import in_own_units
from snapjump.robot.robot import Robot
from snapjump.run.tasks.names import key_of, register_resolvers

CONF = ROOT / "conf"


def composed(*overrides: str, **options: Any) -> Any:
    register_resolvers()
    with initialize_config_dir(str(CONF), version_base="1.3"):
        return compose("config", list(overrides), **options)


def hydra_config(*overrides: str) -> Any:
    """What a task is given of what Hydra composes: plain values, in their own units."""
    config: Any = OmegaConf.to_container(composed(*overrides), resolve=True)
    robot = construct("robot", Robot, config["robot"])
    return in_own_units(config, [*map(key_of, overrides)], robot)
