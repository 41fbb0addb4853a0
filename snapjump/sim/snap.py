"""The dynamic snap of the beam alone: a fixed frame, no gravity, no ground."""

import math
import time
from dataclasses import dataclass
from typing import Any

from snapjump.composition import Simulation
from snapjump.declare.fields import number
from snapjump.declare.outputs import output
from snapjump.engine import outcome as c
from snapjump.engine.recorder.midpoint import make_midpoint_recorder
from snapjump.engine.recorder.trajectory import recorder_of
from snapjump.engine.status import NO_SNAP, OK
from snapjump.results import Result
from snapjump.scenes.beam_outputs import BeamOutputs
from snapjump.scenes.every_step import ROWS, EveryStep
from snapjump.scenes.march_outputs import side_by_side
from snapjump.scenes.midpoint import Midpoint
from snapjump.scenes.snap_march import snap_march
from snapjump.scenes.trajectory import trajectory_arrays
from snapjump.sim.base import NEEDS_NO_GROUND, WITHOUT_GROUND, Progress, SampledScene, check_samples

SNAPPED = ("ok",)
MARCHED = ("ok", "no_snap")  # to the end


@dataclass(frozen=True)
class SnapOutputs(BeamOutputs):
    """When and how the midpoint crosses the line of the clamps. ``midpoint``: at every step of the
    march, between which crossings and largest values are interpolated, so that none of them depends
    on ``sim.sample_interval_s``."""

    midpoint: Midpoint
    clamp: Any

    @output("rad", of=SNAPPED)
    def alpha_snap_rad(self) -> float:
        """Angle of the left clamp as the midpoint crosses the line of the clamps."""
        return float(self.clamp.angles(self.midpoint.crossing_s / self.scales.time_s).left)

    @output("s", of=SNAPPED)
    def snap_time_s(self) -> float:
        """When the midpoint crosses the line of the clamps, since they began to turn."""
        return self.midpoint.crossing_s

    @output("m/s", of=SNAPPED)
    def midpoint_velocity_m_s(self) -> float:
        """Vertical velocity of the midpoint as it crosses the line of the clamps."""
        return self.midpoint.velocity_at(self.midpoint.crossing_s)

    @output("s", of=SNAPPED)
    def snap_duration_s(self) -> float:
        """From the crossing of half the initial height to the first extreme below the line, or to
        the end of the run if that comes first."""
        return self.midpoint.turning_s - self.midpoint.half_way_s

    @output("rad", of=MARCHED)
    def theta_max_rad(self) -> float:
        """Largest absolute tangent angle at the midpoint, at any step or between steps."""
        return self.midpoint.largest_tilt_rad

    @output("m", of=MARCHED)
    def midpoint_min_m(self) -> float:
        """Lowest height of the midpoint, at any step or between steps."""
        return self.midpoint.lowest_m


class Snap(SampledScene):
    """The beam alone snaps in a frame that is held still, without gravity or ground."""

    moves_a_beam = True
    tells = ("design.epsilon", "design.delta_alpha")
    chooses = {**WITHOUT_GROUND, "drive": "smooth_start"}
    outputs = SnapOutputs
    needs = NEEDS_NO_GROUND

    duration_s: float = number(0.06, above=0.0, unit="s")
    sample_interval_s: float = number(5.0e-5, above=0.0, unit="s")

    def check_with(self, simulation: Any) -> None:
        elements = simulation.discretization.elements
        check_samples(self.duration_s, self.sample_interval_s, elements)

    def simulate(self, simulation: Simulation, progress: Progress | None = None) -> Result:
        """Turn the clamps of the arch at rest from flat and follow it through the snap."""
        begun, scales = time.perf_counter(), simulation.robot.scales
        march = snap_march(
            simulation, lambda size, steps: make_midpoint_recorder(recorder_of(size, ROWS), steps)
        )
        interval = self.sample_interval_s / scales.time_s
        every = EveryStep(march, march.recorder.trajectory, interval)
        outcome, model = march.run(progress), march.models[0]
        midpoint = Midpoint.of(march.recorder, scales)
        if outcome[0, c.STATUS] == OK and math.isnan(midpoint.crossing_s):
            outcome[0, c.STATUS] = NO_SNAP
        arrays = trajectory_arrays(march, every.samples()) if every.kept else {}
        marches = side_by_side([model]), outcome, march.kernel_seconds
        known = simulation, begun, *marches, arrays, midpoint, model.clamp
        return SnapOutputs(*known, every=every).result(arrays)
