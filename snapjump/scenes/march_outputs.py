"""Outputs that scenes share: of any simulation, of any march, of one on the ground, recorded."""

import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from snapjump.composition import Simulation
from snapjump.declare.outputs import INTEGER, WORD, Outputs, output
from snapjump.engine import outcome as c
from snapjump.engine.model import Model, with_numbers
from snapjump.engine.models import Models
from snapjump.engine.status import NAMES, OK, REASONS
from snapjump.results import Result
from snapjump.units import Scales

Array = NDArray[np.float64]


def side_by_side(models: Sequence[Model], chosen: Any = (0,), rows: int = 1) -> Model:
    """Models of one composition as one, whose every number is an array (``rows``,).

    chosen: the row of each model; the others are NaN.
    """

    numbers = Models.of(models).numbers
    columns = np.full((numbers.shape[1], rows), np.nan)
    columns[:, np.asarray(chosen, dtype=np.int64)] = numbers.T
    model: Model = with_numbers(models[0], columns)
    return model


@dataclass(frozen=True)
class RunOutputs(Outputs):
    """Outputs of every single simulation. ``begun``: when, by ``time.perf_counter``."""

    kind: ClassVar[type[Result]] = Result
    simulation: Simulation
    begun: float

    @property
    def message(self) -> str:
        """When and why it failed; empty if it did not."""
        return ""

    @output(kind=WORD, show="")
    def accuracy(self) -> str:
        """The accuracy tier."""
        return self.simulation.accuracy

    @output("s", timing=True, show="cost: {} wall")
    def wall_seconds(self) -> float:
        """Time that it took, from the first preparation to the read-out."""
        return time.perf_counter() - self.begun

    def result(self, arrays: dict[str, NDArray[Any]]) -> Result:
        """The simulation's result, with its trajectory or other arrays."""
        (figures,) = self.rows()
        return self.kind(figures["status"], self.message, figures, arrays, self.simulation)


@dataclass(frozen=True)
class MarchOutputs(Outputs):
    """R marches of one composition, read off what they ended with.

    ``model``: all models side by side; ``outcome`` (R, COLUMNS): see
    :mod:`snapjump.engine.outcome`; ``march_seconds``: of a core in the kernels, of all together.
    """

    simulation: Simulation
    model: Model
    outcome: Array
    march_seconds: float

    @cached_property
    def scales(self) -> Scales:
        """The units of its numbers."""
        return self.simulation.robot.scales

    def of_each(self, read: Callable[[Simulation], Any]) -> Any:
        """What is read off each simulation."""
        return read(self.simulation)

    @cached_property
    def codes(self) -> NDArray[np.int64]:
        """Statuses by number (R,)."""
        return self.outcome[:, c.STATUS].astype(np.int64)

    @property
    def message(self) -> str:
        """When and why the first one failed; empty if it did not."""
        status = int(self.codes[0])
        if status == OK:
            return ""
        time_ms = 1e3 * self.outcome[0, c.TIME] * self.scales.time_s
        return f"{REASONS[status]} ({time_ms:.4g} ms after the start)"

    def statuses(self) -> list[str]:
        """How each of them ended."""
        return [NAMES[code] for code in self.codes.tolist()]

    @output("1", kind=INTEGER, show="cost: {} steps")
    def steps(self) -> Array:
        """Time steps."""
        return self.outcome[:, c.STEPS]

    @output("1", kind=INTEGER, show="cost: {} rejected")
    def rejected_steps(self) -> Array:
        """Time steps that were tried in vain, and done again in smaller ones."""
        return self.outcome[:, c.REJECTED]

    @output("1", kind=INTEGER, show="cost: {} Newton iterations")
    def newton_iterations(self) -> Array:
        """Newton iterations of all steps."""
        return self.outcome[:, c.ITERATIONS]

    @output("s", timing=True, show="cost: {} in kernels")
    def kernel_seconds(self) -> Array:
        """Time of one core in the kernels, by share of its batch's iterations."""
        iterations = self.outcome[:, c.ITERATIONS]
        return self.march_seconds * iterations / max(float(iterations.sum()), 1.0)


class GroundOutputs(MarchOutputs):
    """Of marches on the ground."""

    @output("m", show="contact: smallest gap {}")
    def min_gap_m(self) -> Array:
        """Smallest distance from the ground at the end of any step."""
        gap = self.outcome[:, c.SMALLEST_GAP]
        known = np.isfinite(gap) & (self.outcome[:, c.STEPS] > 0.0)
        return np.where(known, gap * self.scales.length_m, np.nan)


@dataclass(frozen=True)
class RecordedOutputs(MarchOutputs, RunOutputs):
    """Of one march whose trajectory is recorded. ``arrays``: it, and the energy ledger; empty where
    the march did not begin."""

    arrays: dict[str, NDArray[Any]]

    @output("1", show="")
    def numerical_loss_share(self) -> float:
        """Energy at the end that only the numerics can have taken, or given (below 0), over the
        largest kinetic energy; 0 where nothing moved."""
        largest = self.arrays["kinetic_J"].max() if self.arrays else 0.0
        return self.arrays["numerical_loss_J"][-1] / largest if largest else 0.0

    @output("1", show="")
    def max_residual(self) -> Array:
        """Largest residual that Newton's method left in any stage, over the largest force in
        play."""
        return self.outcome[:, c.LARGEST_RESIDUAL]
