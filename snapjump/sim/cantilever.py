"""Verification: the cantilever under a dead force across its tip, against elliptic integrals."""

import time
from dataclasses import dataclass
from typing import Any

import numpy as np

from snapjump.composition import Simulation
from snapjump.declare.fields import number
from snapjump.declare.outputs import INTEGER, output
from snapjump.drive.base import ClampAngles
from snapjump.drive.constant_rate import ConstantRate
from snapjump.engine.equilibrate import equilibrate
from snapjump.engine.load.tip import TipLoad
from snapjump.engine.model import Model, numbers_of
from snapjump.engine.work import make_memory, sizes_of
from snapjump.frame.base import NO_MESH, STILL
from snapjump.frame.parts.cantilever import CantileverFrame
from snapjump.results import Result
from snapjump.scenes.march_outputs import RunOutputs
from snapjump.sim.base import AT_REST, NEEDS_NO_GROUND, Progress, SceneOptions

LOAD_STEP = 0.25  # EI/L^2 and EI/L


def bend_cantilever(
    rod: Any, elements: int, force_x: float, force_y: float, moment: float
) -> tuple[np.ndarray, float, int]:
    """Nodes (N + 1, 2) in L, elastic energy (EI/L) and negative pivots under a tip load.
    Force in EI/L^2, moment in EI/L. Raises ArithmeticError where Newton's method fails."""
    clamp, load = ConstantRate.Law(0.0, 1.0, 1.0, 0.0), TipLoad(0.0, 0.0, 0.0)
    model = Model(rod, CantileverFrame(), clamp, load=load)
    dofs = rod.node_dofs()
    memory = make_memory(sizes_of(model, elements + 1))
    memory.state[0::dofs, 0] = np.linspace(0.0, 1.0, elements + 1)
    masses = np.zeros(elements + 1)
    steps = max(1, int(np.ceil(max(abs(force_x), abs(force_y), abs(moment)) / LOAD_STEP)))
    negative = 0.0
    for k in range(1, steps + 1):
        load = TipLoad(*(value * k / steps for value in (force_x, force_y, moment)))
        loaded = model._replace(load=load)
        negative, _, failed = equilibrate(loaded, numbers_of(loaded), masses, memory, True)
        if failed:
            raise ArithmeticError(f"no equilibrium at {k} / {steps} of the tip load")
    state = memory.state[:, 0].copy()
    flat = ClampAngles(0.0, 0.0, 0.0, 0.0)
    tangents = CantileverFrame().end_tangents(NO_MESH, load, flat, state, STILL)
    energy = float(rod.internal_energy(state, tangents))
    return state.reshape(-1, dofs)[:, :2], energy, int(negative)


@dataclass(frozen=True)
class CantileverOutputs(RunOutputs):
    """Outputs of a bent cantilever; see :func:`bend_cantilever`."""

    nodes: np.ndarray
    energy: float
    negative: int

    @output("rad")
    def tip_angle_rad(self) -> float:
        """Angle of the last element at the tip."""
        ahead = self.nodes[-1] - self.nodes[-2]
        return float(np.arctan2(ahead[1], ahead[0]))

    @output("L")
    def tip_x_bar(self) -> float:
        """Distance of the tip from the clamp, along the undeformed beam."""
        return float(self.nodes[-1, 0])

    @output("L")
    def deflection_bar(self) -> float:
        """Distance of the tip from the undeformed beam."""
        return float(self.nodes[-1, 1])

    @output("EI/L")
    def energy_bar(self) -> float:
        """Elastic energy."""
        return self.energy

    @output("1", kind=INTEGER)
    def negative_pivots(self) -> int:
        """Negative eigenvalues of the tangent stiffness: none of a stable equilibrium."""
        return self.negative


class Cantilever(SceneOptions):
    """Verification: a cantilever bent by a force (in EI/L^2) across its tip."""

    chooses = AT_REST
    outputs = CantileverOutputs
    needs = NEEDS_NO_GROUND

    load_bar: float = number(1.0, least=-20.0, most=20.0, unit="EI/L^2")

    def simulate(self, simulation: Simulation, progress: Progress | None = None) -> Result:
        begun = time.perf_counter()
        elements = simulation.discretization.moving_elements
        rod = simulation.discretization.beam(simulation.robot)
        load = simulation.sim.load_bar
        bent = bend_cantilever(rod, elements, 0.0, load, 0.0)
        arrays: dict[str, Any] = {
            "shapes_x_bar": bent[0][None, :, 0],
            "shapes_y_bar": bent[0][None, :, 1],
            "shapes_label": np.array([f"tip force {load:g} EI/L^2"]),
        }
        return CantileverOutputs(simulation, begun, *bent).result(arrays)
