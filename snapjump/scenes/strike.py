"""What a jump that is followed in time tells of its loading, its strike and its energy.

Of results whose trajectory was kept (``sim.sample_interval_s``): a strike asks for samples every
1e-5 s, the slow loading before it for every 1e-4 s.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from snapjump.results import Result

# Of full friction: below, the contact is held by the stick zone of the friction law.
SLIDING = 0.99


def centre_of_mass(result: Result) -> dict[str, NDArray[np.float64]]:
    """The way of the centre of mass in L, by its time (ms), with the ground's force on the robot,
    until nothing can touch any more."""
    kept, length_m = result.arrays, result.simulation.robot.length_m
    return {
        "time_ms": 1e3 * kept["time_s"],
        "x_bar": kept["com_x_m"] / length_m,
        "y_bar": kept["com_y_m"] / length_m,
        "ground_force_N": kept["node_normal_N"].sum(axis=1) + kept["corner_normal_N"].sum(axis=1),
    }


def sliding(result: Result) -> dict[str, float]:
    """Shares of the beam's normal impulse under which it slides back (friction drives the robot
    on), slides on (friction brakes it) and sticks; and the friction's net share of the impulse."""
    kept = result.arrays
    steps = np.gradient(kept["time_s"])[:, None]
    normal, drag = kept["node_normal_N"], kept["node_friction_N"]
    full = np.abs(drag) >= SLIDING * result.simulation.environment.mu * normal
    impulse = float((normal * steps).sum())

    def share(chosen: Any) -> float:
        return float((np.where(chosen, normal, 0.0) * steps).sum()) / impulse

    return {
        "driving_share": share(full & (drag > 0.0)),
        "braking_share": share(full & (drag < 0.0)),
        "sticking_share": share(~full),
        "friction_over_normal": float((drag * steps).sum()) / impulse,
    }


def pressed(result: Result) -> dict[str, float]:
    """The ground under the beam until its middle passes the clamps: the largest load it bears
    (over the weight), how far it has lifted the feet, and the leading clamp's angle then."""
    kept, robot = result.arrays, result.simulation.robot
    heights = kept["node_y_m"]
    middle = heights[:, heights.shape[1] // 2]
    passed = int(np.flatnonzero(middle < 0.5 * (heights[:, 0] + heights[:, -1]))[0])
    weight_N = result.simulation.environment.mass_kg(robot) * robot.gravity_m_s2
    feet = kept["corner_y_m"].min(axis=1)
    return {
        "load_over_weight": float(kept["node_normal_N"][:passed].sum(axis=1).max()) / weight_N,
        "lift_bar": float(feet[:passed].max() - feet[0]) / robot.length_m,
        "alpha_snap_rad": float(kept["clamp_left_rad"][passed]),
    }


def energy_shares(result: Result, released_bar: float) -> dict[str, float]:
    """Where an energy (EI/L), as that of a slow snap, has gone by the end, in shares of it.

    The rise counts from where the robot stands to the apex; ``turning``: what is left of the
    kinetic energy at lift-off without the centre of mass; ``numerical``: what the integrator
    took. All come to 1 but for the clamps' work and what the beam still holds.
    """
    kept, robot = result.arrays, result.simulation.robot
    mass_kg = result.simulation.environment.mass_kg(robot)
    sideways_J, upward_J = (
        0.5 * mass_kg * float(kept[f"com_v{axis}_m_s"][-1]) ** 2 for axis in "xy"
    )
    climbed_m = float(kept["com_y_m"][-1] - kept["com_y_m"][0])
    parts_J = {
        "rise": upward_J + mass_kg * robot.gravity_m_s2 * climbed_m,
        "sideways": sideways_J,
        "turning": float(kept["kinetic_J"][-1]) - upward_J - sideways_J,
        **{
            kind: float(kept[f"{kind}_loss_J"][-1]) for kind in ("friction", "damping", "numerical")
        },
    }
    unit_J = released_bar * robot.scales.energy_J
    return {f"{name}_share": value / unit_J for name, value in parts_J.items()}
