"""Which instants of a motion a filmstrip shows, and what they are called."""

import itertools

import numpy as np

from snapjump.plots.motion import Array, Motion


def middle_height(motion: Motion) -> Array:
    """Height of the beam's middle above the line of its clamps, in L, in the frame's axes (K,)."""
    left = np.stack([motion.node_x[:, 0], motion.node_y[:, 0]], axis=1)
    right = np.stack([motion.node_x[:, -1], motion.node_y[:, -1]], axis=1)
    centre = motion.node_x.shape[1] // 2
    middle = np.stack([motion.node_x[:, centre], motion.node_y[:, centre]], axis=1)
    along = right - left
    span = np.maximum(np.hypot(along[:, 0], along[:, 1]), 1e-12)
    offset = middle - left
    return (along[:, 0] * offset[:, 1] - along[:, 1] * offset[:, 0]) / span


def snap_interval(motion: Motion) -> tuple[int, int] | None:
    """Samples at which the middle starts to fall and is first down; None if it never flips."""
    height = middle_height(motion)
    down = np.flatnonzero(height < 0.0)
    if height[0] <= 0.0 or len(down) == 0:
        return None
    begin = np.flatnonzero(height[: down[0]] > 0.85 * height[0])
    return int(begin[-1]) if len(begin) else 0, int(down[0])


def moments(motion: Motion, liftoff_ms: float | None, wanted: int = 8) -> list[tuple[int, str]]:
    """At most `wanted` samples with names (empty for those in between), in order of time."""
    found: dict[int, str] = {0: "start"}

    def add(index: int, name: str) -> None:
        found.setdefault(int(index), name)

    snap = snap_interval(motion)
    if snap is not None:
        add(snap[0], "snap begins")
        add(snap[1], "at clamp level")
    strong = np.flatnonzero(motion.push > 2.0)
    if len(strong):
        hits = np.flatnonzero((motion.push > 2.0) & (motion.pad_force[:, 0, 1] > 0.5 * motion.push))
        add(hits[0] if len(hits) else strong[0], "beam strikes")
        add(int(np.argmax(motion.push)), "hardest push")
    if liftoff_ms is not None and liftoff_ms <= motion.time[-1]:
        add(int(np.argmin(abs(motion.time - liftoff_ms))), "lift-off")
        add(motion.count - 1, "in flight")
    else:
        add(motion.count - 1, "end")
    _fill_gaps(motion, found, min(wanted, motion.count))
    return sorted(found.items())


def travel(motion: Motion) -> Array:
    """How far the beam has moved, added up: root mean square over its nodes, in L (K,)."""
    steps = np.diff(motion.node_x, axis=0) ** 2 + np.diff(motion.node_y, axis=0) ** 2
    return np.concatenate([[0.0], np.cumsum(np.sqrt(steps.mean(axis=1)))])


def _fill_gaps(motion: Motion, found: dict[int, str], wanted: int) -> None:
    """Add nameless samples where the beam moves farthest between two of those found."""
    path = travel(motion) + 1e-9 * motion.time
    while len(found) < wanted:
        chosen = sorted(found)
        widest = sorted(itertools.pairwise(chosen), key=lambda p: path[p[0]] - path[p[1]])
        for left, right in widest:
            if right - left > 1:
                half = 0.5 * (path[left] + path[right])
                middle = left + 1 + int(np.argmin(abs(path[left + 1 : right] - half)))
                found[middle] = ""
                break
        else:
            return
