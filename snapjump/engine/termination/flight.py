"""Termination of a jump: nothing can touch the ground any more before the apex.

The centre of mass moves ballistically once nothing touches. The robot fits a box that turns with
the frame; a corner of it at height y with velocity w, at distance r from the centre of mass and
turning at rate Omega, stays above y + w t - (g + Omega^2 r) t^2 / 2. That bound is concave, so it
is positive up to some moment if it is so now and then; the moment is the apex, or the time from
which the centre of mass is higher than the box's radius.
"""

from typing import Any, NamedTuple

from snapjump.engine.centre_of_mass import centre_of_mass, mean_rotation
from snapjump.engine.clock import COM_VX, COM_VY, COM_X, COM_Y, GAP, SPIN, TIME
from snapjump.engine.status import NO_JUMP, OK, RUNNING, TIME_LIMIT
from snapjump.engine.termination.base import Termination
from snapjump.number.dispatch import kernel
from snapjump.number.functions import absolute, any_true, maximum, minimum, sqrt, where

# The beam's vibration makes the frame's rotation waver; its mass is a few percent of the frame's.
TURN_MARGIN = 0.25
# Nodes of a stretched beam may lie a little outside the ellipse of an inextensible one.
REACH_MARGIN = 1.02
# An apex (L) above which a robot in the air has left the ground for good, its box being smaller.
SURE_HEIGHT = 1.5
FLIGHT_TOLERANCE_FACTOR = 100.0
# Before the snap the arch stands this high above its clamps (L), and rings quietly.
LOADING_HEIGHT = 0.05
LOADING_TOLERANCE_FACTOR = 4.0


@Termination.member
class FlightTermination(NamedTuple):
    """At its time limit a robot still on the ground, its clamps turned, has not jumped."""

    def time_limit(self, model: Any) -> Any:
        return model.time_limit.duration

    def tolerance_factor(self, model: Any, work: Any) -> Any:
        # In flight towards a high apex only the centre of mass counts, and every integrator moves
        # that exactly; the beam's vibration need only be followed well enough not to miss the
        # ground.
        clock = work.clock
        rise = maximum(clock[COM_VY], 0.0 * clock[TIME])
        _, slowing = braking(model, clock[COM_VX], clock[COM_VY])
        height = clock[COM_Y] + 0.5 * rise * rise / slowing
        aloft = (clock[GAP] >= model.ground.clearance) & (height > SURE_HEIGHT)
        loading = where(arch_height(model, work) > LOADING_HEIGHT, LOADING_TOLERANCE_FACTOR, 1.0)
        return where(aloft, FLIGHT_TOLERANCE_FACTOR, loading)

    def terminate(self, model: Any, masses: Any, work: Any, ended: Any) -> Any:
        clock = work.clock
        over = clock[TIME] >= self.time_limit(model) * (1.0 - 1e-12)
        airborne = clock[GAP] >= model.ground.clearance
        turned = model.clamp.angles(clock[TIME]).left_rate == 0.0
        status = where(over, where(turned, 1.0 * NO_JUMP, 1.0 * TIME_LIMIT), 1.0 * RUNNING)
        known = ended & (airborne | over)
        if any_true(known):
            x, y, vx, vy = centre_of_mass(model, masses, work.mesh, work.start, work.velocity[0])
            clock[COM_X] = where(known, x, clock[COM_X])
            clock[COM_Y] = where(known, y, clock[COM_Y])
            clock[COM_VX] = where(known, vx, clock[COM_VX])
            clock[COM_VY] = where(known, vy, clock[COM_VY])
            clear = airborne & clear_of_ground(model, work, x, y, vx, vy)
            status = where(clear, 1.0 * OK, status)
            if any_true(clear):
                about = x, y, vx, vy
                spin = mean_rotation(model, masses, work.mesh, work.start, work.velocity[0], about)
                clock[SPIN] = where(clear, spin, clock[SPIN])
        return status


@kernel
def braking(model: Any, along: Any, rise: Any) -> Any:
    """How fast (L/T^2) a robot that rises loses its speed across the ground at least and at most,
    up to its apex: by gravity alone, and with as much drag as now."""
    least = model.load.gravity()
    most = least
    if model.drag.exists():
        x, y = model.drag.acceleration(along, rise)
        most = least + sqrt(x * x + y * y)
    return least, most


@kernel
def arch_height(model: Any, work: Any) -> Any:
    """Height of the beam's middle above the middle of its ends (L)."""
    stride = model.discretization.node_dofs()
    first = model.frame.dofs(work.mesh) + 1
    last = work.state.shape[0] - stride + 1
    middle = first + stride * ((last - first) // (2 * stride))
    return work.state[middle] - 0.5 * (work.state[first] + work.state[last])


@kernel
def clear_of_ground(model: Any, work: Any, com_x: Any, com_y: Any, along: Any, rise: Any) -> Any:
    """Whether the box cannot touch the ground before the apex (see the module's text)."""
    frame = model.frame.box(work.mesh, work.start, work.velocity[0])
    freely, fall = braking(model, along, rise)
    reach = model.ground.clearance
    turn = frame.turn_rate
    c = frame.cosine
    s = frame.sine
    depth = 0.5 * REACH_MARGIN * sqrt(1.0 - 4.0 * frame.half_span * frame.half_span)
    low = minimum(frame.foot_y, frame.mount_y - depth)
    high = maximum(frame.top_y, frame.mount_y + depth)
    half_width = 0.5 * REACH_MARGIN

    radius = 0.0 * c
    for corner in range(4):
        x = -half_width if corner < 2 else half_width
        y = low if corner % 2 == 0 else high
        rx = frame.x + c * x - s * y - com_x
        ry = frame.y + s * x + c * y - com_y
        radius = maximum(radius, sqrt(rx * rx + ry * ry))
    missing = maximum(radius + reach - com_y, 0.0 * c)
    discriminant = rise * rise - 2.0 * fall * missing
    apex = rise / freely
    horizon = where(discriminant > 0.0, (rise - sqrt(maximum(discriminant, 0.0 * c))) / fall, apex)
    clear = rise > 0.0
    for corner in range(4):
        x = -half_width if corner < 2 else half_width
        y = low if corner % 2 == 0 else high
        rx = frame.x + c * x - s * y - com_x
        height = frame.y + s * x + c * y - reach
        climb = rise + turn * rx - TURN_MARGIN * absolute(turn) * radius
        bend = fall + turn * turn * radius
        later = height + climb * horizon - 0.5 * bend * horizon * horizon
        clear = clear & (height > 0.0) & (later > 0.0)
    # Up a slope the highest point against gravity comes after the one above the ground.
    late = model.load.time_to_apex(along, rise)
    height = com_y + late * (rise - 0.5 * fall * late)
    return clear & ((late <= apex) | (height > radius + reach))
