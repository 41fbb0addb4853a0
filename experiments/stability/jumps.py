"""Jumps of any compositions: alike ones side by side in lanes, each bounded, each with its fate."""

import time
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

from experiments.compositions import composed
from snapjump.batch import simulate_batch
from snapjump.checks import ParameterError
from snapjump.composition import Simulation
from snapjump.parameters.design import Design
from snapjump.parameters.environment import Environment
from snapjump.scenes.jump_start import jump_model
from snapjump.studies.base import Row

LANES = 8
REFUSED = "refused"
KNOWN = ("ok", "no_jump")
KEPT = (
    "status",
    "x_bar",
    "y_bar",
    "min_gap_m",
    "newton_iterations",
    "error_sum_bar",
    "coarsest_contact_step",
    "x_error_estimate_percent",
    "y_error_estimate_percent",
    "within_tier",
)


def jump_rows(
    points: Sequence[Mapping[str, Any]],
    designs: Sequence[Sequence[float]],
    most_iterations: float,
) -> list[Row]:
    """A row for each point and design: inputs, status, apex, smallest gap, cost and estimate.

    A point has ``across``, ``up`` and the ``groups`` of its composition. What is refused, or
    cannot begin, has the status ``refused`` and says why. Points of the same composition but for
    numbers of the model are simulated together; ``seconds`` is such a batch's wall time.
    """
    rows: list[Row] = []
    waiting: dict[Any, list[tuple[int, Simulation]]] = {}
    for point in points:
        for k, design in enumerate(designs or [()]):
            row: Row = {"across": point["across"], "up": point["up"], "design": k}
            try:
                simulation = with_design(composed(point["groups"]), design)
                jump_model(simulation)
            except ParameterError as error:
                row |= {"status": REFUSED, "message": str(error)}
            else:
                waiting.setdefault(alike(simulation), []).append((len(rows), simulation))
            rows.append(row)
    for batch in waiting.values():
        places = [place for place, _ in batch]
        outcomes = batch_rows([simulation for _, simulation in batch], most_iterations)
        for place, outcome in zip(places, outcomes, strict=True):
            rows[place] |= outcome
    return rows


def with_design(simulation: Simulation, design: Sequence[float]) -> Simulation:
    """With another (delta_alpha, epsilon, m_bar, mu), if one is given."""
    if not design:
        return simulation
    lag, epsilon, mass_bar, mu = design
    return replace(
        simulation,
        design=Design(epsilon=epsilon, delta_alpha=lag),
        environment=Environment(mu=mu, mass_bar=mass_bar),
    )


def alike(simulation: Simulation) -> Any:
    """What jumps must share to be simulated side by side: all but numbers of the model."""
    robot = simulation.robot
    return (
        simulation.integrator,
        simulation.stepping,
        simulation.discretization,
        simulation.sim,
        simulation.accuracy,
        robot.scales,
        *(getattr(simulation, f).name for f in ("contact", "friction", "damping", "frame")),
    )


def batch_rows(simulations: Sequence[Simulation], most_iterations: float) -> list[Row]:
    """What became of each."""
    begun = time.perf_counter()
    batch = simulate_batch(simulations, LANES, most_iterations)
    seconds = time.perf_counter() - begun
    return [{**row, "seconds": seconds} for row in batch.rows(*KEPT)]
