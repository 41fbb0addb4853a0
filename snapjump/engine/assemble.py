"""Residual and tangent of one stage: M A + grad V + damping + contact = 0.

Every integrator solves this problem, with v = (q - origin) rate_factor and
A = (v - drift) inertia_rate; a static equilibrium is the same with both rates 0.
"""

from typing import Any, NamedTuple

from snapjump.contact.base import Extremes
from snapjump.discretization.base import ROTARY_INERTIA, SKEW, NodeMotion
from snapjump.engine.points import add_frame_contacts, add_node_contact
from snapjump.frame.base import Rotations, body_acceleration
from snapjump.linear_solver.contact_rows import NodeRows, rows_of
from snapjump.number.dispatch import kernel, routine
from snapjump.number.functions import absolute, maximum


class Motion(NamedTuple):
    """Time of the stage (T), dv/dq and dA/dv (1/T), and the static anchor of x (EI/L^3)."""

    time: Any
    rate_factor: Any
    inertia_rate: Any
    anchor: Any


class Sweep(NamedTuple):
    """An assembly under way, node by node: what it needs at every node, and its extremes so far.

    tangents: of the clamps; chain: what the beam's sweep carries; left: its first hinge.
    """

    tangents: Any
    chain: Any
    left: Any
    extremes: Extremes


@kernel
def with_force(extremes: Extremes, force: Any) -> Extremes:
    """The extremes with one more force."""
    return Extremes(
        maximum(extremes.largest_force, force), extremes.smallest_gap, extremes.contact_rate_squared
    )


@kernel
def clear_border(work: Any, dofs: Any, node: Any, width: Any, zero: Any) -> None:
    """Zero the mounts' rows in the columns of a node of ``dofs`` coordinates."""
    for k in range(width):
        for i in range(dofs):
            work.border[dofs * node + i, k] = zero
            work.border_skew[dofs * node + i, k] = zero
            work.border_skew[dofs * node + i, k + 3] = zero


@kernel
def begin_node(model: Any, motion: Any, mass: Any, node: Any, work: Any, rows: NodeRows) -> Any:
    """Begin a node's own rows with inertia, damping and weight; returns the inertial force."""
    rate = motion.rate_factor
    i = model.discretization.node_dofs() * node + model.frame.dofs(work.mesh)
    vx = (work.state[i] - work.position_predictor[i]) * rate
    vy = (work.state[i + 1] - work.position_predictor[i + 1]) * rate
    ax = (vx - work.velocity_predictor[i]) * motion.inertia_rate
    ay = (vy - work.velocity_predictor[i + 1]) * motion.inertia_rate
    gain = motion.inertia_rate  # of the force over the mass, by the velocity
    force_x = ax
    force_y = ay
    if model.damping.drags():
        drag = model.damping.drag()
        gain = gain + drag
        force_x = force_x + drag * vx
        force_y = force_y + drag * vy
    diagonal = mass * (gain * rate)
    for axis in range(model.discretization.node_dofs()):
        for k in range(SKEW):
            rows.skew[axis, k] = 0.0
    along, across = body_acceleration(model, work)
    rows.residual[0] = mass * (force_x - along)
    rows.residual[1] = mass * (force_y - across)
    rows.band[0, 0] = diagonal
    rows.band[1, 0] = diagonal
    if model.discretization.node_dofs() == 3:
        turn_rate = (work.state[i + 2] - work.position_predictor[i + 2]) * rate
        spin = (turn_rate - work.velocity_predictor[i + 2]) * motion.inertia_rate
        torque = spin
        if model.damping.drags():
            torque = torque + model.damping.drag() * turn_rate
        rows.residual[2] = ROTARY_INERTIA * mass * torque
        rows.band[2, 0] = ROTARY_INERTIA * diagonal
    return mass * (absolute(ax) + absolute(ay))


@kernel
def chain_motion(model: Any, motion: Any, work: Any) -> NodeMotion:
    """The beam's nodes at the current iterate."""
    dofs = model.frame.dofs(work.mesh)
    return NodeMotion(work.state[dofs:], work.position_predictor[dofs:], motion.rate_factor)


