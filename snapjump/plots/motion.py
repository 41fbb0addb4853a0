"""What the pictures show: a result's arrays in units of L and ms, and poses at any time."""

from dataclasses import dataclass
from typing import Any

import numpy as np

Array = np.ndarray
NAMES = (
    *("time_s", "node_x_m", "node_y_m", "corner_x_m", "corner_y_m", "clamp_left_rad"),
    *("com_x_m", "com_y_m", "com_vx_m_s", "com_vy_m_s"),
    *("node_normal_N", "node_friction_N", "corner_normal_N", "corner_friction_N"),
)


@dataclass(frozen=True)
class Motion:
    """A sampled motion; K samples, N+1 nodes. Lengths in L, times in ms from the start."""

    length_m: float
    time: Array  # (K,)
    node_x: Array  # (K, N+1)
    node_y: Array
    corner_x: Array | None  # (K, 4): left foot, left top, right top, right foot
    corner_y: Array | None
    centre: Array | None  # (K, 2) centre of mass
    velocity: Array | None  # (2,) of the centre of mass at the last sample, L/ms, if it flies
    gravity: float  # L/ms^2
    turning: float  # rad/ms of the frame in flight
    pad_x: Array  # (K, P) where the ground pushes: centre of pressure of the beam, then corners
    pad_force: Array  # (K, P, 2) friction and normal force there, over the robot's weight
    alpha: Array | None  # (K,) leading clamp's angle, rad

    @property
    def count(self) -> int:
        return len(self.time)

    @property
    def push(self) -> Array:
        """Whole normal force of the ground over the robot's weight (K,)."""
        return self.pad_force[:, :, 1].sum(axis=1)


@dataclass(frozen=True)
class Poses:
    """M instants of a motion, interpolated between samples or in ballistic flight after them."""

    time: Array  # (M,)
    node_x: Array  # (M, N+1)
    node_y: Array
    corner_x: Array | None  # (M, 4)
    corner_y: Array | None
    centre: Array | None  # (M, 2)


def read_motion(result: Any) -> Motion | None:
    """The motion of a result, without samples that are not finite; None if none is left."""
    arrays = result.arrays
    if any(np.size(arrays.get(key, ())) == 0 for key in ("time_s", "node_x_m", "node_y_m")):
        return None
    data = {name: np.asarray(arrays[name], float) for name in NAMES if name in arrays}
    count = min(len(column) for column in data.values())
    good = np.ones(count, bool)
    for column in data.values():
        good &= np.isfinite(column[:count].reshape(count, -1)).all(axis=1)
    if not good.any():
        return None
    data = {name: column[:count][good] for name, column in data.items()}
    length = float(result.simulation.robot.length_m)
    gravity = float(getattr(result.simulation.robot, "gravity_m_s2", 0.0))
    time = 1e3 * (data["time_s"] - data["time_s"][0])
    centre = velocity = None
    if "com_x_m" in data and "com_y_m" in data:
        centre = np.stack([data["com_x_m"], data["com_y_m"]], axis=1) / length
    if result.status == "ok" and "com_vx_m_s" in data and "com_vy_m_s" in data:
        velocity = np.array([data["com_vx_m_s"][-1], data["com_vy_m_s"][-1]]) / length * 1e-3
    corner_x = corner_y = None
    turning = 0.0
    if "corner_x_m" in data and "corner_y_m" in data:
        corner_x, corner_y = data["corner_x_m"] / length, data["corner_y_m"] / length
        turning = _turning_rate(time, corner_x, corner_y)
    pad_x, pad_force = _pads(data, length, _weight(result))
    return Motion(
        length_m=length,
        time=time,
        node_x=data["node_x_m"].reshape(len(time), -1) / length,
        node_y=data["node_y_m"].reshape(len(time), -1) / length,
        corner_x=corner_x,
        corner_y=corner_y,
        centre=centre,
        velocity=velocity,
        gravity=gravity / length * 1e-6,
        turning=turning,
        pad_x=pad_x,
        pad_force=pad_force,
        alpha=data.get("clamp_left_rad"),
    )


