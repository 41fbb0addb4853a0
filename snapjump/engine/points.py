"""Points that can touch the ground: which they are, the forces on them, and their power.

Points are the beam's nodes, then the frame's own; a node without mass, which a clamp holds, has no
share of the contact force. What a law says of a gap (:mod:`snapjump.contact.base`) becomes the
force on a point here, and nowhere else.
"""

from typing import Any, NamedTuple

from snapjump.contact.base import ContactState, Extremes, force_if_active
from snapjump.linear_solver.contact_rows import NodeRows
from snapjump.number.dispatch import kernel, routine
from snapjump.number.functions import any_true, maximum, minimum, where


class Point(NamedTuple):
    """Gap (L) and velocity along and across the ground (L/T) of a point."""

    gap: Any
    vx: Any
    vy: Any


class Touch(NamedTuple):
    """A point within a step: now and at the step's beginning, the mass that a vertical push at it
    moves (rho A L), and its share of the law's force."""

    now: Point
    start: Point
    mass: Any
    share: Any


@kernel
def point_count(model: Any, masses: Any, mesh: Any) -> Any:
    """Number of points, those without a share included."""
    return masses.shape[0] + model.frame.contact_points(mesh)


@kernel
def point_at(model: Any, masses: Any, mesh: Any, point: Any, state: Any, velocity: Any) -> Point:
    """A point of a state that moves with a velocity."""
    nodes = masses.shape[0]
    if point < nodes:
        i = model.discretization.node_dofs() * point + model.frame.dofs(mesh)
        return Point(state[i + 1], velocity[i], velocity[i + 1])
    _, gap, vx, vy = model.frame.contact_point(mesh, point - nodes, state, velocity)
    return Point(gap, vx, vy)


@kernel
def share_of(model: Any, masses: Any, mesh: Any, point: Any) -> Any:
    """Factor of the law's force at a point, 0 where it cannot touch."""
    nodes = masses.shape[0]
    zero = 0.0 * model.ground.node_share
    if point < nodes:
        return model.ground.node_share if masses[point] > 0.0 else zero
    return model.frame.point_share(mesh, point - nodes, model.ground) + zero


@kernel
def touch_at(model: Any, masses: Any, work: Any, point: Any, state: Any, velocity: Any) -> Touch:
    """A point of a stage's state and velocity."""
    mesh = work.mesh
    nodes = masses.shape[0]
    mass = 0.0 * state[0]
    if point < nodes:
        mass = mass + masses[point]
    else:
        mass = mass + model.frame.point_mass(mesh, point - nodes, state)
    return Touch(
        point_at(model, masses, mesh, point, state, velocity),
        point_at(model, masses, mesh, point, work.start, work.velocity[0]),
        mass,
        share_of(model, masses, mesh, point),
    )


@kernel
def contact_state(motion: Any, touch: Touch) -> ContactState:
    """The contact state of a point, which a law is told besides its gap."""
    rate = motion.rate_factor
    start = touch.start
    return ContactState(
        touch.now.vy, rate, start.gap, start.vy, touch.mass * rate * motion.inertia_rate
    )


@kernel
def starting_state(start: Point) -> ContactState:
    """The same at the step's beginning."""
    zero = 0.0 * start.gap
    return ContactState(start.vy, zero, start.gap, start.vy, zero)


@kernel
def normal_force(model: Any, motion: Any, touch: Touch) -> Any:
    """Force of the ground at a point (EI/L^2), before its share."""
    _, force, _ = force_if_active(model.contact, touch.now.gap, contact_state(motion, touch))
    return force


@kernel
def friction_force(model: Any, motion: Any, touch: Touch) -> Any:
    """Friction against a point's sliding (EI/L^2), before its share; lagged friction is that of the
    step's beginning."""
    if model.friction.is_lagged():
        start = touch.start
        _, normal, _ = force_if_active(model.contact, start.gap, starting_state(start))
        return model.friction.ratio(start.vx) * normal
    return model.friction.ratio(touch.now.vx) * normal_force(model, motion, touch)


