"""A made-up jump with the arrays of a real one: an arch flips, strikes, and the frame flies."""

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from snapjump import Design, Environment, Robot

SNAP_S, TOUCH_S, LIFTOFF_S, END_S = 5.0e-3, 5.6e-3, 6.0e-3, 8.0e-3


def smooth_step(value: np.ndarray) -> np.ndarray:
    part = np.clip(value, 0.0, 1.0)
    return part * part * (3.0 - 2.0 * part)


def beam_in_frame(alpha: np.ndarray, flip: np.ndarray, span: float, nodes: int) -> Any:
    """Arch (flip 0) to bowl (flip 1) between clamps `span` apart, unit length: x, y (K, nodes)."""
    s = np.linspace(0.0, 1.0, nodes)
    wave = (1.9 * (1.0 - flip) - 0.15 * flip)[:, None] * np.sin(2.0 * np.pi * s)
    lean = (1.2 * np.sin(np.pi * flip))[:, None] * np.sin(np.pi * s) ** 2
    slope = -alpha[:, None] * np.cos(np.pi * s) + wave + lean
    middle = 0.5 * (slope[:, 1:] + slope[:, :-1])
    zero = np.zeros((len(alpha), 1))
    x = np.hstack([zero, np.cumsum(np.cos(middle), axis=1)]) / (nodes - 1)
    y = np.hstack([zero, np.cumsum(np.sin(middle), axis=1)]) / (nodes - 1)
    x = x - s * (x[:, -1:] - span) - 0.5 * span
    return x, y - s * y[:, -1:]


def make_jump(nodes: int = 65, scene: str = "jump") -> Any:
    robot, design = Robot(), Design()
    length, gravity = robot.length_m, robot.gravity_m_s2
    time = np.union1d(np.arange(0.0, END_S, 4e-5), np.arange(TOUCH_S, LIFTOFF_S, 5e-6))
    span, mount = length * (1.0 - design.epsilon), 0.0736 * length
    air = np.maximum(time - 5.8e-3, 0.0)
    vx, vy, turn = 0.45, 2.3, -60.0
    centre_x, centre_y = vx * air, vy * air - 0.5 * gravity * air**2 + 0.005
    angle = turn * air
    alpha = 0.8 + 20.0 * time
    flip = smooth_step((time - SNAP_S) / (END_S - 2.0e-3 - SNAP_S))
    bx, by = beam_in_frame(alpha, flip, 1.0 - design.epsilon, nodes)
    bx, by = length * bx, length * by + (mount - 0.005)
    cos, sin = np.cos(angle)[:, None], np.sin(angle)[:, None]

    def place(x: np.ndarray, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        return centre_x[:, None] + cos * x - sin * y, centre_y[:, None] + sin * x + cos * y

    node_x, node_y = place(bx, by)
    node_y = np.maximum(node_y, 2e-4)
    half, top = 0.5 * span, robot.frame_height_m - 0.005
    corner_x, corner_y = place(
        np.tile([-half, -half, half, half], (len(time), 1)),
        np.tile([-0.005, top, top, -0.005], (len(time), 1)),
    )
    weight = Environment().mass_kg(robot) * gravity
    pushing = (time > TOUCH_S) & (time < LIFTOFF_S)
    bump = np.where(pushing, np.sin(np.pi * (time - TOUCH_S) / (LIFTOFF_S - TOUCH_S)), 0.0)
    near = np.exp(-(((node_x - node_x.mean(1, keepdims=True)) / (0.1 * length)) ** 2))
    near *= (node_y < 5e-4) / np.maximum(near.sum(1, keepdims=True), 1e-9)
    node_normal = 60.0 * weight * bump[:, None] * near
    standing = np.where(time < TOUCH_S, 0.5 * weight, 0.0)
    corner_normal = np.stack([standing, 0 * standing, 0 * standing, standing], axis=1)
    unit = robot.bending_stiffness_N_m2 / length
    kinetic = unit * (0.02 + 8.0 * flip * (1.0 - 0.3 * smooth_step((time - 6e-3) / 2e-3)))
    elastic = unit * (14.0 - 10.0 * flip + 0.3 * np.sin(4e3 * time) * flip)
    books = {
        "elastic_J": elastic,
        "kinetic_J": kinetic,
        "gravitational_J": weight * centre_y,
        "contact_J": unit * 1.5 * bump,
        "friction_loss_J": unit * 0.4 * smooth_step((time - TOUCH_S) / 4e-4),
        "damping_loss_J": unit * 1.1 * smooth_step((time - SNAP_S) / 2e-3),
        "numerical_loss_J": unit * 0.01 * smooth_step((time - SNAP_S) / 2e-3),
    }
    stored = sum(books[name] for name in list(books)[:4])
    losses = sum(books[name] for name in list(books)[4:])
    books["clamp_work_J"] = stored - stored[0] + losses
    com_vy = np.where(air > 0.0, vy - gravity * air, 0.0)
    com_vx = np.where(air > 0.0, vx, 0.0)
    fall = com_vy[-1] / gravity
    apex_x = centre_x[-1] + com_vx[-1] * fall
    apex_y = centre_y[-1] + 0.5 * com_vy[-1] ** 2 / gravity
    arrays = {
        "time_s": time, "node_x_m": node_x, "node_y_m": node_y, "clamp_left_rad": alpha,
        "clamp_right_rad": alpha - design.delta_alpha, "node_gap_m": node_y,
        "node_normal_N": node_normal, "node_friction_N": -0.3 * node_normal, "corner_x_m": corner_x,
        "corner_y_m": corner_y, "corner_gap_m": corner_y, "corner_normal_N": corner_normal,
        "corner_friction_N": 0.1 * corner_normal, "com_x_m": centre_x, "com_y_m": centre_y,
        "com_vx_m_s": com_vx, "com_vy_m_s": com_vy, **books,
    }  # fmt: skip
    summary = {
        "x_bar": float(apex_x / length),
        "y_bar": float(apex_y / length),
        "liftoff_time_s": LIFTOFF_S,
        "apex_time_s": float(time[-1] + fall),
    }
    simulation = SimpleNamespace(
        sim=SimpleNamespace(name=scene), robot=robot, design=design, environment=Environment()
    )
    return SimpleNamespace(status="ok", summary=summary, arrays=arrays, simulation=simulation)


def make_snap() -> Any:
    result = make_jump(scene="snap")
    drop = ("com_", "corner_", "gravitational", "contact", "friction", "node_gap", "node_n")
    drop += ("node_friction",)
    result.arrays = {k: v for k, v in result.arrays.items() if not k.startswith(drop)}
    result.summary = {"alpha_snap_rad": 0.91, "theta_max_rad": 1.2, "snap_duration_s": 1e-3}
    return result


@pytest.fixture(scope="session")
def jump() -> Any:
    return make_jump()


@pytest.fixture(scope="session")
def snap() -> Any:
    return make_snap()


def of(result: Any, scene: str | None = None, **changes: Any) -> Any:
    """The same result with other arrays, summary or status, perhaps of another scene."""
    parts = {**vars(result), **changes}
    if scene is not None:
        simulation = {**vars(result.simulation), "sim": SimpleNamespace(name=scene)}
        parts["simulation"] = SimpleNamespace(**simulation)
    return SimpleNamespace(**parts)