def poses(motion: Motion, times: Array) -> Poses:
    """Poses at `times` (ms): linear between samples, ballistic and evenly turning after them."""
    times = np.maximum(np.asarray(times, float), 0.0)
    last = motion.count - 1
    right = np.clip(np.searchsorted(motion.time, times), min(1, last), last)
    left = np.maximum(right - 1, 0)
    step = np.where(right > left, motion.time[right] - motion.time[left], 1.0)
    part = np.clip((times - motion.time[left]) / np.maximum(step, 1e-12), 0.0, 1.0)[:, None]

    def mix(column: Array | None) -> Array | None:
        if column is None:
            return None
        return (1.0 - part) * column[left] + part * column[right]

    node_x, node_y = mix(motion.node_x), mix(motion.node_y)
    corner_x, corner_y, centre = mix(motion.corner_x), mix(motion.corner_y), mix(motion.centre)
    assert node_x is not None and node_y is not None
    if centre is not None and motion.velocity is not None:
        after = np.maximum(times - motion.time[-1], 0.0)
        angle = motion.turning * after
        moved = centre + after[:, None] * motion.velocity
        moved[:, 1] -= 0.5 * motion.gravity * after**2
        node_x, node_y = _carry(node_x, node_y, centre, moved, angle)
        if corner_x is not None and corner_y is not None:
            corner_x, corner_y = _carry(corner_x, corner_y, centre, moved, angle)
        centre = moved
    return Poses(times, node_x, node_y, corner_x, corner_y, centre)


def _carry(x: Array, y: Array, old: Array, new: Array, angle: Array) -> tuple[Array, Array]:
    """Turn points (M, P) by `angle` (M,) about `old` (M, 2) and move them along to `new`."""
    cos, sin = np.cos(angle)[:, None], np.sin(angle)[:, None]
    dx, dy = x - old[:, :1], y - old[:, 1:]
    return new[:, :1] + cos * dx - sin * dy, new[:, 1:] + sin * dx + cos * dy


def _turning_rate(time: Array, corner_x: Array, corner_y: Array) -> float:
    """Mean turning rate of the frame's top (rad/ms) over the last tenth of the motion."""
    top = np.arctan2(corner_y[:, 2] - corner_y[:, 1], corner_x[:, 2] - corner_x[:, 1])
    late = time >= time[-1] - 0.1 * (time[-1] - time[0])
    if late.sum() < 2:
        return 0.0
    return float(np.polyfit(time[late], np.unwrap(top[late]), 1)[0])


def _pads(data: dict[str, Array], length: float, weight: float) -> tuple[Array, Array]:
    """Points (K, P) in L and forces (K, P, 2) in weights: the beam's resultant, each corner."""
    count = len(data["time_s"])
    points, forces = [], []
    if "node_normal_N" in data and "node_friction_N" in data:
        normal = data["node_normal_N"].reshape(count, -1)
        total = normal.sum(axis=1)
        share = normal / np.where(total > 0.0, total, 1.0)[:, None]
        points.append((share * data["node_x_m"].reshape(count, -1)).sum(axis=1, keepdims=True))
        friction = data["node_friction_N"].reshape(count, -1).sum(axis=1)
        forces.append(np.stack([friction, total], axis=-1)[:, None, :])
    if all(name in data for name in ("corner_x_m", "corner_normal_N", "corner_friction_N")):
        points.append(data["corner_x_m"])
        forces.append(np.stack([data["corner_friction_N"], data["corner_normal_N"]], axis=-1))
    if not points:
        return np.zeros((count, 1)), np.zeros((count, 1, 2))
    return np.hstack(points) / length, np.concatenate(forces, axis=1) / weight


def _weight(result: Any) -> float:
    """The robot's weight in N, or 1 where it has none."""
    try:
        robot = result.simulation.robot
        return float(result.simulation.environment.mass_kg(robot) * robot.gravity_m_s2) or 1.0
    except (AttributeError, ValueError):
        return 1.0
