"""Snapjump: simulation and design of snap-actuated jumping robots.

    from snapjump import Design, Environment, simulate_jump
    jump = simulate_jump(design=Design(epsilon=0.2), environment=Environment(mu=0.3))
    print(jump)        # apex, lift-off, accuracy, cost
    jump.plot()        # in a notebook; .film() too, .to_frame(), .arrays

One jump: :func:`simulate_jump`; many: :func:`simulate_designs`; other scenes and modules:
:func:`build` and :func:`simulate`; how far off a jump may be: :func:`model_uncertainty`. Datasets:
:func:`load_dataset`; learned apexes: :func:`forward_model`; the design that reaches a target:
:func:`inverse_design`. Members of one's own: :func:`load_plugins`. Names are loaded when they are
first used, so that importing the package costs nothing.
"""

import os
from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from snapjump.batch import Batch as Batch
    from snapjump.batch import simulate_designs as simulate_designs
    from snapjump.checks import ParameterError as ParameterError
    from snapjump.composition import Simulation as Simulation
    from snapjump.dataset.read import load_dataset as load_dataset
    from snapjump.declare.plugins import load_plugins as load_plugins
    from snapjump.learning.forward_model import forward_model as forward_model
    from snapjump.results import JumpResult as JumpResult
    from snapjump.results import Result as Result
    from snapjump.robot.design import Design as Design
    from snapjump.robot.environment import Environment as Environment
    from snapjump.robot.robot import Robot as Robot
    from snapjump.simulation import build as build
    from snapjump.simulation import simulate as simulate
    from snapjump.simulation import simulate_jump as simulate_jump
    from snapjump.targets.design import inverse_design as inverse_design
    from snapjump.uncertainty.parts.simulated import model_uncertainty as model_uncertainty

__version__ = "0.1.0"
# numba reads it when it is imported: a tenth of the time of compiling goes into colours of messages
# that nobody sees.
os.environ.setdefault("NUMBA_DISABLE_ERROR_MESSAGE_HIGHLIGHTING", "1")
_HOMES = {
    "simulate_jump": "snapjump.simulation",
    "simulate_designs": "snapjump.batch",
    "build": "snapjump.simulation",
    "simulate": "snapjump.simulation",
    "load_dataset": "snapjump.dataset.read",
    "forward_model": "snapjump.learning.forward_model",
    "inverse_design": "snapjump.targets.design",
    "model_uncertainty": "snapjump.uncertainty.parts.simulated",
    "load_plugins": "snapjump.declare.plugins",
    "Robot": "snapjump.robot.robot",
    "Design": "snapjump.robot.design",
    "Environment": "snapjump.robot.environment",
    "Simulation": "snapjump.composition",
    "Result": "snapjump.results",
    "JumpResult": "snapjump.results",
    "Batch": "snapjump.batch",
    "ParameterError": "snapjump.checks",
}

__all__ = [*_HOMES]


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        raise AttributeError(f"module 'snapjump' has no attribute {name!r}")
    from snapjump.files.extras import extras_named

    with extras_named():
        return getattr(import_module(_HOMES[name]), name)


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
