"""Outputs of a batch of jumps: arrays with one row a jump."""

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING, Any, NamedTuple

from snapjump.arrays import Array
from snapjump.batch.prepare import Prepared
from snapjump.batch.sensitivities import Sensitivities, Slopes, apex_sensitivities
from snapjump.composition import Simulation
from snapjump.engine import outcome as c
from snapjump.files.extras import extras_named
from snapjump.scenes.flight_check import checked_status
from snapjump.scenes.jump_outputs import JumpOutputs
from snapjump.scenes.jump_start import jump_model
from snapjump.scenes.march_outputs import side_by_side
from snapjump.scenes.sensitivities import stick_zone
from snapjump.units import Scales
from snapjump.views.base import Shown

if TYPE_CHECKING:
    import pandas as pd


@dataclass(frozen=True, repr=False)
class Batch(Shown, JumpOutputs):
    """Outputs of R jumps, arrays (R): :class:`snapjump.scenes.jump_outputs.JumpOutputs` has them.

    Counts of designs that are refused are 0, all else of them is NaN. The time in kernels, of all
    together, has starts and idle lanes in it. lane_passes: iterations that all lanes together had
    time for. sensitivities: of the apex, or None where none were asked for. designs: the inputs
    that were given, each (R), by the names of their columns.
    """

    lane_passes: int
    ready: Prepared
    sensitivities: Sensitivities | None = None
    designs: dict[str, Array] = field(default_factory=dict)

    def of_each(self, read: Callable[[Simulation], Any]) -> Array:
        """What is read off each simulation (R)."""
        return self.ready.spread(self.ready.of_each(read))

    @property
    def refusals(self) -> dict[int, str]:
        """Why a design was refused, key, value and range in one line, by the number of its row."""
        return self.ready.refusals

    def to_frame(self) -> "pd.DataFrame":
        """Inputs and outputs as a table, a row a jump."""
        with extras_named():
            import pandas as pd
        return pd.DataFrame({**self.designs, **self.columns()})

    @cached_property
    def scales(self) -> Any:
        """Each robot's own."""
        scales = self.ready.scales
        units: Any = (scales.length_m, scales.time_s, scales.mass_kg)
        spread: Any = [self.ready.spread(each) for each in units]
        return Scales(*spread)


class Marched(NamedTuple):
    """Of M robots: outcomes (M, COLUMNS), the kernels' seconds, the iterations that lanes had time
    for, slopes where these were asked for, and by what was recorded of their loads the figures
    (M, K)."""

    outcome: Array
    kernel_seconds: float
    lane_passes: int
    slopes: Slopes | None
    loads: dict[str, Array]


def batch_of(
    base: Simulation, ready: Prepared, marched: Marched, designs: dict[str, Array]
) -> Batch:
    """The batch of R designs, of which M were marched."""
    # Where no design has a model, any gives the kinds of numbers that are not known.
    models = ready.models or [jump_model(Simulation())]
    model = side_by_side(models, ready.chosen, len(ready.status))
    outcome = ready.spread(marched.outcome, 0.0)
    outcome[:, c.STATUS] = ready.status
    outcome[ready.chosen, c.STATUS] = marched.outcome[:, c.STATUS]
    outcome[:, c.STATUS] = checked_status(model, float(base.discretization.masses().sum()), outcome)
    sensitivities = None
    if marched.slopes is not None:
        slopes = Slopes(*(ready.spread(values) for values in marched.slopes))
        zones = ready.spread(ready.of_each(stick_zone))
        sensitivities = apex_sensitivities(outcome, model.load, model.drag, slopes, zones)
    passes = marched.lane_passes
    seconds = marched.kernel_seconds
    return Batch(base, model, outcome, seconds, passes, ready, sensitivities, designs)
