"""The simulator that an inverse design is checked by, or found with."""

from dataclasses import replace

import numpy as np

from snapjump.arrays import Array
from snapjump.batch import simulate_designs
from snapjump.checks import ParameterError
from snapjump.composition import Simulation, with_tier
from snapjump.declare.inputs import DEFAULT_INPUTS, PARTS
from snapjump.scenes.sensitivities import SMALLEST_STICK_ZONE, check_differentiable, stick_zone
from snapjump.statics.threshold_curve import ThresholdCurve
from snapjump.stepping.adaptive import AdaptiveStep

LANES = 8  # even for one jump, which takes a third longer so: every width is compiled anew
RESOLVED_STICK_ZONE = 2.19089e-3  # L/T: 0.01 m/s for the default robot
SLOPES_SHARE = 0.1  # of the tolerance: a derivative is also that of the errors of its steps
EPSILON = DEFAULT_INPUTS.index("design.epsilon")
# Of thresholds that a curve goes through; fewer serve where the compressions hardly differ.
NODES, FEW_NODES, NARROW = 20, 4, 0.01


class JumpSimulator:
    """Jumps of one composition; satisfies :class:`snapjump.inverse.base.Simulator`.

    An apex is that of :func:`snapjump.simulate_jump` at the same settings, to the last bit.
    ``simulations``: how many there were, those with derivatives and those at other tiers too.
    """

    def __init__(self, base: Simulation):
        """Raises ParameterError for a scene that is no jump."""
        if base.sim.name != "jump":
            raise ParameterError("sim", base.sim.name, "jump, which is what targets are of")
        self.base = base
        self._own = 0
        self._tiers: dict[str, JumpSimulator] = {}

    @property
    def simulations(self) -> int:
        return self._own + sum(other.simulations for other in self._tiers.values())

    def at(self, tier: str) -> "JumpSimulator":
        """The same physical model at another accuracy tier; the same object every time."""
        if tier not in self._tiers:
            self._tiers[tier] = JumpSimulator(at_tier(self.base, tier))
        return self._tiers[tier]

    def apexes(self, designs: Array) -> Array:
        """Apexes (N, 2) in L of designs (N, 4), NaN unless the status is ok."""
        self._own += len(designs)
        return simulate_designs(self.base, designs, threads=1, lanes=LANES).apexes

    def slopes(self, designs: Array) -> Array:
        """Derivatives (N, 2, 4) of the apexes, NaN unless the status is ok.

        A stick zone of friction that steps jump over, below 0.005 m/s of the default robot, is
        widened to twice that: these are then the derivatives of that simulation. Raises
        ParameterError for modules that sensitivities do not know.
        """
        base = differentiable(self.base)
        self._own += len(designs)
        low, high = designs[:, EPSILON].min(), designs[:, EPSILON].max()
        nodes = FEW_NODES if high - low <= NARROW * high else NODES
        margin = 1.0 + NARROW
        curve = ThresholdCurve.through(
            base.robot, base.discretization, low / margin, min(high * margin, 0.4), nodes
        )
        batch = simulate_designs(
            base, designs, curve=curve, threads=1, lanes=LANES, sensitivities=True
        )
        assert batch.sensitivities is not None
        found = np.stack([batch.sensitivities.dx_bar, batch.sensitivities.dy_bar], axis=1)
        return np.where(np.isfinite(batch.apexes)[:, :, None], found, np.nan)


def at_tier(base: Simulation, tier: str) -> Simulation:
    """The physical model of a simulation, computed where it is, with the mesh, integrator and steps
    of a tier."""
    return with_tier(tier, **{part: getattr(base, part) for part in (*PARTS, "backend")})


def differentiable(base: Simulation) -> Simulation:
    """The simulation, with a stick zone that its steps resolve, and steps whose own errors hardly
    move with a design. Raises ParameterError."""
    if stick_zone(base) < SMALLEST_STICK_ZONE:
        wide_m_s = RESOLVED_STICK_ZONE * base.robot.scales.velocity_m_s
        base = replace(base, friction=base.friction.changed(velocity_threshold_m_s=wide_m_s))
    if isinstance(base.stepping, AdaptiveStep):
        finer = SLOPES_SHARE * base.stepping.tolerance
        base = replace(base, stepping=base.stepping.changed(tolerance=finer))
    check_differentiable(base)
    return base
