"""The linear system of an iteration: assembled and solved, node by node, in one sweep and back.

A node is eliminated as soon as it is complete. With a program of its own the rows of nodes that no
clamp reaches go no further than registers; the results are the same to the last bit.
"""

from typing import Any, NamedTuple

from snapjump.contact.base import Extremes
from snapjump.discretization.base import NODES_COUPLED
from snapjump.engine.assemble import (
    Motion,
    Sweep,
    add_node,
    assemble_nodes,
    begin_assembly,
    end_assembly,
)
from snapjump.linear_solver.banded import (
    Elimination,
    begin_elimination,
    eliminate_columns,
    eliminate_node,
    substitute_back,
)
from snapjump.linear_solver.banded_rotations import (
    eliminate_rotating_node,
    substitute_back_rotating,
)
from snapjump.linear_solver.contact_rows import NodeRows
from snapjump.number.dispatch import kernel, routine
from snapjump.number.functions import absolute, maximum
from snapjump.number.nowhere import nowhere
from snapjump.number.own_rows import own_rows

ENDS = NODES_COUPLED + 1  # nodes at either end whose columns a clamp's own node reaches


class Solution(NamedTuple):
    """Figures of a solved system: those of its assembly, the largest residual (EI/L^2) and
    correction (L), and the number of pivots that are not positive."""

    extremes: Extremes
    residual: Any
    correction: Any
    negative_pivots: Any


@kernel
def largest_of(values: Any, count: Any, largest: Any) -> Any:
    """The largest absolute value of the first few, or ``largest`` if that is larger."""
    for k in range(count):
        largest = maximum(largest, absolute(values[k]))
    return largest


@kernel
def turns(model: Any) -> Any:
    """Whether nodes have three coordinates; a constant while compiling."""
    return model.discretization.node_dofs() == 3


@kernel
def bordered(model: Any) -> Any:
    """Whether the beam is condensed onto a frame's coordinates; a constant while compiling."""
    return model.frame.border_width() > 0


@routine
def eliminate_nodes(model: Any, work: Any, first: Any, end: Any, done: Elimination) -> Elimination:
    """Eliminate nodes from ``first`` up to ``end``, which stand in memory."""
    for node in range(first, end):
        if turns(model):
            done = eliminate_rotating_node(work, node, bordered(model), done)
        else:
            done = eliminate_node(work, node, bordered(model), done)
    return done


@routine
def finish_solution(model: Any, work: Any, sweep: Sweep, done: Elimination) -> Solution:
    """Solve for the frame and then, backwards, for the nodes."""
    dofs = model.frame.dofs(work.mesh)
    zero = 0.0 * done.largest
    residual = done.largest
    negative = done.negative
    correction = zero
    if bordered(model):
        residual = largest_of(work.frame_residual, dofs, residual)
        negative = negative + model.frame.solve(work, done)
        correction = largest_of(work.frame_residual, dofs, correction)
    remains = model.frame.border_width() == 3
    if turns(model):
        correction = maximum(correction, substitute_back_rotating(work, remains, zero))
    else:
        correction = maximum(correction, substitute_back(work, remains, zero))
    return Solution(end_assembly(sweep), residual, correction, negative)


@routine
def solve_linearised(model: Any, motion: Motion, masses: Any, work: Any) -> Solution:
    """Assemble the system in memory and solve it; a node may be eliminated when the next two have
    been assembled."""
    nodes = masses.shape[0]
    sweep = begin_assembly(model, motion, masses, work)
    done = begin_elimination(0.0 * motion.rate_factor)
    sweep = assemble_nodes(model, motion, masses, work, 0, nodes, sweep)
    done = eliminate_nodes(model, work, 0, nodes, done)
    return finish_solution(model, work, sweep, done)


@routine
def solve_in_registers(model: Any, motion: Motion, masses: Any, work: Any) -> Solution:
    """:func:`solve_linearised` with nodes between the ends that never stand in memory."""
    nodes = masses.shape[0]
    if turns(model) or nodes < 2 * ENDS:
        return solve_linearised(model, motion, masses, work)
    end = nodes - ENDS
    zero = 0.0 * motion.rate_factor
    nothing = ((zero, zero, zero), (zero, zero, zero))
    sweep = begin_assembly(model, motion, masses, work)
    sweep = assemble_nodes(model, motion, masses, work, 0, ENDS, sweep)
    done = eliminate_nodes(model, work, 0, ENDS, begin_elimination(zero))
    residual, band, _ = own_rows(zero)
    rows = NodeRows(residual, band, nowhere(), 0)
    for node in range(ENDS, end):
        sweep = add_node(model, motion, masses, work, node, 2, sweep, rows)
        done = eliminate_columns(work, node, rows, nothing, bordered(model), done)
    sweep = assemble_nodes(model, motion, masses, work, end, nodes, sweep)
    done = eliminate_nodes(model, work, end, nodes, done)
    return finish_solution(model, work, sweep, done)
