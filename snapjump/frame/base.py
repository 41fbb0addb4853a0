"""Frames, which hold the beam's ends: the contract that every one fulfils.

A frame is a ``NamedTuple`` of dimensionless numbers. Its own coordinates come first in every
state vector, the nodes of the beam follow. Nodes at clamps are slaves: the frame places them,
condenses their rows and columns of the band onto the coordinates of its two mounts (the border),
and leaves an identity in their place, so that the banded solver runs over all nodes alike.

``mesh`` (int64) says how many coordinates the frame has and which of them are where; it is empty
for frames whose coordinates are fixed in number, and the same for all robots of a march.
"""

from math import nan
from typing import Any, ClassVar, NamedTuple

import numpy as np
from numpy.typing import NDArray

from snapjump.declare.fields import Part
from snapjump.linear_solver.contact_rows import NodeRows
from snapjump.number.dispatch import kernel
from snapjump.number.methods import Contract, required
from snapjump.number.nowhere import nowhere


class Rotations(NamedTuple):
    """Turning of the left and of the right mount: rates (rad/T), or increments (rad)."""

    left: Any
    right: Any


STILL = Rotations(0.0, 0.0)


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


class Frame(Contract):
    """Frames, which hold the beam's ends: the contract that every one fulfils."""

    def dofs(self, mesh: Any) -> Any:
        """Number of the frame's own coordinates; constant while compiling unless the mesh tells."""
        return 0

    def border_width(self) -> Any:
        """Coordinates of its mounts that the beam is condensed onto: 0, 3 or 6, while compiling."""
        return 0

    @required
    def end_tangents(
        self, mesh: Any, load: Any, angles: Any, state: Any, rotations: Rotations
    ) -> Any:
        """The :class:`~snapjump.discretization.base.EndTangents` of a state whose mounts turn."""

    def mount_rotations(self, mesh: Any, state: Any, vector: Any) -> Any:
        """Turning of the mounts when coordinates move by ``vector``, in which it is linear."""
        zero = 0.0 * state[0]
        return Rotations(zero, zero)

    def place_ends(self, mesh: Any, discretization: Any, angles: Any, state: Any) -> Any:
        """Put the slave nodes where the frame holds them."""

    def condense_first(self, model: Any, work: Any, tangents: Any, hinge: Any) -> Any:
        """Move the first node's rows and columns, and its hinge, onto the frame's coordinates."""

    def condense_last(self, model: Any, work: Any, tangents: Any, hinge: Any) -> Any:
        """Move the last node's rows and columns, and its hinge, onto the frame's coordinates."""

    def add_inertia(self, model: Any, motion: Any, work: Any) -> Any:
        """Write the frame's own inertia, drag and weight, before contact is added to them.

        They go to ``frame_residual`` and the frame's matrix; returns the largest force (EI/L^2).
        """
        return 0.0 * motion.rate_factor

    def add_elasticity(self, model: Any, motion: Any, work: Any) -> Any:
        """Add the frame's own elastic forces; returns the largest (EI/L^2)."""
        return 0.0 * motion.rate_factor

    def solve(self, work: Any, done: Any) -> Any:
        """Solve for the frame's coordinates once all nodes are eliminated (``done``).

        ``frame_residual`` becomes the solution. A border of other than three columns is moved to
        the nodes' right-hand side here; one of three is left to the substitution. Returns the
        number of pivots that are not positive.
        """
        return 0.0 * done.negative

    def contact_points(self, mesh: Any) -> Any:
        """Number of the frame's own points that can touch the ground."""
        return 0

    def contact_point(self, mesh: Any, point: Any, state: Any, velocity: Any) -> Any:
        """Place (x, y) of such a point (in L) and its velocity (in L/T)."""
        zero = 0.0 * state[0]
        return zero, zero, zero, zero

    def stage_point(self, point: Any, work: Any, rate: Any) -> Any:
        """Gap (L) of such a point at a stage's iterate and its velocity (L/T): that of the iterate
        less the predictor, times ``rate``."""
        zero = 0.0 * rate
        return zero, zero, zero

    def fall(self, mesh: Any, point: Any, state: Any, drop: Any) -> Any:
        """Gap (L) of such a point, and how far ``state -= drop`` lets it fall (L)."""
        zero = 0.0 * state[0]
        return zero, zero

    def contact_rows(self, point: Any, work: Any, rate: Any) -> Any:
        """The :class:`~snapjump.linear_solver.contact_rows.ContactRows` of such a point."""
        return NodeRows(work.frame_residual, work.corner_block, nowhere(), 0)

    def point_mass(self, mesh: Any, point: Any, state: Any) -> Any:
        """Mass (in rho A L) that a vertical push at such a point moves."""
        return 0.0

    def point_share(self, mesh: Any, point: Any, ground: Any) -> Any:
        """Factor of the contact force at such a point."""
        return 0.0

    def corner_point(self, mesh: Any, corner: Any, state: Any, velocity: Any) -> Any:
        """Place (x, y) of a corner of a moving frame (in L) and its velocity (in L/T): left foot,
        left top, right top, right foot."""
        zero = 0.0 * state[0]
        return zero, zero, zero, zero

    def box(self, mesh: Any, state: Any, velocity: Any) -> Any:
        """The :class:`FrameBox` of a moving frame."""
        zero = 0.0 * state[0]
        return FrameBox(zero, zero, zero, zero, zero, zero, zero, zero, zero)

    def rest(self, mesh: Any, state: Any, gap: Any) -> Any:
        """Put the frame upright, its feet at a gap (L) above the ground, so that the robot's centre
        of mass is near x = 0."""

    def rest_middle(self) -> Any:
        """Where the middle between its feet then is (L)."""
        return 0.0

    def mass_of(self, mesh: Any, coordinate: Any) -> Any:
        """Mass, or moment of inertia, that belongs to one of the frame's own coordinates."""
        return 0.0

    def whole_mass(self, mesh: Any) -> Any:
        """Mass of the frame (in rho A L): by default that of its first coordinate."""
        return self.mass_of(mesh, 0)

    def moments(self, mesh: Any, vector: Any) -> Any:
        """Sums of mass times x and of mass times y over the frame: of a state or of a velocity."""
        zero = 0.0 * vector[0]
        return zero, zero

    def rotation(self, mesh: Any, state: Any, velocity: Any, about: Any) -> Any:
        """Angular momentum and moment of inertia of the frame about a moving point: ``about`` is
        its place (x, y) and velocity (vx, vy). NaN, by default, leaves a robot's spin unknown."""
        unknown = nan + 0.0 * state[0]
        return unknown, unknown

    def slide(self, mesh: Any, vector: Any, along_x: Any) -> Any:
        """Add a displacement along x (or its rate) to the frame's coordinates."""

    def energy(self, mesh: Any, state: Any) -> Any:
        """Elastic energy of the frame (in EI/L)."""
        return 0.0 * state[0]

    def dissipation(self, damping: Any, mesh: Any, state: Any, velocity: Any) -> Any:
        """Power that material damping takes out of the frame (in EI/(L T))."""
        return 0.0 * state[0]


