"""Motion for pictures: a result's arrays in units of L and ms, and poses at any time."""

from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from snapjump.scenes.bending import clamped_bar

Array = np.ndarray
NAMES = (
    *("time_s", "node_x_m", "node_y_m", "corner_x_m", "corner_y_m", "clamp_left_rad"),
    *("com_x_m", "com_y_m", "com_vx_m_s", "com_vy_m_s"),
    *("node_normal_N", "node_friction_N", "corner_normal_N", "corner_friction_N"),
)


class Bent(NamedTuple):
    """The largest bending strain: at which sample and node, where along the beam (L), and how
    much."""

    sample: int
    node: int
    place: float
    strain: float


@dataclass(frozen=True)
class Poses:
    """M instants of a robot. Lengths in L, times in ms, by the clock of the result."""

    time: Array  # (M,)
    nodes: Array  # (M, N+1, 2) of the beam
    corners: Array | None  # (M, 4, 2): left foot, left top, right top, right foot
    centre: Array | None  # (M, 2) centre of mass

    def outline(self) -> Array:
        """Nodes and corners (M, P, 2)."""
        return self.nodes if self.corners is None else np.hstack([self.nodes, self.corners])


@dataclass(frozen=True)
class Motion(Poses):
    """A sampled motion."""

    length_m: float
    velocity: Array | None  # (2,) of the centre of mass at the last sample, L/ms, if it flies
    gravity: float  # L/ms^2
    slope_rad: float  # of the ground, along and across which x and y are
    turning: float  # rad/ms of the frame in flight
    pad_x: Array  # (M, P) where the ground pushes: centre of pressure of the beam, then corners
    pad_force: Array  # (M, P, 2) friction and normal force there, over the robot's weight
    bent: Bent | None  # None of what has no strain
    # Through air: time (ms) to the apex, and the even acceleration (L/ms^2) that leads there.
    arc: tuple[float, Array] | None = None

    @property
    def count(self) -> int:
        return len(self.time)

    @property
    def weight(self) -> Array:
        """Acceleration (2,) of a free flight, L/ms^2; through air the mean one up to its apex."""
        if self.arc is not None:
            return self.arc[1]
        return -self.gravity * np.array([np.sin(self.slope_rad), np.cos(self.slope_rad)])

    @property
    def rise_ms(self) -> float:
        """Time from the last sample to the highest point against gravity; 0 or less if it falls."""
        if self.velocity is None or self.gravity <= 0.0:
            return 0.0
        if self.arc is not None:
            return self.arc[0]
        return -float(self.velocity @ self.weight) / self.gravity**2

    @property
    def is_beam(self) -> bool:
        return self.nodes.shape[1] > 2

    @property
    def push(self) -> Array:
        """Whole normal force of the ground over the robot's weight (M,)."""
        return self.pad_force[:, :, 1].sum(axis=1)


def finite_samples(arrays: dict[str, Any]) -> dict[str, Array]:
    """The samples at which all arrays (K, ...) are there and finite."""
    data = {name: np.asarray(values, float) for name, values in arrays.items()}
    count = min(len(column) for column in data.values())
    good = np.ones(count, bool)
    for column in data.values():
        good &= np.isfinite(column[:count].reshape(count, -1)).all(axis=1)
    return {name: column[:count][good] for name, column in data.items()}


