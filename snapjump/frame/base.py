"""What holds the beam's ends: the contract that every frame fulfils.

A frame is a ``NamedTuple`` of dimensionless numbers. Its own coordinates come first in every
state vector, the nodes of the beam follow. Nodes at clamps are slaves: the frame places them,
condenses their rows and columns of the band onto the coordinates of its two mounts (the border),
and leaves an identity in their place, so that the banded solver runs over all nodes alike.

``mesh`` (int64) says how many coordinates the frame has and which of them are where; it is empty
for frames whose coordinates are fixed in number, and the same for all robots of a march.
"""

from typing import Any, NamedTuple

from snapjump.number.dispatch import family_function


class FrameForces(NamedTuple):
    """What a frame reports of its own forces: a scale, its smallest gap, its fastest contact."""

    largest_force: Any
    smallest_gap: Any
    contact_rate_squared: Any


class Turning(NamedTuple):
    """Turning of the left and of the right mount: rates (rad/T), or increments (rad)."""

    left: Any
    right: Any


STILL = Turning(0.0, 0.0)


class FrameBox(NamedTuple):
    """Where a frame is: a point of it (L), cosine and sine of its direction, its turning rate
    (rad/T), half its width, and the heights of mounts, feet and top above the point when it
    stands upright (L)."""

    x: Any
    y: Any
    cosine: Any
    sine: Any
    turn_rate: Any
    half_span: Any
    mount_y: Any
    foot_y: Any
    top_y: Any


@family_function
def frame_dofs(frame: Any, mesh: Any) -> Any:
    """Number of the frame's own coordinates; a constant while compiling unless the mesh tells."""


@family_function
def border_width(frame: Any) -> Any:
    """Coordinates of its mounts that the beam is condensed onto: 0, 3 or 6, while compiling."""


@family_function
def end_tangents(
    frame: Any, mesh: Any, load: Any, angles: Any, state: Any, turning: Turning
) -> Any:
    """The :class:`~snapjump.discretization.base.EndTangents` of a state whose mounts turn."""


@family_function
def mount_turning(frame: Any, mesh: Any, state: Any, vector: Any) -> Any:
    """Turning of the mounts when every coordinate moves by ``vector`` (in which it is linear)."""


@family_function
def place_ends(frame: Any, mesh: Any, discretization: Any, angles: Any, state: Any) -> Any:
    """Put the slave nodes where the frame holds them."""


@family_function
def condense_first(
    frame: Any,
    mesh: Any,
    tangents: Any,
    discretization: Any,
    hinge: Any,
    state: Any,
    system: Any,
) -> Any:
    """Move the first node's rows and columns, and its hinge, onto the frame's coordinates."""


@family_function
def condense_last(
    frame: Any,
    mesh: Any,
    tangents: Any,
    discretization: Any,
    hinge: Any,
    state: Any,
    system: Any,
) -> Any:
    """Move the last node's rows and columns, and its hinge, onto the frame's coordinates."""


@family_function
def add_frame_forces(frame: Any, model: Any, motion: Any, work: Any) -> Any:
    """Write inertia, weight, elasticity, contact and friction of the frame itself.

    They go to ``frame_residual`` and the frame's matrix; returns FrameForces.
    """


@family_function
def solve_frame(frame: Any, mesh: Any, state: Any, system: Any, done: Any) -> Any:
    """Solve for the frame's coordinates once all nodes are eliminated (``done``).

    ``frame_residual`` becomes the solution. A border of other than three columns is moved to the
    nodes' right-hand side here; one of three is left to the substitution. Returns the number of
    pivots that are not positive.
    """


@family_function
def limit_frame_step(frame: Any, mesh: Any, state: Any, drop: Any, fraction: Any) -> Any:
    """Share of ``state -= drop`` (at most 1) that leaves every point ``fraction`` of its gap."""


@family_function
def contact_points(frame: Any, mesh: Any) -> Any:
    """Number of the frame's own points that can touch the ground."""


@family_function
def contact_point(frame: Any, mesh: Any, point: Any, state: Any, velocity: Any) -> Any:
    """Place (x, y) of such a point (in L) and its velocity (in L/T)."""


@family_function
def point_mass(frame: Any, mesh: Any, point: Any, state: Any) -> Any:
    """Mass (in rho A L) that a vertical push at such a point moves."""


@family_function
def point_weight(frame: Any, mesh: Any, point: Any, contact: Any) -> Any:
    """Factor of the contact force at such a point."""


@family_function
def corner_point(frame: Any, mesh: Any, corner: Any, state: Any, velocity: Any) -> Any:
    """Place (x, y) of a corner of a moving frame (in L) and its velocity (in L/T): left foot,
    left top, right top, right foot."""


@family_function
def frame_box(frame: Any, mesh: Any, state: Any, velocity: Any) -> Any:
    """The :class:`FrameBox` of a moving frame."""


@family_function
def rest_frame(frame: Any, mesh: Any, state: Any, gap: Any) -> Any:
    """Put the frame upright about x = 0, its feet at a gap (L) above the ground."""


@family_function
def frame_mass(frame: Any, mesh: Any, coordinate: Any) -> Any:
    """Mass, or moment of inertia, that belongs to one of the frame's own coordinates."""


@family_function
def frame_moments(frame: Any, mesh: Any, vector: Any) -> Any:
    """Sums of mass times x and of mass times y over the frame: of a state or of a velocity."""


@family_function
def slide_frame(frame: Any, mesh: Any, vector: Any, along_x: Any) -> Any:
    """Add a displacement along x (or its rate) to the frame's coordinates."""


@family_function
def frame_energy(frame: Any, mesh: Any, state: Any) -> Any:
    """Elastic energy of the frame (in EI/L)."""


@family_function
def frame_dissipation(frame: Any, damping: Any, mesh: Any, state: Any, velocity: Any) -> Any:
    """Power that material damping takes out of the frame (in EI/(L T))."""