@kernel
def begin_assembly(model: Any, motion: Any, masses: Any, work: Any) -> Sweep:
    """Start a sweep over the nodes: the frame's own forces, the clamps, the first edge."""
    mesh = work.mesh
    now = model.frame.mount_rotations(mesh, work.state, work.state)
    before = model.frame.mount_rotations(mesh, work.state, work.position_predictor)
    rotations = Rotations(
        (now.left - before.left) * motion.rate_factor,
        (now.right - before.right) * motion.rate_factor,
    )
    zero = 0.0 * motion.rate_factor
    inertial = model.frame.add_inertia(model, motion, work)
    extremes = Extremes(inertial, zero + 1.0e30, zero)
    if model.contact.exists():
        extremes = add_frame_contacts(model, motion, masses, work, extremes)
    elastic = model.frame.add_elasticity(model, motion, work)
    angles = model.clamp.angles(motion.time)
    tangents = model.frame.end_tangents(mesh, model.load, angles, work.state, rotations)
    nodes = chain_motion(model, motion, work)
    chain, left = model.discretization.begin_chain(model.damping, nodes, tangents)
    return Sweep(tangents, chain, left, with_force(extremes, elastic))


@kernel
def begin_again(model: Any, motion: Any, work: Any, sweep: Sweep) -> Sweep:
    """A sweep at the chain's beginning once more."""
    nodes = chain_motion(model, motion, work)
    chain, _ = model.discretization.begin_chain(model.damping, nodes, sweep.tangents)
    return Sweep(sweep.tangents, chain, sweep.left, sweep.extremes)


@kernel
def add_node(
    model: Any,
    motion: Any,
    masses: Any,
    work: Any,
    node: Any,
    following: Any,
    sweep: Sweep,
    rows: NodeRows,
) -> Sweep:
    """Write a node's own rows, not the last one's; ``following``: how many
    elements follow the one that leaves it, 2 standing for more."""
    mass = masses[node]
    inertial = begin_node(model, motion, mass, node, work, rows)
    extremes = with_force(sweep.extremes, inertial)
    if model.contact.exists():
        if mass > 0.0:
            extremes = add_node_contact(model, motion, mass, node, work, rows, extremes)
    chain = model.discretization.add_node_forces(
        model.damping,
        chain_motion(model, motion, work),
        sweep.tangents,
        sweep.chain,
        node,
        following,
        rows,
    )
    return Sweep(sweep.tangents, chain, sweep.left, extremes)


@kernel
def add_last_node(model: Any, motion: Any, masses: Any, work: Any, sweep: Sweep) -> Sweep:
    """Write the last node's rows."""
    per_node = model.discretization.node_dofs()
    node = masses.shape[0] - 1
    mass = masses[node]
    rows = rows_of(work, per_node * node)
    inertial = begin_node(model, motion, mass, node, work, rows)
    extremes = with_force(sweep.extremes, inertial)
    if model.contact.exists():
        if mass > 0.0:
            extremes = add_node_contact(model, motion, mass, node, work, rows, extremes)
    model.discretization.end_chain(sweep.chain, rows)
    force_x, force_y, moment = model.load.tip_load()
    rows.residual[0] -= force_x
    rows.residual[1] -= force_y
    if per_node == 3:
        rows.residual[2] -= moment / model.discretization.rotation_length()
    return Sweep(sweep.tangents, sweep.chain, sweep.left, extremes)


@routine
def assemble_nodes(
    model: Any, motion: Any, masses: Any, work: Any, first: Any, end: Any, sweep: Sweep
) -> Sweep:
    """Write the columns and residuals of nodes from ``first`` up to ``end``; the first and the last
    one of all move onto the frame.

    The border of a node is complete when the next two nodes have been assembled.
    """
    width = model.frame.border_width()
    per_node = model.discretization.node_dofs()
    last = masses.shape[0] - 1
    for node in range(first, end):
        if node < last:
            rows = rows_of(work, per_node * node)
            following = min(last - 1 - node, 2)
            sweep = add_node(model, motion, masses, work, node, following, sweep, rows)
        else:
            sweep = add_last_node(model, motion, masses, work, sweep)
        if width > 0:
            clear_border(work, per_node, node, width, 0.0 * motion.rate_factor)
        if model.discretization.has_elements():
            if node == 2:
                model.frame.condense_first(model, work, sweep.tangents, sweep.left)
            if node == last:
                nodes = chain_motion(model, motion, work)
                right = model.discretization.last_hinge(model.damping, nodes, sweep.tangents)
                model.frame.condense_last(model, work, sweep.tangents, right)
    return sweep


@kernel
def end_assembly(sweep: Sweep) -> Extremes:
    """The extremes of a finished sweep."""
    return with_force(sweep.extremes, sweep.chain.largest)


@kernel
def assemble(model: Any, motion: Any, masses: Any, work: Any) -> Extremes:
    """Fill the linear system at the current state; ``masses`` is zero at slave nodes."""
    sweep = begin_assembly(model, motion, masses, work)
    return end_assembly(assemble_nodes(model, motion, masses, work, 0, masses.shape[0], sweep))