def read_motion(result: Any) -> Motion | None:
    """The motion of a result, without samples that are not finite; None if none is left."""
    arrays = result.arrays
    if any(np.size(arrays.get(key, ())) == 0 for key in ("time_s", "node_x_m", "node_y_m")):
        return None
    data = finite_samples({name: arrays[name] for name in NAMES if name in arrays})
    if not len(data["time_s"]):
        return None
    length = float(result.simulation.robot.length_m)
    gravity = float(getattr(result.simulation.robot, "gravity_m_s2", 0.0))
    time = 1e3 * data["time_s"]

    def points(name: str, unit: str = "m") -> Array | None:
        """x and y (K, P, 2), lengths in L; None if the result has none."""
        keys = [f"{name}x_{unit}", f"{name}y_{unit}"]
        if not data.keys() >= set(keys):
            return None
        return np.stack([data[key].reshape(len(time), -1) for key in keys], axis=-1) / length

    nodes, corners, centre, speed = (
        *(points(name) for name in ("node_", "corner_", "com_")), points("com_v", "m_s")
    )  # fmt: skip
    assert nodes is not None
    pad_x, pad_force = _pads(data, length, _weight(result))
    return Motion(
        time=time,
        nodes=nodes,
        corners=corners,
        centre=None if centre is None else centre[:, 0],
        length_m=length,
        velocity=None if speed is None or result.status != "ok" else speed[-1, 0] * 1e-3,
        gravity=gravity / length * 1e-6,
        slope_rad=result.simulation.environment.slope_rad,
        turning=0.0 if corners is None else _turning_rate(time, corners),
        pad_x=pad_x,
        pad_force=pad_force,
        bent=_most_bent(data["time_s"], result),
        arc=None if speed is None or centre is None else _arc(result, time[-1], centre, speed),
    )


def poses(motion: Motion, times: Array) -> Poses:
    """Poses at `times` (ms): linear between samples, after them in even acceleration."""
    times = np.maximum(np.asarray(times, float), motion.time[0])
    last = motion.count - 1
    right = np.clip(np.searchsorted(motion.time, times), min(1, last), last)
    left = np.maximum(right - 1, 0)
    step = np.where(right > left, motion.time[right] - motion.time[left], 1.0)
    part = np.clip((times - motion.time[left]) / np.maximum(step, 1e-12), 0.0, 1.0)[:, None]
    centre = moved = None
    after = np.maximum(times - motion.time[-1], 0.0)
    if motion.centre is not None:
        centre = moved = (1.0 - part) * motion.centre[left] + part * motion.centre[right]
    if centre is not None and motion.velocity is not None:
        moved = centre + after[:, None] * (motion.velocity + 0.5 * after[:, None] * motion.weight)

    def placed(points: Array | None) -> Array | None:
        if points is None:
            return None
        shown = (1.0 - part[..., None]) * points[left] + part[..., None] * points[right]
        if centre is None or moved is None or motion.velocity is None:
            return shown
        return _carry(shown, centre, moved, motion.turning * after)

    nodes = placed(motion.nodes)
    assert nodes is not None
    return Poses(times, nodes, placed(motion.corners), moved)


def _carry(points: Array, old: Array, new: Array, angle: Array) -> Array:
    """Turn points (M, P, 2) by `angle` (M,) about `old` (M, 2) and move them along to `new`."""
    cos, sin = np.cos(angle)[:, None], np.sin(angle)[:, None]
    dx, dy = np.moveaxis(points - old[:, None], -1, 0)
    x, y = new[:, :1] + cos * dx - sin * dy, new[:, 1:] + sin * dx + cos * dy
    return np.stack([x, y], axis=-1)


def _most_bent(time_s: Array, result: Any) -> Bent | None:
    """Where and when the beam's outer fibres are strained most, at the nearest sample."""
    strain = result.summary.get("max_strain", np.nan)
    if not np.isfinite(strain):
        return None
    mesh, place = result.simulation.discretization, result.summary["max_strain_at_bar"]
    node = round((place - clamped_bar(mesh)) * mesh.elements)
    sample = int(np.abs(time_s - result.summary["max_strain_time_s"]).argmin())
    return Bent(sample, node, place, strain)


def _arc(result: Any, ended: float, centre: Array, speed: Array) -> tuple[float, Array] | None:
    """A drawn flight through air, so that it meets the apex; None where there is no drag."""
    if result.status != "ok" or result.simulation.drag.absent:
        return None
    rise = 1e3 * float(result.summary["apex_time_s"]) - ended
    if rise <= 0.0:
        return None
    apex = np.array([result.summary["x_bar"], result.summary["y_bar"]])
    missing = apex - centre[-1, 0] - rise * 1e-3 * speed[-1, 0]
    return rise, 2.0 * missing / rise**2


def _turning_rate(time: Array, corners: Array) -> float:
    """Mean turning rate of the frame's top (rad/ms) over the last tenth of the motion."""
    top = np.arctan2(*(corners[:, 2] - corners[:, 1]).T[::-1])
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
