"""Jumps of the same designs with other settings, and how far a frame gives way."""

from collections.abc import Mapping
from typing import Any

from experiments.compositions import composed
from experiments.paper.jumps import jump_rows
from snapjump.batch import variants
from snapjump.scenes.jump_march import jump_march
from snapjump.scenes.jump_start import jump_model
from snapjump.studies.base import Row


def rows_of(inputs: Mapping[str, Any]) -> list[Row]:
    """A row for each design: its jump, or, where that is asked for, its start.

    Results do not depend on ``lanes``; one lane compiles faster, for a program that few jumps are
    made with."""
    base = composed(inputs["groups"])
    if inputs.get("kind") == "starts":
        return [start_row(one) for one in variants(base, inputs["designs"])]
    return jump_rows(base, inputs["designs"], inputs["lanes"])


def start_row(simulation: Any) -> Row:
    """The equilibrium that the motion starts from: the clear span between the beam's ends (L)."""
    model = jump_model(simulation)
    march = jump_march([simulation], [model])
    march.find_starts()
    nodes = march.queue.state[0, model.frame.dofs(march.mesh) :]
    x, y = nodes[:: model.discretization.node_dofs()], nodes[1 :: model.discretization.node_dofs()]
    span = float(((x[-1] - x[0]) ** 2 + (y[-1] - y[0]) ** 2) ** 0.5)
    return {"clear_span_bar": span, "epsilon_left": 1.0 - span}