@kernel
def add_contact(
    model: Any, motion: Any, work: Any, point: Any, touch: Touch, rows: Any, extremes: Extremes
) -> Extremes:
    """Add contact and friction at a point to its rows of the linear system; returns the extremes
    with its own."""
    contact = model.contact
    friction = model.friction
    rate = motion.rate_factor
    gap = touch.now.gap
    state = contact_state(motion, touch)
    largest = extremes.largest_force
    fastest = extremes.contact_rate_squared
    if friction.exists() and friction.is_lagged():
        # Also where the point has lifted off since.
        if any_true(contact.active(touch.start.gap, starting_state(touch.start))):
            rows.drag(friction_force(model, motion, touch) * touch.share)
    active = contact.active(gap, state)
    if any_true(active):
        _, force, stiffness = force_if_active(contact, gap, state)
        force = force * touch.share
        stiffness = stiffness * touch.share
        largest = maximum(largest, force)
        fastest = maximum(fastest, contact.bounce_rate_squared(stiffness, touch.mass, state.speed))
        rows.push(force, stiffness)
        if friction.exists() and not friction.is_lagged():
            normal = force
            yielding = stiffness
            if contact.is_constraint():
                # The force of a constraint is known only once an iteration has held the point in
                # its place, and its stiffness is no derivative of what friction sees.
                normal = where(work.active_set[point] > 0.0, force, 0.0)
                yielding = 0.0 * stiffness
            velocity = touch.now.vx
            previous = work.sliding_velocity[point]
            ratio = friction.ratio(velocity)
            slope = friction.slope(velocity, previous)
            work.sliding_velocity[point] = where(active, velocity, previous)
            rows.drag(ratio * normal)
            rows.drag_slope(ratio * normal, normal * slope, ratio * yielding, rate)
    if contact.is_constraint():
        work.active_set[point] = where(active, 1.0, 0.0)
    return Extremes(largest, minimum(extremes.smallest_gap, gap), fastest)


@kernel
def add_node_contact(
    model: Any, motion: Any, mass: Any, node: Any, work: Any, rows: NodeRows, extremes: Extremes
) -> Extremes:
    """Add contact and friction at a node of the beam that carries a mass to its own rows."""
    i = model.discretization.node_dofs() * node + model.frame.dofs(work.mesh)
    rate = motion.rate_factor
    now = Point(
        work.state[i + 1],
        (work.state[i] - work.position_predictor[i]) * rate,
        (work.state[i + 1] - work.position_predictor[i + 1]) * rate,
    )
    start = Point(work.start[i + 1], work.velocity[0, i], work.velocity[0, i + 1])
    touch = Touch(now, start, mass, model.ground.node_share)
    return add_contact(model, motion, work, node, touch, rows, extremes)


@kernel
def add_frame_contacts(
    model: Any, motion: Any, masses: Any, work: Any, extremes: Extremes
) -> Extremes:
    """Add contact and friction at the frame's own points."""
    frame = model.frame
    mesh = work.mesh
    nodes = masses.shape[0]
    for k in range(frame.contact_points(mesh)):
        share = share_of(model, masses, mesh, nodes + k)
        if any_true(share > 0.0):
            gap, vx, vy = frame.stage_point(k, work, motion.rate_factor)
            touch = Touch(
                Point(gap, vx, vy),
                point_at(model, masses, mesh, nodes + k, work.start, work.velocity[0]),
                frame.point_mass(mesh, k, work.state),
                share,
            )
            rows = frame.contact_rows(k, work, motion.rate_factor)
            extremes = add_contact(model, motion, work, nodes + k, touch, rows, extremes)
    return extremes


@kernel
def ground_force(model: Any, motion: Any, masses: Any, work: Any, state: Any, velocity: Any) -> Any:
    """Sum of the normal forces at all points (EI/L^2)."""
    total = 0.0 * state[0]
    if model.contact.exists():
        for point in range(point_count(model, masses, work.mesh)):
            touch = touch_at(model, masses, work, point, state, velocity)
            if any_true(touch.share > 0.0):
                if any_true(model.contact.active(touch.now.gap, contact_state(motion, touch))):
                    total += touch.share * normal_force(model, motion, touch)
    return total


@routine
def contact_powers(
    model: Any, motion: Any, masses: Any, work: Any, state: Any, velocity: Any
) -> Any:
    """Powers that friction and the contact law take out (EI/(L T)), all points together."""
    friction = 0.0 * state[0]
    contact = 0.0 * state[0]
    for point in range(point_count(model, masses, work.mesh)):
        touch = touch_at(model, masses, work, point, state, velocity)
        if any_true(touch.share > 0.0):
            now = touch.now
            approach = contact_state(motion, touch)
            active = model.contact.active(now.gap, approach)
            gap = where(active, now.gap, model.contact.reach())
            lost = where(active, model.contact.loss(gap, approach), 0.0)
            contact = contact + lost * touch.share
            if model.friction.exists():
                rubbing = friction_force(model, motion, touch) * touch.share
                friction = friction + rubbing * now.vx
    return friction, contact