@kernel
def body_acceleration(model: Any, work: Any) -> Any:
    """Acceleration (x, y) that gravity and the air give every mass (in L/T^2)."""
    along = model.load.pull()
    across = -model.load.gravity()
    if model.drag.exists():
        along = along + work.air[0]
        across = across + work.air[1]
    return along, across


Mesh = NDArray[np.int64]
NO_MESH: Mesh = np.zeros(0, dtype=np.int64)


class Outline(NamedTuple):
    """Dimensions and masses that a frame is built from: leg, top, leg, and what is clamped to them.

    width, height; mount: height of the clamps above the feet (in L); mass: the robot's less the
    beam's, end: of the beam's nodes that move with one clamp (in rho A L); length_m: of L, mass_kg:
    of rho A L; stretching: the beam's EA (in EI/L^2); per_length: whether contact belongs to a
    length.
    """

    width: Any
    height: Any
    mount: Any
    mass: Any
    end: Any
    length_m: float = 1.0
    mass_kg: float = 1.0
    stretching: float = 0.0
    per_length: bool = True


class FrameOptions(Part):
    """A frame and its numbers."""

    group = "frame"
    flies: ClassVar[bool] = True
    held: ClassVar[bool] = False  # in space, for scenes without a flight
    explicit: ClassVar[bool] = True  # whether explicit steps lead anywhere
    takes_arrays: ClassVar[bool] = False  # whether many outlines make one body, all of one mesh
    inset_m = 0.0  # distance of the beam's ends from the legs

    @required
    def body(self, outline: Outline) -> Any:
        """The dimensionless frame: a member of :class:`Frame`."""

    @property
    def symmetric(self) -> bool:
        """Whether it is its own mirror image."""
        return True

    def mesh(self, body: Any) -> Mesh:
        """The mesh that goes with a body."""
        return NO_MESH
