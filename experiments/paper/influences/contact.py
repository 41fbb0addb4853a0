"""What happens where the beam touches the ground: who slides which way, and who bears the robot."""

from dataclasses import replace

import numpy as np

from snapjump.composition import Simulation
from snapjump.declare.members import member_class
from snapjump.results import Result
from snapjump.simulation import simulate
from snapjump.studies.base import Row

STRIKE_INTERVAL_S = 1e-5  # between samples of a strike
LOADING_INTERVAL_S = 1e-4  # between samples of the slow loading before it
# Of full friction: below, the contact is held by the stick zone of the friction law.
SLIDING = 0.99


def followed(simulation: Simulation, interval_s: float) -> Result:
    """The jump with its trajectory."""
    scene = simulation.sim.changed(sample_interval_s=interval_s)
    scalar = member_class("backend", "scalar")()
    return simulate(replace(simulation, sim=scene, backend=scalar))


def sliding_row(simulation: Simulation) -> Row:
    """Shares of the beam's normal impulse under which it slides back (friction drives the robot
    on), slides on (friction brakes it) and sticks; and the friction's net share of the impulse."""
    kept = followed(simulation, STRIKE_INTERVAL_S).arrays
    steps = np.gradient(kept["time_s"])[:, None]
    normal, drag = kept["node_normal_N"], kept["node_friction_N"]
    full = np.abs(drag) >= SLIDING * simulation.environment.mu * normal
    impulse = float((normal * steps).sum())

    def share(chosen: np.ndarray) -> float:
        return float((np.where(chosen, normal, 0.0) * steps).sum()) / impulse

    return {
        "driving_share": share(full & (drag > 0.0)),
        "braking_share": share(full & (drag < 0.0)),
        "sticking_share": share(~full),
        "friction_over_normal": float((drag * steps).sum()) / impulse,
    }


def pressed_row(simulation: Simulation) -> Row:
    """The ground under the beam until its middle passes the clamps: the largest load it bears
    (over the weight), how far it has lifted the feet, and the leading clamp's angle then."""
    result = followed(simulation, LOADING_INTERVAL_S)
    kept, robot = result.arrays, simulation.robot
    heights = kept["node_y_m"]
    middle = heights[:, heights.shape[1] // 2]
    passed = int(np.flatnonzero(middle < 0.5 * (heights[:, 0] + heights[:, -1]))[0])
    weight = simulation.environment.mass_kg(robot) * robot.gravity_m_s2
    feet = kept["corner_y_m"].min(axis=1)
    return {
        "load_over_weight": float(kept["node_normal_N"][:passed].sum(axis=1).max()) / weight,
        "lift_bar": float(feet[:passed].max() - feet[0]) / robot.length_m,
        "alpha_snap_rad": float(kept["clamp_left_rad"][passed]),
    }
