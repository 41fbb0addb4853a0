"""A stage of an explicit scheme: forces at a known position, and the step that stays stable."""

from typing import Any

from snapjump.discretization.base import HALF_BANDWIDTH, ROTARY_INERTIA
from snapjump.engine.assemble import assemble
from snapjump.engine.clock import FASTEST, GAP, RESIDUAL, SHARE, STABLE_STEP, STEP
from snapjump.engine.newton import Correction
from snapjump.number.dispatch import kernel, routine
from snapjump.number.functions import absolute, maximum, negate, sqrt


@kernel
def slave_acceleration(work: Any, i: Any, step: Any) -> Any:
    """Of a coordinate that moves with a clamp, by how far it has been moved.

    The velocity that follows is half a step old, and an error of it is quartered at every step.
    With the one that ends the step, 2 (mean - v_0) / h - a_0, it would alternate for ever, and
    material damping hands it on to the frame, which moves the clamps.
    """
    mean_speed = (work.state[i] - work.start[i]) / step
    return 1.5 * (mean_speed - work.velocity[0, i]) / step - 0.5 * work.acceleration[0, i]


@kernel
def node_mass(mass: Any, axis: Any) -> Any:
    """Mass or rotary inertia that belongs to a coordinate of a node."""
    return ROTARY_INERTIA * mass if axis == 2 else mass


@kernel
def row_sum(work: Any, row: Any) -> Any:
    """Sum of absolute values of a node's row in the tangent (``row`` counts the padding)."""
    band = work.padded_band
    total = absolute(band[row, 0])
    for k in range(1, HALF_BANDWIDTH + 1):
        total = total + absolute(band[row, k]) + absolute(band[row - k, k])
    return total


@routine
def largest_rate_squared(model: Any, masses: Any, work: Any, zero: Any) -> Any:
    """Bound (Gershgorin) on the eigenvalues of M^-1 K (1/T^2); the frame being rigid."""
    dofs = model.frame.dofs(work.mesh)
    per_node = model.discretization.node_dofs()
    border = work.padded_border
    bound = zero
    for node in range(masses.shape[0]):
        if masses[node] == 0.0:
            continue
        for axis in range(per_node):
            row = HALF_BANDWIDTH + per_node * node + axis
            total = row_sum(work, row)
            for k in range(dofs):
                total = total + absolute(border[row, k])
            bound = maximum(bound, total / node_mass(masses[node], axis))
    for k in range(dofs):
        total = zero
        for m in range(dofs):
            total = total + absolute(work.corner_block[k, m])
        for row in range(border.shape[0]):
            total = total + absolute(border[row, k])
        bound = maximum(bound, total / model.frame.mass_of(work.mesh, k))
    return bound


@routine
def evaluate_forces(model: Any, motion: Any, masses: Any, work: Any, mask: Any) -> Correction:
    """Write the acceleration of every coordinate at the stage, and the stable step."""
    clock = work.clock
    dofs = model.frame.dofs(work.mesh)
    per_node = model.discretization.node_dofs()
    step = clock[STEP]
    extremes = assemble(model, motion, masses, work)
    acceleration = work.acceleration[1]
    total = 0.0 * step
    for k in range(dofs):
        acceleration[k] = -work.frame_residual[k] / model.frame.mass_of(work.mesh, k)
        total = total + absolute(acceleration[k])
    for node in range(masses.shape[0]):
        for axis in range(per_node):
            row = per_node * node + axis
            i = row + dofs
            if masses[node] > 0.0:
                acceleration[i] = -work.residual[row] / node_mass(masses[node], axis)
            else:
                acceleration[i] = slave_acceleration(work, i, step)
            total = total + absolute(acceleration[i])
    rate_squared = largest_rate_squared(model, masses, work, 0.0 * step)
    clock[STABLE_STEP] = 2.0 / sqrt(maximum(rate_squared, 1e-300 + 0.0 * step))
    clock[GAP] = extremes.smallest_gap
    clock[FASTEST] = extremes.contact_rate_squared
    clock[RESIDUAL] = 0.0 * step
    sound = (total < 1e300) & (clock[SHARE] >= 1.0)
    return Correction(mask & sound, mask & negate(sound), 0.0 * step)
