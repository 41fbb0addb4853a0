"""Jumps of any compositions: alike ones side by side in lanes, each bounded, each with its fate."""

import time
from collections import Counter
from collections.abc import Mapping, Sequence
from typing import Any

from snapjump.batch import simulate_batch, variant
from snapjump.batch.alike import OF_ONE_KIND, SAME
from snapjump.checks import ParameterError
from snapjump.composition import Simulation
from snapjump.declare.inputs import DEFAULT_INPUTS
from snapjump.run.studies.base import REFUSED, Row
from snapjump.scenes.jump_start import jump_model

from ..compositions import composed

LANES = 8
INPUTS = (*DEFAULT_INPUTS, "environment.slope_rad")  # of designs, which may end before the last
KEPT = (
    "status", "x_bar", "y_bar", "min_gap_m", "newton_iterations", "error_sum_bar",
    "coarsest_contact_step", "x_error_estimate_percent", "y_error_estimate_percent", "within_tier",
)  # fmt: skip


def jump_rows(
    points: Sequence[Mapping[str, Any]], designs: Sequence[Sequence[float]], most_iterations: float
) -> list[Row]:
    """A row for each point and design: inputs, status, apex, smallest gap, cost and estimate.

    A point has ``across``, ``up`` and the ``groups`` of its composition. What is refused, or
    cannot begin, has the status ``refused`` and says why. Points of the same composition but for
    numbers of the model are simulated together; ``seconds`` is such a batch's wall time.
    """
    rows: list[Row] = []
    waiting: dict[Any, list[tuple[Row, Simulation]]] = {}
    for point in points:
        for k, design in enumerate(designs or [()]):
            row: Row = {"across": point["across"], "up": point["up"], "design": k}
            rows.append(row)
            try:
                simulation = composed(point["groups"])
                if design:
                    simulation = variant(simulation, design, INPUTS[: len(design)])
                jump_model(simulation)
            except ParameterError as error:
                row |= {"status": REFUSED, "message": str(error)}
            else:
                waiting.setdefault(alike(simulation), []).append((row, simulation))
    for together in waiting.values():
        begun = time.perf_counter()
        batch = simulate_batch([one for _, one in together], LANES, most_iterations)
        seconds = time.perf_counter() - begun
        for (row, _), outcome in zip(together, batch.rows(*KEPT), strict=True):
            row |= {**outcome, "seconds": seconds}
    return rows


def alike(simulation: Simulation) -> Any:
    """The key that jumps side by side must share: all but numbers of the model."""
    return (
        simulation.accuracy,
        simulation.robot.scales,
        *(getattr(simulation, family) for family in SAME),
        *(type(getattr(simulation, family)) for family in OF_ONE_KIND),
    )


def by_status(rows: Sequence[Row]) -> Counter[str]:
    """Counts by status, in the order in which they first come."""
    return Counter(row["status"] for row in rows)
