"""Instants of a motion that a filmstrip shows, and their names."""

import itertools

import numpy as np

from snapjump.show.plots.motion import Array, Motion

RISE = 0.12  # from lift-off to the picture of the flight, in L
TOUCH = 0.05  # what counts as the beam's first touch, in weights of the robot


def beam_in_frame(motion: Motion) -> tuple[Array, Array]:
    """The beam (K, N+1) along and above the line of its clamps, in L."""
    dx, dy = np.moveaxis(motion.nodes - motion.nodes[:, :1], -1, 0)
    span = np.maximum(np.hypot(dx[:, -1:], dy[:, -1:]), 1e-12)
    cos, sin = dx[:, -1:] / span, dy[:, -1:] / span
    return cos * dx + sin * dy, cos * dy - sin * dx


def middle_height(motion: Motion) -> Array:
    """Height of the beam's middle above the line of its clamps, in L (K,)."""
    return beam_in_frame(motion)[1][:, motion.nodes.shape[1] // 2]


def snap_interval(motion: Motion) -> tuple[int, int] | None:
    """Samples at which the middle starts to fall fast and is first down; None if it never is."""
    height = middle_height(motion)
    down = np.flatnonzero(height < 0.0)
    if height[0] <= 0.0 or len(down) == 0:
        return None
    end = int(down[0])
    low = np.flatnonzero(height < -0.5 * height[0])
    speed = np.abs(np.diff(height) / np.maximum(np.diff(motion.time), 1e-9))
    fastest = speed[: low[0] if len(low) else None].max()
    slow = np.flatnonzero(speed[:end] < 0.1 * fastest)
    return (int(slow[-1]) + 1 if len(slow) else 0), end


def instants(motion: Motion, liftoff_ms: float | None, wanted: int = 8) -> list[tuple[int, str]]:
    """At most `wanted` samples with names (empty for those in between), in order of time."""
    found: dict[int, str] = {0: "start"}

    def add(index: int, name: str) -> None:
        found.setdefault(int(index), name)

    touch = np.flatnonzero(motion.pad_force[:, 0, 1] > TOUCH)
    if len(touch) and touch[0] > 0:
        add(touch[0], "beam touches")
    snap = snap_interval(motion)
    if snap is not None:
        add(snap[0], "snap begins")
    if motion.push.max(initial=0.0) > 2.0:
        add(int(np.argmax(motion.push)), "hardest push")
    if motion.bent is not None:
        add(motion.bent.sample, "largest strain")
    last = motion.count - 1
    if liftoff_ms is not None and liftoff_ms <= motion.time[-1]:
        last = min(int(np.searchsorted(motion.time, liftoff_ms, side="right")), last)
        add(last, "lift-off")
        add(_risen(motion, last), "in flight")
    else:
        add(last, "end")
        if snap is not None:
            last = _lowest(motion, snap[1])
            add(last, "first swing ends")
    _fill_gaps(motion, found, last, min(wanted, motion.count))
    return sorted(found.items())


def travel(motion: Motion) -> Array:
    """The path length of the beam in its frame: root mean square, in L (K,)."""
    along, above = beam_in_frame(motion)
    steps = np.diff(along, axis=0) ** 2 + np.diff(above, axis=0) ** 2
    way = np.concatenate([[0.0], np.cumsum(np.sqrt(steps.mean(axis=1)))])
    return way + 1e-6 * motion.time


def settled(motion: Motion) -> int:
    """The sample by which nineteen twentieths of the beam's way since the snap began are done."""
    snap = snap_interval(motion)
    begin = snap[0] if snap is not None else 0
    way = travel(motion)
    return int(np.searchsorted(way, way[begin] + 0.95 * (way[-1] - way[begin])))


def _lowest(motion: Motion, down: int) -> int:
    """The first sample after `down` from which the middle rises."""
    rises = np.flatnonzero(np.diff(middle_height(motion)[down:]) > 0.0)
    return down + int(rises[0]) if len(rises) else motion.count - 1


def _risen(motion: Motion, liftoff: int) -> int:
    """The last sample at which the robot is still near the ground, but after lift-off."""
    if motion.centre is None:
        return motion.count - 1
    near = np.flatnonzero(motion.centre[:, 1] < motion.centre[liftoff, 1] + RISE)
    return min(max(int(near[-1]), liftoff + 1), motion.count - 1)


def _fill_gaps(motion: Motion, found: dict[int, str], last: int, wanted: int) -> None:
    """Add nameless samples, up to `last`, where the beam moves farthest between those found."""
    path = travel(motion)
    while len(found) < wanted:
        chosen = sorted(index for index in found if index <= last)
        widest = sorted(itertools.pairwise(chosen), key=lambda p: path[p[0]] - path[p[1]])
        for left, right in widest:
            if right - left > 1:
                half = 0.5 * (path[left] + path[right])
                middle = left + 1 + int(np.argmin(abs(path[left + 1 : right] - half)))
                found[middle] = ""
                break
        else:
            return
