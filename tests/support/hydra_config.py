"""What Hydra composes of the configurations in ``conf``, as a task is given it."""

from typing import Any

from command_line import ROOT
from hydra import compose, initialize_config_dir
from omegaconf import OmegaConf

from snapjump.run.tasks.names import register_resolvers

CONF = ROOT / "conf"


def composed(*overrides: str, **options: Any) -> Any:
    register_resolvers()
    with initialize_config_dir(str(CONF), version_base="1.3"):
        return compose("config", list(overrides), **options)


def hydra_config(*overrides: str) -> Any:
    """What Hydra composes, as plain values."""
    return OmegaConf.to_container(composed(*overrides), resolve=True)
