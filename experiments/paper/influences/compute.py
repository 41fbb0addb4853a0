"""Sweeps of jumps: of the designs' four numbers, and of the mounts' height; and the statics."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from experiments.compositions import composed
from experiments.paper.jumps import LANES, THREADS, batch_rows, jump_rows
from experiments.paper.settings import BASELINE, NAMES
from snapjump.batch import simulate_batch, variant
from snapjump.composition import Simulation
from snapjump.declare.members import member_class
from snapjump.results import Result
from snapjump.run.studies.base import Row
from snapjump.simulation import simulate
from snapjump.statics.critical import find_snap
from snapjump.statics.threshold import symmetric_threshold

MOUNT_HEIGHT = "mount_height_bar"


@dataclass(frozen=True)
class Sweep:
    """``count`` values from ``first`` to ``last``; every ``stride``-th of them at reference."""

    first: float
    last: float
    count: int
    stride: int
    label: str

    def values(self, stride: int = 1) -> list[float]:
        """The places, clean of rounding, so that a coarse sweep has places of the fine one."""
        places = np.linspace(self.first, self.last, self.count)[::stride]
        return [float(value) for value in places.round(9)]


SWEEPS = {
    MOUNT_HEIGHT: Sweep(0.01, 0.34, 133, 4, "mount height h / L"),
    "epsilon": Sweep(0.1, 0.3, 81, 4, "pre-compression ε"),
    "delta_alpha_rad": Sweep(0.0, 0.3, 101, 4, "mismatch Δα (rad)"),
    "mu": Sweep(0.0, 1.0, 101, 4, "friction coefficient μ"),
    "mass_bar": Sweep(0.3, 2.0, 86, 5, "mass m̄"),
}
# Of these the contact is looked into: friction against which way the beam slides, and how the
# ground bears the beam before it snaps.
SLIDING_MU = (0.1, 0.2, 0.25, 0.3, 0.45, 0.6)
PRESSED_HEIGHTS = (0.03, 0.05, 0.07, 0.15)
# Of these the energy is followed: the ends of the paper's range, and the baseline.
ENERGY_MASSES = (0.3, 0.768, 2.0)


# Mounts below the depth of the arch at a later start would put it into the ground.
FROM_FLAT = 0.0


def rows_of(inputs: Mapping[str, Any]) -> list[Row]:
    """A row for each value of what is varied."""
    base = variant(composed(inputs["groups"]), BASELINE)
    kind, values = inputs["kind"], inputs["values"]
    if kind == "statics":
        return [statics_row(base)]
    if kind == "sliding":
        return [{"mu": mu, **sliding_row(variant(base, (*BASELINE[:3], mu)))} for mu in values]
    if kind == "energies":
        masses = [variant(base, (*BASELINE[:2], m, BASELINE[3])) for m in values]
        return [{"mass_bar": m, **energy_row(one)} for m, one in zip(values, masses, strict=True)]
    if kind == "pressed":
        return [{MOUNT_HEIGHT: h, **pressed_row(mounted(base, h))} for h in values]
    if kind == MOUNT_HEIGHT:
        batch = simulate_batch([mounted(base, h) for h in values], LANES, threads=THREADS)
        rows = batch_rows(batch)
        return [{MOUNT_HEIGHT: h, **row} for h, row in zip(values, rows, strict=True)]
    place = NAMES.index(kind)
    return jump_rows(base, [(*BASELINE[:place], v, *BASELINE[place + 1 :]) for v in values])


def mounted(base: Simulation, height_bar: float) -> Simulation:
    """The robot with its clamps at another height (in L), turning from flat: a beam that reaches
    below low mounts would start in the ground."""
    robot = replace(base.robot, mount_height=height_bar * base.robot.length_m)
    return replace(base, robot=robot, sim=base.sim.changed(start_fraction=FROM_FLAT))


def statics_row(base: Simulation) -> Row:
    """Heights and energies (EI/L) of the baseline's arch under slow loading.

    h1: depth of the lowest point as it loses stability; h2: depth of the lowest point, and of the
    middle, of the arch that has snapped; both with clamps that turn alike."""
    robot, mesh, epsilon = base.robot, base.discretization, base.design.epsilon
    snap = find_snap(robot, mesh, epsilon, 0.0)
    return {
        "h1_bar": symmetric_threshold(robot, mesh, epsilon).h1_bar,
        "h2_bar": -snap.after.lowest,
        "h2_middle_bar": snap.h2_bar,
        "alpha_critical_rad": snap.alpha_rad,
        "energy_released_bar": snap.before.energy - snap.after.energy,
    }


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
    vx, vy = float(kept["com_vx_m_s"][-1]), float(kept["com_vy_m_s"][-1])
    climbed_m = float(kept["com_y_m"][-1] - kept["com_y_m"][0])
    upward_J = 0.5 * mass_kg * vy**2
    sideways_J = 0.5 * mass_kg * vx**2
    parts = {
        "rise": upward_J + mass_kg * robot.gravity_m_s2 * climbed_m,
        "sideways": sideways_J,
        "turning": float(kept["kinetic_J"][-1]) - upward_J - sideways_J,
        "friction": float(kept["friction_loss_J"][-1]),
        "damping": float(kept["damping_loss_J"][-1]),
        "numerical": float(kept["numerical_loss_J"][-1]),
    }
    return {
        "energy_released_bar": released,
        **{f"{name}_share": value / (released * robot.scales.energy_J)
           for name, value in parts.items()},
    }  # fmt: skip
