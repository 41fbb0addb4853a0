"""Outputs of jumps: apex and lift-off, how the robot stood, how far off its apex may be."""

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from snapjump.declare.outputs import FLAG, WORD, output
from snapjump.engine import outcome as c
from snapjump.error_estimate import ErrorEstimate, error_estimate
from snapjump.number.trigonometry import arctan
from snapjump.results import JumpResult
from snapjump.scenes.beam_outputs import BeamOutputs
from snapjump.scenes.flight import Flight, flight, world
from snapjump.scenes.jump_loads import JumpLoads, Release
from snapjump.scenes.march_outputs import GroundOutputs, RunOutputs

Array = NDArray[np.float64]
FLOWN = ("ok",)
ENDED = ("ok", "no_jump")  # which have an apex, though it be where the robot came to rest


@dataclass(frozen=True)
class JumpOutputs(GroundOutputs):
    """R jumps; a figure is an array (R,), NaN only where the status says why.

    Times count from the beginning of the clamps' rotation.
    """

    @cached_property
    def flight(self) -> Flight:
        """Apex and lift-off, dimensionless, whatever the status."""
        begun, model = self.model.clamp.time_turned(), self.model
        return flight(begun, model.load, self.outcome, model.drag)

    @cached_property
    def estimate(self) -> ErrorEstimate:
        """Estimated errors; none where no flight has an apex."""
        steps = np.where(self.ended_as(FLOWN), self.outcome[:, c.ERROR_SUM], np.nan)
        return error_estimate(self.simulation, self.model, steps)

    @cached_property
    def apexes(self) -> Array:
        """Both coordinates of the apex (R, 2), NaN unless the status is ok."""
        flown = self.ended_as(FLOWN)[:, None]
        return np.where(flown, np.column_stack([self.x_bar, self.y_bar]), np.nan)

    @output("L", of=ENDED, show="apex: x {}")
    def x_bar(self) -> Array:
        """Apex of the centre of mass along the ground, from where it started."""
        return self.flight.apex_x

    @output("L", of=ENDED, show="apex: y {}")
    def y_bar(self) -> Array:
        """Apex of the centre of mass, above the ground."""
        return self.flight.apex_y

    @output("L", of=ENDED, show="")
    def x_world_bar(self) -> Array:
        """Apex of the centre of mass on the level, from where it started."""
        return world(self.model.load, self.flight.apex_x, self.flight.apex_y)[0]

    @output("L", of=ENDED, show="")
    def y_world_bar(self) -> Array:
        """Apex of the centre of mass along the plumb, above where it started on the ground."""
        return world(self.model.load, self.flight.apex_x, self.flight.apex_y)[1]

    @output("s", of=FLOWN, show="apex: {} after the clamps begin to turn")
    def apex_time_s(self) -> Array:
        """Time of the apex, since the clamps began to turn."""
        return self.flight.apex_time * self.scales.time_s

    @output("m/s", of=FLOWN, show="lift-off: v_x {}")
    def liftoff_vx_m_s(self) -> Array:
        """Velocity of the centre of mass at the last contact, along the ground."""
        return self.flight.liftoff_vx * self.scales.velocity_m_s

    @output("m/s", of=FLOWN, show="lift-off: v_y {}")
    def liftoff_vy_m_s(self) -> Array:
        """Velocity of the centre of mass at the last contact, upwards."""
        return self.flight.liftoff_vy * self.scales.velocity_m_s

    @output("s", of=FLOWN, show="lift-off: {} after the clamps begin to turn")
    def liftoff_time_s(self) -> Array:
        """Time of the last contact, since the clamps began to turn."""
        return self.flight.liftoff_time * self.scales.time_s

    @output("L", of=FLOWN, show="")
    def liftoff_x_bar(self) -> Array:
        """Centre of mass at the last contact, from where it started."""
        return self.flight.liftoff_x

    @output("L", of=FLOWN, show="")
    def liftoff_y_bar(self) -> Array:
        """Centre of mass at the last contact, above the ground."""
        return self.flight.liftoff_y

    @output("rad", of=FLOWN, show="lift-off: at {} to the ground")
    def takeoff_angle_rad(self) -> Array:
        """Direction of the centre of mass at the last contact, from the ground towards +x."""
        vx, vy = self.flight.liftoff_vx, self.flight.liftoff_vy
        with np.errstate(invalid="ignore", divide="ignore"):  # of what has not jumped
            half = vy / (np.sqrt(vx * vx + vy * vy) + vx)
            return 2.0 * arctan(half)  # whose bits are no processor's

    @output("rad/s", of=FLOWN, unknown=True, show="lift-off: spin {}")
    def spin_rad_s(self) -> Array:
        """Mean rate of rotation in flight: angular momentum about the centre of mass over the
        moment of inertia."""
        return self.outcome[:, c.SPIN] / self.scales.time_s

    @output("L", of=FLOWN, show="landing: x {} of the centre of mass")
    def landing_x_bar(self) -> Array:
        """Where the centre of mass is back at its height of lift-off, from where it started."""
        return self.flight.landing_x

    @output("L", show="")
    def mount_height_bar(self) -> Array:
        """Height of the clamps above the feet."""
        return self.model.frame.mount_y - self.model.frame.foot_y

    @output("rad", show="")
    def start_angle_rad(self) -> Array:
        """Angle of the left clamp at which the motion starts."""
        return self.model.clamp.start

    @output("L", show="")
    def error_sum_bar(self) -> Array:
        """Error estimates of all steps, added up."""
        return self.outcome[:, c.ERROR_SUM]

    @output("1", show="")
    def coarsest_contact_step(self) -> Array:
        """Largest step, times the frequency of contact in it."""
        return self.outcome[:, c.COARSEST]

    @output("%", of=FLOWN, unknown=True, show="")
    def x_error_estimate_percent(self) -> Array:
        """Estimated error of x_bar, of max(|x|, 0.1 y)."""
        return self.estimate.x_percent

    @output("%", of=FLOWN, unknown=True, show="")
    def y_error_estimate_percent(self) -> Array:
        """Estimated error of y_bar."""
        return self.estimate.y_percent

    @output("%", of=FLOWN, unknown=True, show="")
    def error_estimate_percent(self) -> Array:
        """The larger of both estimated errors."""
        return self.estimate.percent

    @output(kind=FLAG, show="")
    def within_tier(self) -> NDArray[Any]:
        """Whether the errors are within what the accuracy tier promises; null if they are not
        known."""
        return self.estimate.within_tier

    @output(kind=WORD, show="")
    def error_unknown_because(self) -> NDArray[Any]:
        """What this robot or simulation has that error estimates were not calibrated for; empty
        if there is nothing."""
        return self.estimate.because


@dataclass(frozen=True)
class JumpRun(JumpOutputs, RunOutputs):
    """One jump of which only the end is known."""

    kind = JumpResult


@dataclass(frozen=True)
class RecordedJump(JumpOutputs, JumpLoads, BeamOutputs):
    """One jump with its trajectory."""

    kind = JumpResult

    @cached_property
    def estimate(self) -> ErrorEstimate:
        """Estimated errors, and whether energy and forces are in balance as they then must be."""
        return super().estimate.balanced(self.numerical_loss_share, self.max_residual)

    @property
    def push(self) -> float:
        """Of all steps and points; unknown where it is none of a state's."""
        constraint = self.model.contact.is_constraint()
        return np.nan if constraint else self.every.force * self.scales.force_N

    @property
    def impulse(self) -> float:
        """Up to the end of the march."""
        return float(self.arrays["ground_impulse_y_N_s"][-1])

    @property
    def release(self) -> Release:
        """Up to the last contact, between samples."""
        elastic, time_s = self.arrays["elastic_J"], self.arrays["time_s"]
        left = np.interp(float(self.liftoff_time_s[0]), time_s, elastic)
        return Release(float(self.arrays["com_y_m"][0]), float(elastic[0] - left))
