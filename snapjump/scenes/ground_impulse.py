"""Impulse of the ground on a robot: what its momentum has gained, less what weight and drag gave.

Sums of forces would do as well across the ground, but not along it: friction that holds a point
changes within its stick zone by what Newton's method leaves of a velocity. Added up at every stage
with the integrator's own weights, friction comes out 6, 31 and 0.1 % off for three designs at
draft, 7, 16 and 0.03 % at standard, 0.8, 1.6 and 0.0005 % at reference; normal forces to 1e-7.
"""

from typing import Any

import numpy as np
from scipy.integrate import cumulative_trapezoid

from snapjump.arrays import Array
from snapjump.engine.centre_of_mass import centre_of_mass
from snapjump.scenes.runner import March


def momentum_gained(model: Any, time: Any, risen: Any, faster: Any) -> Any:
    """What the ground, and drag, have given a robot of momentum across the ground, over its mass
    (L/T), when it has risen (L) and become faster (L/T) so much in a time (T)."""
    return faster + model.damping.drag() * risen + model.load.gravity() * time


def impulse_arrays(
    march: March, times: Array, states: Array, velocities: Array
) -> dict[str, Array]:
    """Impulses (S), in N s, since the start and all points together, along and across the ground.

    states, velocities (S, D) at times (S). They balance the momentum of the samples to rounding,
    and are as accurate as its velocity; what the air takes is added up between samples.
    """
    model, scales = march.models[0], march.scales
    x, y, vx, vy = centre_of_mass(model, march.masses, march.mesh, states.T, velocities.T)
    mass_kg = (model.frame.whole_mass(march.mesh) + np.sum(march.masses)) * scales.mass_kg
    drag, load = model.damping.drag(), model.load
    along = vx - vx[0] + drag * (x - x[0]) - load.pull() * times
    across = momentum_gained(model, times, y - y[0], vy - vy[0])
    if model.drag.exists():
        air = np.array([model.drag.acceleration(*v) for v in zip(vx, vy, strict=True)])
        gained = cumulative_trapezoid(air, times, axis=0, initial=0.0)
        along, across = along - gained[:, 0], across - gained[:, 1]
    return {
        "ground_impulse_x_N_s": along * scales.velocity_m_s * mass_kg,
        "ground_impulse_y_N_s": across * scales.velocity_m_s * mass_kg,
    }
