"""The simulator that an inverse design is checked by, or found with."""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from snapjump.batch import simulate_designs
from snapjump.checks import ParameterError
from snapjump.composition import Simulation
from snapjump.engine.status import NAMES, OK
from snapjump.scenes.sensitivities import SMALLEST_STICK_ZONE_M_S, check_differentiable
from snapjump.statics.threshold_curve import ThresholdCurve

Array = NDArray[np.float64]
LANES = 8
# Up to so many jumps are sooner done one after the other.
FEW = 2
RESOLVED_STICK_ZONE_M_S = 0.01
EPSILON = 1
# Of thresholds that a curve goes through; fewer serve where the compressions hardly differ.
NODES, FEW_NODES, NARROW = 20, 4, 0.01


class JumpSimulator:
    """Jumps of one composition; satisfies :class:`snapjump.inverse.base.Simulator`.

    An apex is that of :func:`snapjump.simulate_jump` at the same settings, to the last bit.
    ``simulations``: how many there were, those with derivatives too.
    """

    def __init__(self, base: Simulation):
        """Raises ParameterError for a scene that is no jump."""
        if base.scene_name != "jump":
            raise ParameterError("sim", base.scene_name, "jump, which is what targets are of")
        self.base = base
        self.simulations = 0

    def apexes(self, designs: Array) -> Array:
        """Apexes (N, 2) in L of designs (N, 4), NaN unless the status is ok."""
        self.simulations += len(designs)
        lanes = 1 if len(designs) <= FEW else LANES
        batch = simulate_designs(self.base, designs, threads=1, lanes=lanes)
        jumped = np.array(batch.status) == NAMES[OK]
        return np.where(jumped[:, None], np.stack([batch.x_bar, batch.y_bar], axis=1), np.nan)

    def slopes(self, designs: Array) -> Array:
        """Derivatives (N, 2, 4) of the apexes, NaN unless the status is ok.

        A stick zone of friction below 0.005 m/s, which steps jump over, is widened to 0.01 m/s:
        these are then the derivatives of that simulation. Raises ParameterError for modules that
        sensitivities do not know.
        """
        base = differentiable(self.base)
        self.simulations += len(designs)
        low, high = designs[:, EPSILON].min(), designs[:, EPSILON].max()
        nodes = FEW_NODES if high - low <= NARROW * high else NODES
        margin = 1.0 + NARROW
        curve = ThresholdCurve.through(
            base.robot, base.discretization, low / margin, min(high * margin, 0.4), nodes
        )
        lanes = 1 if len(designs) <= FEW else LANES
        batch = simulate_designs(
            base, designs, curve=curve, threads=1, lanes=lanes, sensitivities=True
        )
        assert batch.sensitivities is not None
        found = np.stack([batch.sensitivities.dx_bar, batch.sensitivities.dy_bar], axis=1)
        jumped = np.array(batch.status) == NAMES[OK]
        return np.where(jumped[:, None, None], found, np.nan)


def differentiable(base: Simulation) -> Simulation:
    """The simulation, with a stick zone that its steps resolve. Raises ParameterError."""
    threshold = getattr(base.friction, "velocity_threshold_m_s", SMALLEST_STICK_ZONE_M_S)
    if threshold < SMALLEST_STICK_ZONE_M_S:
        wider = replace(base.friction, velocity_threshold_m_s=RESOLVED_STICK_ZONE_M_S)
        base = replace(base, friction=wider)
    check_differentiable(base)
    return base
