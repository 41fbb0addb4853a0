"""Whatever happens once: kernels compiled and loaded, networks asked for the first time."""

import numpy as np

from snapjump.checks import ParameterError
from snapjump.composition import Simulation
from snapjump.inverse.base import ForwardModel, InverseMethod
from snapjump.targets.simulator import LANES, JumpSimulator


def warm_up(base: Simulation, forward: ForwardModel, method: InverseMethod) -> None:
    """Do it before a search is timed; what the method does not ask is left alone."""
    middle = np.mean(forward.ranges, axis=1)[None, :]
    forward.predict(middle)
    forward.jacobian(middle)
    if method.needs_forward:
        return
    simulator = JumpSimulator(base)
    simulator.apexes(middle)
    simulator.apexes(np.repeat(middle, LANES, axis=0))
    try:
        simulator.slopes(middle)
    except ParameterError:  # modules that sensitivities do not know
        pass
