"""Flight of a centre of mass through air: on from a march's end to its apex, back to its lift-off,
and from there to where it lands.
"""

from typing import Any, NamedTuple

from snapjump.engine.model import with_numbers
from snapjump.number.array import uncounted
from snapjump.number.dispatch import compiled, kernel
from snapjump.number.functions import sqrt

# Of the classical Runge-Kutta method: of a flight of any length, and beside them for each time in
# which drag would stop it. Throws up to 60 times as fast as what falls in the end are 3e-8 off.
STEPS, STEPS_A_STOP, MOST_STEPS = 64, 16, 4096
# Newton iterations for the moment of an apex or a landing, and the share of it that is rounding.
MOST_ITERATIONS, ENOUGH = 20, 1e-14


class Surroundings(NamedTuple):
    """What moves a robot in flight: gravity and drag, members of a model."""

    load: Any
    drag: Any


class Moving(NamedTuple):
    """Place (L) and velocity (L/T) of the centre of mass."""

    x: Any
    y: Any
    vx: Any
    vy: Any


class Arcs(NamedTuple):
    """Flights (R): place and time ahead of the apex, place and velocity of the lift-off, and where
    along the ground its height is reached again (L, T)."""

    apex_x: Any
    apex_y: Any
    ahead: Any
    liftoff_x: Any
    liftoff_y: Any
    liftoff_vx: Any
    liftoff_vy: Any
    landing_x: Any


@kernel
def acceleration(around: Any, vx: Any, vy: Any) -> Any:
    """Acceleration (x, y) of a centre of mass in flight."""
    ax, ay = around.drag.acceleration(vx, vy)
    return ax + around.load.pull(), ay - around.load.gravity()


@kernel
def steps_of(around: Any, now: Moving, time: Any) -> int:
    """How many steps a flight of so long a time (T) takes."""
    ax, ay = around.drag.acceleration(now.vx, now.vy)
    slowing = sqrt(ax * ax + ay * ay)
    speed = sqrt(now.vx * now.vx + now.vy * now.vy) + 1e-300
    return int(min(STEPS + STEPS_A_STOP * abs(time) * slowing / speed, 1.0 * MOST_STEPS))


@kernel
def after(around: Any, now: Moving, time: Any) -> Moving:
    """Place and velocity after a time (T), or before it where that is negative."""
    steps = steps_of(around, now, time)
    h = time / steps
    x, y, vx, vy = now
    for _ in range(steps):
        ax, ay = acceleration(around, vx, vy)
        bx, by = acceleration(around, vx + 0.5 * h * ax, vy + 0.5 * h * ay)
        cx, cy = acceleration(around, vx + 0.5 * h * bx, vy + 0.5 * h * by)
        dx, dy = acceleration(around, vx + h * cx, vy + h * cy)
        x = x + h * (vx + h * (ax + bx + cx) / 6.0)
        y = y + h * (vy + h * (ay + by + cy) / 6.0)
        vx = vx + h * (ax + 2.0 * (bx + cx) + dx) / 6.0
        vy = vy + h * (ay + 2.0 * (by + cy) + dy) / 6.0
    return Moving(x, y, vx, vy)


@kernel
def time_to_apex(around: Any, now: Moving) -> Any:
    """When (T) a robot that rises is highest against gravity."""
    # A rise that slows less and less is approached from before, without going too far.
    time = 0.0
    for _ in range(MOST_ITERATIONS):
        then = after(around, now, time)
        ax, ay = acceleration(around, then.vx, then.vy)
        missing = -around.load.rise(then.vx, then.vy) / around.load.rise(ax, ay)
        time = time + missing
        if abs(missing) <= ENOUGH * time:
            break
    return time


@kernel
def time_to_land(around: Any, liftoff: Moving) -> Any:
    """When (T) a robot that leaves the ground is back at its height of lift-off."""
    # A fall that gathers speed is approached from behind: it takes no longer than in vacuum.
    time = 2.0 * liftoff.vy / around.load.gravity()
    for _ in range(MOST_ITERATIONS):
        then = after(around, liftoff, time)
        missing = (liftoff.y - then.y) / then.vy
        time = time + missing
        if abs(missing) <= ENOUGH * time:
            break
    return time


@compiled
def fly(template: Any, numbers: Any, ends: Any, aloft: Any, arcs: Arcs) -> None:
    """Fill the arcs of R robots with numbers (R, P) of their surroundings, whose marches end in
    states (R, 4) of :class:`Moving`, times ``aloft`` (R) after their lift-off; those that do not
    rise stay where they are."""
    numbers, ends = uncounted(numbers), uncounted(ends)
    for robot in range(ends.shape[0]):
        around = with_numbers(template, numbers[robot])
        end = ends[robot]
        now = Moving(end[0], end[1], end[2], end[3])
        apex, landing, ahead = now, now, 0.0
        liftoff = after(around, now, -aloft[robot])
        if around.load.rise(now.vx, now.vy) > 0.0:
            ahead = time_to_apex(around, now)
            apex = after(around, now, ahead)
        if liftoff.vy > 0.0:
            landing = after(around, liftoff, time_to_land(around, liftoff))
        arcs.apex_x[robot] = apex.x
        arcs.apex_y[robot] = apex.y
        arcs.ahead[robot] = ahead
        arcs.liftoff_x[robot] = liftoff.x
        arcs.liftoff_y[robot] = liftoff.y
        arcs.liftoff_vx[robot] = liftoff.vx
        arcs.liftoff_vy[robot] = liftoff.vy
        arcs.landing_x[robot] = landing.x
