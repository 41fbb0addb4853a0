"""Cells that parts share: jumps as rows, jumps that are followed in time, and the forward model."""

import hashlib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import cache
from typing import Any

import numpy as np

from snapjump.batch import Batch, simulate_designs, variant
from snapjump.composition import Simulation
from snapjump.declare.members import member_class
from snapjump.engine import status
from snapjump.results import Result
from snapjump.run.studies.base import Row, column
from snapjump.scenes import strike
from snapjump.simulation import simulate
from snapjump.statics.critical import find_snap

from ..compositions import composed
from .settings import BASELINE, NAMES

# Results depend on neither: eight lanes are a tier's own program, and a second thread halves time.
LANES, THREADS = 8, 2
KEPT = (
    "status",
    "x_bar",
    "y_bar",
    "liftoff_x_bar",
    "liftoff_y_bar",
    "liftoff_vx_m_s",
    "liftoff_vy_m_s",
    "min_gap_m",
    "newton_iterations",
)


def batch_rows(batch: Batch) -> list[Row]:
    """A row for each jump: status, apex and lift-off of the centre of mass, smallest gap, cost."""
    return batch.rows(*KEPT)


def jump_rows(simulation: Simulation, designs: Sequence[Any], lanes: int = LANES) -> list[Row]:
    """The same of designs (delta_alpha, epsilon, mass_bar, mu), with these four numbers."""
    table = np.asarray(designs, dtype=float)
    batch = simulate_designs(simulation, table, lanes=lanes, threads=THREADS)
    return [
        {**dict(zip(NAMES, design, strict=True)), **row}
        for design, row in zip(table.tolist(), batch_rows(batch), strict=True)
    ]


def furthest(rows: Sequence[Row], others: Sequence[Row], key: str, place: str) -> float:
    """The largest difference of a column between rows that agree in another column."""
    known = dict(zip(column(others, place).round(9), column(others, key), strict=True))
    pairs = zip(column(rows, place).round(9), column(rows, key), strict=True)
    return float(np.nanmax([abs(value - known[at]) for at, value in pairs if at in known]))


def apart(sweep: Mapping[str, Sequence[Row]], place: str) -> tuple[float, float]:
    """The largest differences of x and of y between standard and reference, where both are."""
    x, y = (furthest(sweep["standard"], sweep["reference"], k, place) for k in ("x_bar", "y_bar"))
    return x, y


def apexes_of(rows: Sequence[Row]) -> Any:
    """Apexes (R, 2) in L, NaN unless the robot jumps."""
    apexes = np.stack([column(rows, "x_bar"), column(rows, "y_bar")], axis=-1)
    apexes[[row["status"] != status.NAMES[status.OK] for row in rows]] = np.nan
    return apexes


Design = tuple[float, ...]
# Between samples: of a strike, of the way up, and of the slow loading before the snap.
STRIKE_S, PATH_S, LOADING_S = 1e-5, 5e-5, 1e-4


def varied(name: str, values: Sequence[float], about: Design = BASELINE) -> list[Design]:
    """The baseline, or another design, with these values of one number."""
    place = NAMES.index(name)
    return [(*about[:place], float(value), *about[place + 1 :]) for value in values]


def followed(simulation: Simulation, interval_s: float) -> Result:
    """The jump with its trajectory."""
    scene = simulation.sim.changed(sample_interval_s=interval_s)
    scalar = member_class("backend", "scalar")()
    return simulate(replace(simulation, sim=scene, backend=scalar))


def jumps(inputs: Mapping[str, Any]) -> list[Row]:
    """A row for each of the cell's ``designs``."""
    return jump_rows(composed(inputs["groups"]), inputs["designs"])


def path(inputs: Mapping[str, Any]) -> list[Row]:
    """The way of the centre of mass of the only one of the cell's ``designs``."""
    (design,) = inputs["designs"]
    robot = variant(composed(inputs["groups"]), design)
    columns = strike.centre_of_mass(followed(robot, PATH_S))
    values = (one.tolist() for one in columns.values())
    return [dict(zip(columns, row, strict=True)) for row in zip(*values, strict=True)]


def sliding_row(robot: Simulation) -> Row:
    """Which way the beam slides."""
    return strike.sliding(followed(robot, STRIKE_S))


def energy_row(robot: Simulation) -> Row:
    """What the design's arch, mismatch and all, releases under slow loading (EI/L), and shares."""
    design = robot.design
    snap = find_snap(robot.robot, robot.discretization, design.epsilon, design.delta_alpha)
    released = snap.before.energy - snap.after.energy
    shares = strike.energy_shares(followed(robot, STRIKE_S), released)
    return {"energy_released_bar": released, **shares}


def each(look: Callable[[Simulation], Row], key: str) -> Callable[[Mapping[str, Any]], list[Row]]:
    """What computes a row for each of a cell's ``designs``: one of its numbers, and what a look
    tells."""

    def rows(inputs: Mapping[str, Any]) -> list[Row]:
        base, place = composed(inputs["groups"]), NAMES.index(key)
        return [{key: one[place], **look(variant(base, one))} for one in inputs["designs"]]

    return rows


@cache
def shipped_forward() -> Any:
    """The forward model."""
    from snapjump.learning import STANDARD
    from snapjump.learning.forward_model import forward_model

    return forward_model(STANDARD)


def shipped_inputs(groups: Mapping[str, Any]) -> dict[str, str]:
    """Inputs of a cell that asks it: the hash of its file.

    Raises ParameterError if it was trained with another physical model than the groups'.
    """
    from snapjump.learning import STANDARD

    shipped_forward().check_model(composed(groups))
    return {"checkpoint_sha256": hashlib.sha256(STANDARD.read_bytes()).hexdigest()}
