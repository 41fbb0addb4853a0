"""Jumps of a robot of a given mass, as high as they are, and what air would take from them."""

import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from scipy.stats import qmc

from snapjump.batch import simulate_batch, variant, variants
from snapjump.composition import Simulation
from snapjump.run.studies.base import Row

from ...compositions import composed

LANES, THREADS = 8, 2
# Drag coefficient of a plate, density of air (kg/m^3).
COEFFICIENT, AIR_KG_M3 = 1.2, 1.2
# What is not known of the source's robot, and between which values it is tried.
UNKNOWN = {
    "design.epsilon": (0.1, 0.3),
    "robot.thickness_m": (3.5e-5, 7.5e-5),
    "damping.relaxation_time_s": (1e-7, 1e-5),
    "frame.mass_centre_height_m": (3e-3, 1e-2),
}
LOGARITHMIC = ("damping.relaxation_time_s",)
MASS = "environment.mass_bar"


def height_rows(inputs: Mapping[str, Any]) -> list[Row]:
    """A row for each pre-compression."""
    return weighed(inputs, [[epsilon] for epsilon in inputs["epsilons"]], ["design.epsilon"])


def band_rows(inputs: Mapping[str, Any]) -> list[Row]:
    """The same of a Sobol sequence over all that is unknown."""
    points = qmc.Sobol(len(UNKNOWN), rng=inputs["seed"]).random(inputs["count"])
    rows = [[between(path, share) for path, share in zip(UNKNOWN, point, strict=True)]
            for point in points]  # fmt: skip
    return weighed(inputs, rows, [*UNKNOWN])


def single_rows(inputs: Mapping[str, Any]) -> list[Row]:
    """The same at either end of one unknown, the others as they are configured."""
    return [
        {"unknown": path, "value": value, **row}
        for path in UNKNOWN
        for value in UNKNOWN[path]
        for row in weighed(inputs, [[value]], [path])
    ]


def weighed(
    inputs: Mapping[str, Any], rows: Sequence[Sequence[float]], paths: Sequence[str]
) -> list[Row]:
    """Jumps of these variants, all of the mass, whatever their beams."""
    base = composed(inputs["groups"])
    masses = [mass_bar(variant(base, row, paths), inputs["mass_kg"]) for row in rows]
    heavy = [(*row, mass) for row, mass in zip(rows, masses, strict=True)]
    return jumped(base, heavy, (*paths, MASS))


def between(path: str, share: float) -> float:
    """A value of an unknown, by its share of the way from the least to the largest."""
    low, high = UNKNOWN[path]
    if path in LOGARITHMIC:
        return float(math.exp(math.log(low) + share * math.log(high / low)))
    return float(low + share * (high - low))


def mass_bar(simulation: Simulation, mass_kg: float) -> float:
    """A mass as m g L^2/EI of the simulation's robot."""
    robot = simulation.robot
    return mass_kg * robot.gravity_m_s2 * robot.length_m**2 / robot.bending_stiffness_N_m2


def jumped(base: Simulation, rows: Sequence[Sequence[float]], paths: Sequence[str]) -> list[Row]:
    """Of each variant its inputs, status and heights (m): the apex, and that with the drag of a
    plate, upwards from where the robot leaves the ground."""
    robots = variants(base, rows, paths)
    batch = simulate_batch(robots, LANES, threads=THREADS)
    kept = batch.rows("status", "y_bar", "liftoff_y_bar", "liftoff_vy_m_s")
    found = []
    for robot, row, one in zip(robots, rows, kept, strict=True):
        length = robot.robot.length_m
        plate = robot.robot.width_m * length * (1.0 - robot.design.epsilon)
        begun, speed = one["liftoff_y_bar"] * length, one["liftoff_vy_m_s"]
        gravity, mass = robot.robot.gravity_m_s2, robot.environment.mass_kg(robot.robot)
        found.append(
            {
                **dict(zip(paths, map(float, row), strict=True)),
                "status": one["status"],
                "height_m": one["y_bar"] * length,
                "with_drag_m": begun + risen(speed, gravity, mass, plate),
                "liftoff_vy_m_s": speed,
            }
        )
    return found


def risen(speed_m_s: float, gravity_m_s2: float, mass_kg: float, area_m2: float) -> float:
    """How high (m) a body flies that is thrown upwards, against quadratic drag: with k half of
    density, coefficient and area, m / 2k log(1 + k v^2 / m g)."""
    k = 0.5 * AIR_KG_M3 * COEFFICIENT * area_m2
    return float(mass_kg / (2.0 * k) * np.log1p(k * speed_m_s**2 / (mass_kg * gravity_m_s2)))
