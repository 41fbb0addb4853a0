"""What holds the beam's ends: the contract that every frame fulfils.

A frame is a ``NamedTuple`` of dimensionless numbers. Its ``frame_dofs`` coordinates come first in
every state vector, the nodes follow. Nodes at clamps are slaves: the frame places them, condenses
their rows and columns of the band onto its own coordinates (the border), and leaves an identity
in their place, so that the banded solver runs over all nodes alike.
"""

from typing import Any, NamedTuple

from snapjump.number.dispatch import family_function


class FrameForces(NamedTuple):
    """What a frame reports of its own forces: a scale, its smallest gap, its fastest contact."""

    largest_force: Any
    smallest_gap: Any
    contact_rate_squared: Any


@family_function
def frame_dofs(frame: Any) -> Any:
    """Number of the frame's own coordinates, a constant while compiling."""


@family_function
def end_tangents(frame: Any, load: Any, angles: Any, state: Any, velocity: Any) -> Any:
    """The :class:`~snapjump.discretization.base.EndTangents` of a state and its velocity."""


@family_function
def place_ends(frame: Any, discretization: Any, angles: Any, state: Any) -> Any:
    """Put the slave nodes where the frame holds them."""


@family_function
def condense_first(
    frame: Any, tangents: Any, discretization: Any, hinge: Any, state: Any, system: Any
) -> Any:
    """Move the first node's rows and columns, and its hinge, onto the frame's coordinates."""


@family_function
def condense_last(
    frame: Any, tangents: Any, discretization: Any, hinge: Any, state: Any, system: Any
) -> Any:
    """Move the last node's rows and columns, and its hinge, onto the frame's coordinates."""


@family_function
def add_frame_forces(frame: Any, model: Any, motion: Any, work: Any) -> Any:
    """Add inertia, weight, contact and friction of the frame itself; return FrameForces."""


@family_function
def limit_frame_step(frame: Any, state: Any, drop: Any, fraction: Any) -> Any:
    """Share of ``state -= drop`` (at most 1) that leaves every corner ``fraction`` of its gap."""


@family_function
def corner_point(frame: Any, corner: Any, state: Any, velocity: Any) -> Any:
    """Place (x, y) of a corner of a moving frame (in L) and its velocity (in L/T)."""


@family_function
def corner_mass(frame: Any, corner: Any, state: Any) -> Any:
    """Mass (in rho A L) that a vertical push at a corner moves."""


@family_function
def frame_mass(frame: Any, coordinate: Any) -> Any:
    """Mass, mass or moment of inertia that belongs to one of the frame's own coordinates."""
