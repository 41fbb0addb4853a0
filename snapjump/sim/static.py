"""Slow loading: branches of equilibria, their stability, and the snap between them."""

import time
from collections.abc import Iterable
from dataclasses import dataclass
from itertools import chain, islice
from typing import Any

import numpy as np
from numpy.typing import NDArray

from snapjump.arrays import Array
from snapjump.composition import Simulation
from snapjump.declare.fields import integer
from snapjump.declare.outputs import output
from snapjump.engine.status import BRANCH_LOST, NAMES, NO_EQUILIBRIUM, NO_SNAP, OK, REASONS
from snapjump.results import Result
from snapjump.scenes.march_outputs import RunOutputs
from snapjump.sim.base import AT_REST, NEEDS_NO_GROUND, TURNS, Progress, SceneOptions
from snapjump.statics.arch import StaticArch
from snapjump.statics.branch import Branch, Point
from snapjump.statics.critical import NoSnapError, NoStartError, Snap, find_snap, start_point
from snapjump.statics.rounding import LostToRoundingError

LENGTH = 6.0  # of a branch, in the norm of its free coordinates and angle


# What statics fails of, the particular before the general.
STATUSES = {NoStartError: NO_EQUILIBRIUM, NoSnapError: NO_SNAP, ArithmeticError: BRANCH_LOST}
FOUND = ("ok",)


@dataclass(frozen=True)
class StaticOutputs(RunOutputs):
    """Outputs of the equilibria before and after a slow snap. ``found``: them, or why there are
    none."""

    found: Snap | ArithmeticError

    @property
    def snap(self) -> Snap:
        """What is read off where there is one."""
        assert isinstance(self.found, Snap)
        return self.found

    @property
    def code(self) -> int:
        """How it ended, by number."""
        known = (code for kind, code in STATUSES.items() if isinstance(self.found, kind))
        return next(known, OK)

    @property
    def message(self) -> str:
        """Why there is no snap; empty if there is one."""
        return f"{REASONS[self.code]}: {self.found}" if self.code != OK else ""

    def statuses(self) -> list[str]:
        """How it ended."""
        return [NAMES[self.code]]

    @output("rad", of=FOUND)
    def alpha_critical_rad(self) -> float:
        """Angle of the left clamp at which the arch loses its stability."""
        return self.snap.alpha_rad

    @output("rad", of=FOUND)
    def alpha_critical_error_rad(self) -> float:
        """How well the critical angle is known: what rounding makes of it."""
        return self.snap.alpha_error_rad

    @output("L", of=FOUND)
    def h1_bar(self) -> float:
        """Depth of the lowest point below the clamps as the arch snaps."""
        return self.snap.h1_bar

    @output("L", of=FOUND)
    def h2_bar(self) -> float:
        """Depth of the snapped arch's midpoint below the clamps."""
        return self.snap.h2_bar

    @output("EI/L", of=FOUND)
    def energy_before_bar(self) -> float:
        """Elastic energy as the arch snaps."""
        return self.snap.before.energy

    @output("EI/L", of=FOUND)
    def energy_after_bar(self) -> float:
        """Elastic energy of the snapped arch."""
        return self.snap.after.energy

    @output("EI/L", of=FOUND)
    def energy_released_bar(self) -> float:
        """Elastic energy that the snap releases."""
        return self.snap.before.energy - self.snap.after.energy

    @output("L", of=FOUND)
    def midpoint_before_bar(self) -> float:
        """Height of the midpoint above the clamps as the arch snaps."""
        return self.snap.before.midpoint

    @output("L", of=FOUND)
    def midpoint_after_bar(self) -> float:
        """Height of the snapped arch's midpoint above the clamps."""
        return self.snap.after.midpoint


COLUMNS = ("alpha_rad", "midpoint_bar", "energy_bar", "negative_pivots")


def _points(arch: StaticArch, branch: Branch, points: Iterable[Point], farthest: float) -> Array:
    """Rows of COLUMNS along a branch, as long as its angle is in [0, farthest]."""
    rows = []
    for point in points:
        if not 0.0 <= point.left <= farthest:
            break
        found = arch.equilibrium(point.state, point.left, point.left - branch.delta_alpha)
        rows.append((point.left, found.midpoint, found.energy, float(point.negative_eigenvalues)))
    return np.array(rows).reshape(-1, len(COLUMNS))


def _asymmetric(arch: StaticArch, snap: Any, steps: int) -> Array:
    """Points of the branch of leaning arches that meets the symmetric one at the pitchfork.
    It is entered along the critical mode: the tangent's null vector there."""
    branch = Branch(arch, 0.0, symmetric=False)
    state = snap.before.state
    arch.residual(state, snap.alpha_rad, snap.alpha_rad)
    mode = np.append(arch.critical_mode(), 0.0)
    seed = Point(state, snap.alpha_rad, 0.0, 0.0, 0, mode)
    return _points(arch, branch, islice(branch.follow(seed, LENGTH / steps), steps), np.inf)


class Static(SceneOptions):
    """Slow loading: branches, stability, critical angle and snapped state.
    ``steps``: points along each branch."""

    tells = ("design.epsilon", "design.delta_alpha")
    chooses = AT_REST
    outputs = StaticOutputs
    needs = (*NEEDS_NO_GROUND, TURNS)

    steps: int = integer(120, least=10, most=100_000)

    def simulate(self, simulation: Simulation, progress: Progress | None = None) -> Result:
        begun = time.perf_counter()
        try:
            snap, arrays = self.follow(simulation, progress)
        except LostToRoundingError:  # bad input: the mesh, and what to do about it
            raise
        except ArithmeticError as error:
            return StaticOutputs(simulation, begun, error).result({})
        return StaticOutputs(simulation, begun, snap).result(arrays)

    def follow(
        self, simulation: Simulation, progress: Progress | None
    ) -> tuple[Snap, dict[str, NDArray[Any]]]:
        """The snap, and the branches and shapes about it. Raises ArithmeticError."""
        robot, discretization, steps = simulation.robot, simulation.discretization, self.steps
        epsilon, delta_alpha = simulation.design.epsilon, simulation.design.delta_alpha
        snap = find_snap(robot, discretization, epsilon, delta_alpha)
        arch = StaticArch(robot, discretization, epsilon)
        branch = Branch(arch, delta_alpha)
        tables, starts = [], []
        for upward in (True, False):  # from flat clamps, towards larger angles
            starts.append(start_point(branch, upward))
            walk = chain(starts[-1:], islice(branch.follow(starts[-1], LENGTH / steps), steps))
            tables.append(_points(arch, branch, walk, simulation.drive.end_rad))
            if progress is not None:
                progress(0.5 * len(tables), "branches")
        if delta_alpha == 0.0:
            tables.append(_asymmetric(arch, snap, steps))
        flat = arch.equilibrium(starts[0].state, 0.0, -delta_alpha)
        shapes = [flat, snap.before, snap.after]
        arrays: dict[str, NDArray[Any]] = {
            f"branch_{name}": column
            for name, column in zip(COLUMNS, np.vstack(tables).T, strict=True)
        }
        arrays["branch_number"] = np.repeat(np.arange(len(tables)), [len(t) for t in tables])
        arrays["shapes_x_bar"] = np.array([s.x for s in shapes])
        arrays["shapes_y_bar"] = np.array([s.y for s in shapes])
        arrays["shapes_label"] = np.array(["flat clamps", "at the snap", "snapped"])
        return snap, arrays
