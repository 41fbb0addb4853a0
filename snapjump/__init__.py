"""Snapjump: simulation and design of snap-actuated jumping robots.

    from snapjump import Design, Robot, simulate_jump
    jump = simulate_jump(Robot(), Design(epsilon=0.2, delta_alpha=0.1))
    print(jump.x_bar, jump.y_bar)

Names are loaded when they are first used, so that importing the package costs nothing.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from snapjump.checks import ParameterError as ParameterError
    from snapjump.declare.plugins import load_plugins as load_plugins
    from snapjump.results import Result as Result
    from snapjump.robot.design import Design as Design
    from snapjump.robot.environment import Environment as Environment
    from snapjump.robot.robot import Robot as Robot
    from snapjump.simulation import simulate_jump as simulate_jump

__version__ = "0.1.0"
_HOMES = {
    "Design": "snapjump.robot.design",
    "Environment": "snapjump.robot.environment",
    "ParameterError": "snapjump.checks",
    "Result": "snapjump.results",
    "Robot": "snapjump.robot.robot",
    "load_plugins": "snapjump.declare.plugins",
    "simulate_jump": "snapjump.simulation",
}

__all__ = [*_HOMES]


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        raise AttributeError(f"module 'snapjump' has no attribute {name!r}")
    return getattr(import_module(_HOMES[name]), name)
