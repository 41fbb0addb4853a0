"""Jumps of robots that are not quite as they are described: all of them simulated, in one batch.

Another member of a family is another program: each has a batch of its own.
"""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np

from snapjump.arrays import Array
from snapjump.batch import Batch, simulate_batch
from snapjump.checks import ParameterError
from snapjump.composition import Simulation, with_tier
from snapjump.declare.inputs import input_at
from snapjump.declare.scenes import Progress
from snapjump.scenes.jump_start import jump_model
from snapjump.uncertainty.parts.as_built import built, nominal, with_error
from snapjump.uncertainty.parts.spread import LESS, MORE, Influence, ModelUncertainty, Side
from snapjump.uncertainty.parts.tolerances import Choice, Tolerance, checked


class Trial(NamedTuple):
    """A side of a row of the table: the robot that is simulated, None where it is refused and
    ``why_not``; ``member``: whether it has another member, and so a program of its own."""

    row: str
    side: str
    value: float | str
    robot: Simulation | None
    why_not: str
    member: bool = False


def check_base(simulation: Simulation) -> None:
    """Raise ParameterError for a simulation that has no apex whose uncertainty could be told."""
    if simulation.sim.name != "jump":
        allowed = f"none with sim={simulation.sim.name}, which has no apex"
        raise ParameterError("uncertainty", "model", allowed)
    built(simulation)


def model_uncertainty(
    simulation: Simulation | str,
    tolerances: Mapping[str, Any] | None = None,
    progress: Progress | None = None,
) -> ModelUncertainty:
    """How far the apex of a jump may be off by its model: each input off by its tolerance, either
    way, simulated.

    ``simulation``, or the name of an accuracy tier; ``tolerances``: beside, or in place of, those
    of :data:`snapjump.uncertainty.parts.tolerances.DEFAULTS`: ``{"environment.mu": {"relative":
    0.1}}``, with ``factor``, ``relative`` or ``absolute`` (in the input's unit), or ``members`` of
    a family; None leaves one out. All but that input is as built
    (:mod:`snapjump.uncertainty.parts.as_built`).

    Raises ParameterError for another scene, a tolerance out of range, or a robot that is refused.
    """
    simulation = with_tier(simulation) if isinstance(simulation, str) else simulation
    return simulated_table(simulation, checked(tolerances), progress)


def simulated_table(
    simulation: Simulation,
    table: Mapping[str, Tolerance | Choice],
    progress: Progress | None = None,
) -> ModelUncertainty:
    """The same by a checked table. Raises ParameterError for a simulation that is refused."""
    check_base(simulation)
    base = built(simulation)
    trials, nominals, left_out = [], {}, {}
    for name, row in table.items():
        present = getattr(base, name).name if isinstance(row, Choice) else nominal(base, name)
        found = trials_of(base, name, row, present)
        if isinstance(found, str):
            left_out[name] = found
        else:
            nominals[name] = present
            trials += found
    apex, numerical, sides = simulated(base, trials, progress)
    influences = [
        Influence(name, present, told(base, name, table[name]), tuple(sides[name]))
        for name, present in nominals.items()
    ]
    return ModelUncertainty(apex, numerical, tuple(influences), left_out, base.robot.length_m)


def trials_of(
    base: Simulation, name: str, row: Tolerance | Choice, present: float | str
) -> list[Trial] | str:
    """The trials of a row; in words why there are none."""
    if isinstance(row, Choice):
        others = [member for member in row.members if member != present]
        return [
            Trial(name, member, member, *able(lambda m=member: replace(base, **{name: m})), True)
            for member in others
        ] or f"{name}={present} is the only one"
    if isinstance(present, str):
        return present
    ends = row.ends(present)
    if ends[0] == ends[1]:
        return "it is 0"
    return [
        Trial(name, side, value, *able(lambda v=value: with_error(base, name, v)))
        for side, value in zip((LESS, MORE), ends, strict=True)
    ]


def able(make: Any) -> tuple[Simulation | None, str]:
    """A robot that can begin a jump; or None, and the line that refuses it."""
    try:
        robot: Simulation = make()
        jump_model(robot)
    except ParameterError as error:
        return None, str(error)
    return robot, ""


def told(base: Simulation, name: str, row: Tolerance | Choice) -> str:
    """A row of the table in words."""
    if isinstance(row, Choice):
        return " or ".join(row.members)
    return row.told(input_at(base, name).unit)


def simulated(
    base: Simulation, trials: Sequence[Trial], progress: Progress | None
) -> tuple[Array, Array, dict[str, list[Side]]]:
    """Apex (2,) of the base and its numerical error (2,), in L; the sides of each row."""
    together = [one.robot for one in trials if one.robot is not None and not one.member]
    batch = simulate_batch([base, *together], progress=progress)
    apex, marched = batch.apexes[0], iter(range(1, len(batch.status)))
    sides: dict[str, list[Side]] = {}
    for one in trials:
        change, why_not = np.full(2, np.nan), one.why_not
        if one.robot is not None:
            place = (simulate_batch([one.robot]), 0) if one.member else (batch, next(marched))
            change, why_not = place[0].apexes[place[1]] - apex, place[0].status[place[1]]
        told_why = "" if why_not == "ok" else why_not
        sides.setdefault(one.row, []).append(Side(one.side, one.value, change, told_why))
    return apex, numerical_error(batch), sides


def numerical_error(batch: Batch) -> Array:
    """Estimated errors (2,) of the first jump's x and y, in L; NaN where they are not known."""
    x, y = batch.apexes[0]
    sizes = np.array([max(abs(x), 0.1 * y), y])
    percents = [batch.x_error_estimate_percent[0], batch.y_error_estimate_percent[0]]
    return 0.01 * sizes * np.array(percents)
