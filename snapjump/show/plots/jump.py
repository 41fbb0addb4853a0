"""jump.png and snap.png: what happened, in one picture."""

import pathlib
from typing import Any

from snapjump.checks import is_finite_number
from snapjump.show.plots.filmstrip import draw_filmstrip
from snapjump.show.plots.motion import Motion
from snapjump.show.plots.saving import picture
from snapjump.show.plots.trajectory import draw_trajectory


def finite_number(summary: dict[str, Any], key: str) -> float | None:
    """A finite number of a summary, or None."""
    value = summary.get(key)
    return value if is_finite_number(value) else None


def milliseconds(result: Any, key: str) -> float | None:
    """A time of the summary in ms, or None."""
    value = finite_number(result.summary, key)
    return None if value is None else 1e3 * value


def apex_of(result: Any) -> tuple[float, float] | None:
    """The apex in L, or None if the robot did not jump."""
    if result.status != "ok":
        return None
    x, y = finite_number(result.summary, "x_bar"), finite_number(result.summary, "y_bar")
    return None if x is None or y is None else (x, y)


def headline(result: Any) -> str:
    """A title: scene, design, environment, and the status if it did not end well."""
    simulation = result.simulation
    scene, design, environment = simulation.sim.name, simulation.design, simulation.environment
    parts = []
    if scene in ("jump", "snap", "static"):
        parts.append(f"ε = {design.epsilon:g}")
        parts.append(f"Δα = {design.delta_alpha:.4g} rad")
    if scene in ("jump", "slide"):
        parts.append(f"μ = {environment.mu:g}")
    if scene == "jump":
        parts.append(f"m\u0304 = {environment.mass_bar:g}")
    if scene != "bounce" and scene != "slide":
        parts.append(f"L = {1e3 * simulation.robot.length_m:g} mm")
    if scene == "jump":
        parts.append(f"g = {simulation.robot.gravity_m_s2:g} m/s²")
    text = scene.capitalize() + (":  " + ",  ".join(parts) if parts else "")
    return text if result.status == "ok" else f"{text}   ({result.status})"


def jump_picture(result: Any, motion: Motion, path: pathlib.Path) -> None:
    """Filmstrip and trajectory of a jump."""
    with picture(path, (12.0, 8.0), headline(result)) as figure:
        liftoff = milliseconds(result, "liftoff_time_s")
        draw_filmstrip(figure, motion, liftoff, (0.015, 0.02, 0.63, 0.91))
        axes = figure.add_axes((0.70, 0.07, 0.285, 0.81))
        draw_trajectory(axes, motion, milliseconds(result, "apex_time_s"), apex_of(result))
