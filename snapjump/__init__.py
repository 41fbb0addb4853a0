"""Snapjump: simulation and design of snap-actuated jumping robots.

from snapjump import Design, Robot, simulate_jump
jump = simulate_jump(Robot(), Design(epsilon=0.2, delta_alpha=0.1))
print(jump.x_bar, jump.y_bar)
"""

from snapjump.checks import ParameterError
from snapjump.parameters.design import Design
from snapjump.parameters.environment import Environment
from snapjump.parameters.robot import Robot
from snapjump.results import Result
from snapjump.simulation import simulate_jump

__all__ = ["Design", "Environment", "ParameterError", "Result", "Robot", "simulate_jump"]
