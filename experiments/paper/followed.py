"""Cells of jumps: apexes, and what is seen of the strike, the ground and the energy in time."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from experiments.compositions import composed
from experiments.paper.jumps import jump_rows
from experiments.paper.settings import BASELINE, NAMES
from snapjump.batch import variant
from snapjump.composition import Simulation
from snapjump.declare.members import member_class
from snapjump.results import Result
from snapjump.run.studies.base import Row
from snapjump.simulation import simulate
from snapjump.statics.critical import find_snap

Design = tuple[float, ...]
PATH_INTERVAL_S = 5e-5  # between samples of the centre of mass
STRIKE_INTERVAL_S = 1e-5  # of a strike
LOADING_INTERVAL_S = 1e-4  # of the slow loading before it
# Of full friction: below, the contact is held by the stick zone of the friction law.
SLIDING = 0.99


def varied(name: str, values: Sequence[float], about: Design = BASELINE) -> list[Design]:
    """The baseline, or another design, with these values of one number."""
    place = NAMES.index(name)
    return [(*about[:place], float(value), *about[place + 1 :]) for value in values]


def followed(simulation: Simulation, interval_s: float) -> Result:
    """The jump with its trajectory."""
    scene = simulation.sim.changed(sample_interval_s=interval_s)
    scalar = member_class("backend", "scalar")()
    return simulate(replace(simulation, sim=scene, backend=scalar))


def path_rows(simulation: Simulation) -> list[Row]:
    """The centre of mass from the start of the motion until nothing can touch any more."""
    kept = followed(simulation, PATH_INTERVAL_S).arrays
    length = simulation.robot.length_m
    columns = {
        "time_ms": 1e3 * kept["time_s"],
        "x_bar": kept["com_x_m"] / length,
        "y_bar": kept["com_y_m"] / length,
        "ground_force_N": kept["node_normal_N"].sum(axis=1) + kept["corner_normal_N"].sum(axis=1),
    }
    table = np.stack([*columns.values()], axis=1).tolist()
    return [dict(zip(columns, row, strict=True)) for row in table]


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


def energy_row(simulation: Simulation) -> Row:
    """Shares of what the design's arch, mismatch and all, releases under slow loading (EI/L).

    The rise counts from where the robot stands to the apex; ``turning``: what is left of the
    kinetic energy at lift-off without the centre of mass; ``numerical``: what the integrator
    took. All come to 1 but for the clamps' work and what the beam still holds.
    """
    robot, design = simulation.robot, simulation.design
    snap = find_snap(robot, simulation.discretization, design.epsilon, design.delta_alpha)
    released = snap.before.energy - snap.after.energy
    kept = followed(simulation, STRIKE_INTERVAL_S).arrays
    mass_kg = simulation.environment.mass_kg(robot)
    upward_J, sideways_J = (
        0.5 * mass_kg * float(kept[f"com_v{axis}_m_s"][-1]) ** 2 for axis in "yx"
    )
    climbed_m = float(kept["com_y_m"][-1] - kept["com_y_m"][0])
    parts = {
        "rise": upward_J + mass_kg * robot.gravity_m_s2 * climbed_m,
        "sideways": sideways_J,
        "turning": float(kept["kinetic_J"][-1]) - upward_J - sideways_J,
        **{
            kind: float(kept[f"{kind}_loss_J"][-1]) for kind in ("friction", "damping", "numerical")
        },
    }
    unit_J = released * robot.scales.energy_J
    shares = {f"{name}_share": value / unit_J for name, value in parts.items()}
    return {"energy_released_bar": released, **shares}


def jumps(inputs: Mapping[str, Any]) -> list[Row]:
    """A row for each of the cell's ``designs``."""
    return jump_rows(composed(inputs["groups"]), inputs["designs"])


def paths(inputs: Mapping[str, Any]) -> list[Row]:
    """The paths of the cell's ``designs``, one after the other."""
    base = composed(inputs["groups"])
    return [row for design in inputs["designs"] for row in path_rows(variant(base, design))]


def each(look: Callable[[Simulation], Row], key: str) -> Callable[[Mapping[str, Any]], list[Row]]:
    """What computes a row for each of a cell's ``designs``: one of its numbers, and what a look
    tells."""

    def rows(inputs: Mapping[str, Any]) -> list[Row]:
        base, place = composed(inputs["groups"]), NAMES.index(key)
        return [{key: one[place], **look(variant(base, one))} for one in inputs["designs"]]

    return rows
